// From a sequence of facets to the path that is mirrored in them, and whether it is free.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/radio/radio_path.h"
#include "core/radio/radio_world.h"

namespace tia {

/// The points at which a path is mirrored in facets one after the other, found back from the
/// receiver. `images`: the transmitter's after each mirror. Domain: as many images as facets.
/// Returns: the path, with reflections alone; none where a point is beside its facet, or the path
/// is on the wrong side of one.
std::optional<RadioPath> mirrored_path(const RadioWorld& world, const Vec3d& from, const Vec3d& to,
                                       std::span<const int> facets, std::span<const Vec3d> images);

/// Whether the path's legs are free, or go through at most so many walls, which are then added to
/// its interactions. A wall is a sheet, or a closed body from where it is entered to where it is
/// left.
bool is_free(const RadioWorld& world, RadioPath& path, std::span<const int> facets,
             int max_transmissions);

/// The transmitter mirrored in the facets, one after the other.
std::vector<Vec3d> images_of(const RadioWorld& world, const Vec3d& from,
                             std::span<const int> facets);

/// Which side of a facet is the one that waves come from and go to: 1 that of its normal, -1 the
/// other, of an open facet; 0: none, for the point is on it, or behind a closed one.
int side_of(const RadioWorld& world, const Facet& facet, const Vec3d& source);

}  // namespace tia
