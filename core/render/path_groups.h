// By which ways light has come to a pixel: the light of its paths, told apart by their light path
// expressions, and by the things that it came over.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/accel/world/world.h"
#include "core/integrators/path_record.h"
#include "core/render/estimate.h"

namespace tia {

/// The most letters of a light path expression; longer ones are all `longer_paths`.
/// Source: Heckbert, "Adaptive radiosity textures for bidirectional ray tracing" (1990), from the
/// eye's side and without its E, which here is what emits.
inline constexpr std::size_t longest_expression = 6;
inline constexpr const char* longer_paths = "*E";

/// What a vertex beyond the first sends on as `event` came over: its surface's primitive; -1: fog;
/// none: it only let the light through.
inline std::optional<int> sent_over(const PathVertex& vertex, PathEvent event) {
  if (event == PathEvent::transmitted) return std::nullopt;
  return event == PathEvent::volume ? -1 : static_cast<int>(vertex.hit.primitive);
}

/// Calls f(vertex, light, expression, over) for all light that a path has been given, in the order
/// in which it is added: "DSE" came from what emits by a mirror and a matt surface. `over` is the
/// primitive by which it came to the first vertex: the nearest beyond that which did more than let
/// it through; -1: none.
template <class F>
void for_each_light(const PathRecord& path, F f) {
  std::string before;       // the letters of the vertices that it has come by
  std::optional<int> over;  // the first of them, beyond the path's own first
  for (const PathVertex& vertex : path.vertices) {
    const bool beyond = !before.empty() && !over;
    for (const GatheredLight& light : vertex.lights) {
      std::string expression = before;
      if (light.asked) expression += letter_of(light.event);
      expression += 'E';
      const auto by = beyond && light.asked ? sent_over(vertex, light.event) : over;
      f(vertex, light, expression.size() > longest_expression ? longer_paths : expression,
        by.value_or(-1));
    }
    if (beyond && vertex.event) over = sent_over(vertex, *vertex.event);
    if (vertex.event) before += letter_of(*vertex.event);
  }
}

/// PathShare: a part of the light of all paths.
struct PathShare {
  Vec3d mean{}, error{};  ///< over all paths; the standard error as of independent ones
  /// Of the luminance of all; of few paths of single wavelengths it may be negative, or above 1.
  double share = 0;
  int paths = 0;  ///< how many of the paths have such light
};
/// PathGroup: what came by ways of one expression.
struct PathGroup : PathShare {
  std::string expression{};
};
/// PathSurface: what came to the first thing that is met over further surfaces of one object.
struct PathSurface : PathShare {
  int object = -1;  ///< its number in the world
};
/// The most of them that are told.
inline constexpr std::size_t most_surfaces = 16;

/// PathGroups: sums over a pixel's paths.
class PathGroups {
 public:
  /// Domain: a path of that world; of all worlds that are given the objects have the same numbers.
  void add(const PathRecord& path, const World& world);
  int count() const { return all_.count; }
  /// As the picture has it, bit for bit.
  Vec3f mean() const { return all_.mean(); }
  /// The greatest share first.
  std::vector<PathGroup> groups() const;
  /// Likewise, most_surfaces at most.
  std::vector<PathSurface> surfaces() const;

 private:
  struct Sums {
    Vec3d of_path{}, light{}, squares{};
    int paths = 0;
    void end_path();
  };
  PathShare share_of(const Sums& sums) const;

  Estimate all_;
  std::map<std::string, Sums> sums_;
  std::map<int, Sums> over_;  // by object
};

}  // namespace tia
