// Shooting and bouncing rays: directions are launched from the transmitter, traced from mirror to
// mirror, and received by a ball around the receiver.
#pragma once

#include <compare>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/radio/images.h"

namespace tia {

/// RadioMirror: what a ray was mirrored in: a facet, or (facet -1) a curved body's element.
struct RadioMirror {
  int facet = -1, body = 0, element = 0;
  auto operator<=>(const RadioMirror&) const = default;
};
using MirrorSequence = std::vector<RadioMirror>;

/// Direction i of n on the sphere: equal areas between heights, turned by the golden angle.
/// Source: Swinbank, Purser, "Fibonacci grids", Q. J. R. Meteorol. Soc. 132 (2006).
Vec3d launch_direction(std::int64_t i, std::int64_t n);
/// The mean angle between neighbours: the root of 4 pi / n, radians.
double launch_angle(std::int64_t n);

/// LaunchedRay: a ray that a receiver's ball was met by.
struct LaunchedRay {
  Vec3d direction{};
  double miss = 0;  ///< how far it passes the receiver, over its length
  RadioPath path;   ///< reflections alone; its length is up to where it passes
};
/// By receiver and sequence: of flat sequences the ray that passes nearest; of others the nearest
/// of each bundle, for a curved mirror may send several.
using LaunchedRays = std::map<std::pair<std::size_t, MirrorSequence>, std::vector<LaunchedRay>>;

/// Launched: what met the receivers' balls, of radius alpha L / sqrt 3, and which flat sequences
/// there are at all. Curved mirrors spread rays: of theirs, all that pass within half a radian are
/// in `rays`. Source: Schaubach, Davis, Rappaport, "A ray tracing method for predicting path loss
/// and delay spread", VTC 1992.
struct Launched {
  LaunchedRays rays;
  std::set<std::vector<int>> sequences;  ///< facets, the empty one included
  std::int64_t doubles = 0;              ///< rays beyond the first of their sequence
};
Launched launch(const RadioWorld& world, const PathSearch& search, std::int64_t rays,
                const Workers& workers);

/// The paths of rays as they were traced (`sbr`), or corrected (`hybrid`): each flat sequence that
/// any ray took is tried on all receivers by images, so that none must pass near; rays by way of
/// curved mirrors are aimed by Newton's steps on Fermat's principle.
/// Errors: InputError (limit) of more images than search.most_images; Stopped.
PathsTo paths_by_rays(const RadioWorld& world, const PathSearch& search, std::int64_t rays,
                      bool corrected, const Workers& workers);

}  // namespace tia
