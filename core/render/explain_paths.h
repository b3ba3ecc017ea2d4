// Explanations of pixels by the paths of their light: as the picture traces them, one by one, and
// by which ways their light has come.
#pragma once

#include <stop_token>

#include "core/input/object_schema.h"
#include "core/render/explanation.h"
#include "core/render/path_groups.h"
#include "core/render/render.h"
#include "core/scene/view.h"

namespace tia {

/// WhichPaths: those that are told one by one.
struct WhichPaths {
  int first = 0, count = 16;
};

/// ExplainedPath: that of one sample. Its rays and points are the world's.
struct ExplainedPath {
  int sample = 0;
  PathRecord path;
};

/// PathExplanation: what makes the light of a pixel, or of a ray: the mean of options.samples
/// paths.
struct PathExplanation {
  Explanation ray;  ///< of the first path that is told: all but the tree
  /// Sample s is of number s mod their count. Their objects have the same numbers.
  std::vector<World> worlds;
  int count = 0;
  Vec3f mean{};  ///< the pixel of a picture that stops at no noise, bit for bit
  std::vector<PathGroup> groups{};
  std::vector<PathSurface> surfaces{};
  std::vector<ExplainedPath> paths{};
};

/// A ray that belongs to no picture. Domain: the scene's world; a unit direction; the integrator
/// path; `which` within the samples. Errors: InputError (limit) as explain(), and of more rays or
/// work than the options allow; Stopped.
PathExplanation explain_paths(const Scene& scene, World world, const Ray<double>& ray,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop = {});
/// SeenWorlds: those of a picture's strata of time, and how each is seen, in the scene's space.
struct SeenWorlds {
  std::vector<World> worlds;
  std::vector<View> views;
};
/// A pixel of such a picture; each path's colour is its sample's, bit for bit. Domain: as above;
/// options.blur_steps worlds of the same objects (object_labels). Errors: as above.
PathExplanation explain_paths(const Scene& scene, SeenWorlds seen, int x, int y,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop = {});
/// The same of one time.
inline PathExplanation explain_paths(const Scene& scene, World world, const View& view, int x,
                                     int y, const WhichPaths& which, const RenderOptions& options,
                                     const std::stop_token& stop = {}) {
  return explain_paths(scene, SeenWorlds{{std::move(world)}, {view}}, x, y, which, options, stop);
}

/// As explain.h says, but in place of "tree": "count", "mean", "groups": [{"expression", "mean",
/// "error", "share", "paths"}], "over": [{"object", "id" and the same}] and "samples": [{"sample",
/// "color", "end", "vertices"}].
Value::Object value_of(const PathExplanation& explanation);
/// The schema of those members.
std::vector<SchemaMember> paths_schema(Definitions& named);

}  // namespace tia
