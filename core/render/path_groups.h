// By which ways light has come to a pixel: the light of its paths, told apart by their light path
// expressions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/integrators/path_record.h"
#include "core/render/estimate.h"

namespace tia {

/// The most letters of a light path expression; longer ones are all `longer_paths`.
/// Source: Heckbert, "Adaptive radiosity textures for bidirectional ray tracing" (1990), from the
/// eye's side and without its E, which here is what emits.
inline constexpr std::size_t longest_expression = 6;
inline constexpr const char* longer_paths = "*E";

/// Calls f(vertex, light, expression) for all light that a path has been given, in the order in
/// which it is added: "DSE" came from what emits by a mirror and a matt surface.
template <class F>
void for_each_light(const PathRecord& path, F f) {
  std::string before;  // the letters of the vertices that it has come by
  for (const PathVertex& vertex : path.vertices) {
    for (const GatheredLight& light : vertex.lights) {
      std::string expression = before;
      if (light.asked) expression += letter_of(light.event);
      expression += 'E';
      f(vertex, light, expression.size() > longest_expression ? longer_paths : expression);
    }
    if (vertex.event) before += letter_of(*vertex.event);
  }
}

/// PathGroup: the light of all paths that came by ways of one expression.
struct PathGroup {
  std::string expression;
  Vec3d mean{}, error{};  ///< over all paths; the standard error as of independent ones
  /// Of the luminance of all; of few paths of single wavelengths it may be negative, or above 1.
  double share = 0;
  int paths = 0;  ///< how many of the paths have such light
};

/// PathGroups: sums over a pixel's paths.
class PathGroups {
 public:
  void add(const PathRecord& path);
  int count() const { return all_.count; }
  /// As the picture has it, bit for bit.
  Vec3f mean() const { return all_.mean(); }
  /// The greatest share first.
  std::vector<PathGroup> groups() const;

 private:
  struct Sums {
    Vec3d of_path{}, light{}, squares{};
    int paths = 0;
  };
  Estimate all_;
  std::map<std::string, Sums> sums_;
};

}  // namespace tia
