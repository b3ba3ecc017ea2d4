// The image method: a transmitter is mirrored in each facet of a sequence, and the path found back
// from the receiver.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/radio/radio_beam.h"
#include "core/radio/radio_path.h"
#include "core/radio/radio_world.h"

namespace tia {

/// PathCounts: what finding paths took. Sums over the pairs of one request.
struct PathCounts {
  std::int64_t rays = 0, images = 0, candidates = 0, blocked = 0, doubles = 0;
  PathCounts& operator+=(const PathCounts& other);
};

/// PathSearch: which paths are looked for, from one transmitter.
struct PathSearch {
  Vec3d from{};
  std::vector<Vec3d> to{};
  int max_reflections = 3, max_transmissions = 0, max_diffractions = 0;
  std::int64_t most_images = 0;  ///< of this search
  std::int64_t most_paths = 1 << 20;
  bool pruned = true;  ///< whether what an image cannot see is left out: the same paths
};

/// PathsTo: of one search, by receiver, sorted (comes_before), without gains.
struct PathsTo {
  std::vector<std::vector<RadioPath>> by_receiver;
  PathCounts counts;
};

/// All paths of at most max_reflections mirrors in flat facets.
/// Source: Allen, Berkley, "Image method for efficiently simulating small-room acoustics", JASA 65
/// (1979); with hidden images: Borish, "Extension of the image model to arbitrary polyhedra", JASA
/// 75 (1984). Cost: images: as many as the tree has nodes.
/// Errors: InputError (limit) of more images than most_images; Stopped.
PathsTo paths_by_images(const RadioWorld& world, const PathSearch& search, const Workers& workers);

/// ImageNode: a sequence of facets, and where what was mirrored in them goes.
struct ImageNode {
  std::vector<int> facets;
  RadioBeam beam;
};
/// The nodes of a search's tree, in the order in which paths_by_images tries them. Adds their count
/// to `counts`. Errors: the same.
std::vector<ImageNode> image_nodes(const RadioWorld& world, const PathSearch& search,
                                   const Workers& workers, PathCounts& counts);
/// The same of sequences that rays took; of one that sees nothing there is none. `slack`: how far
/// beside its faces each still goes.
std::optional<ImageNode> image_node(const RadioWorld& world, const Vec3d& from,
                                    const std::vector<int>& facets, double slack);

/// What a search for more images is refused with.
InputError too_many_images(const PathSearch& search);
/// Errors: InputError (limit) where a search has found more paths than its most_paths.
void check_paths(const PathSearch& search, std::size_t count);

/// Sorts paths and leaves out those that are the same points again, as coplanar facets that overlap
/// make them. Returns: how many were left out.
std::int64_t sort_paths(std::vector<RadioPath>& paths, double slack);

}  // namespace tia
