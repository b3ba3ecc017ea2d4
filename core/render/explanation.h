// What an explanation of a pixel or of a ray tells.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/accel/world/all_hits.h"
#include "core/integrators/ray_tree.h"
#include "core/scene/labels.h"

namespace tia {

/// ExplainedView: of a picture that has several, the one that the pixel is of, and where in it.
struct ExplainedView {
  int number = 0;
  std::string name;
  int x = 0, y = 0;
};

/// ExplainedPixel: one sample of one pixel of a picture.
struct ExplainedPixel {
  int x = 0, y = 0, sample = 0;
  Vec2d raster{}, ndc{}, screen{};         ///< where its ray goes through: in pixels, [0,1], [-1,1]
  std::optional<ExplainedView> view = {};  ///< whose those are, then
};

/// Note: what a part of the scene, by its JSON Pointer, is not as it may be thought to be.
struct Note {
  std::string pointer, about;
};

/// Explanation. Space/units: the scene's, the tree's rays and points in the world's; the ray's
/// direction is unit.
struct Explanation {
  World world;
  std::vector<ObjectLabel> labels;  ///< of the world's objects
  std::optional<ExplainedPixel> pixel;
  Ray<double> ray;
  std::vector<Meeting> hits;              ///< all along the ray, the nearest first
  std::unique_ptr<RayNode> tree;          ///< null where paths are told instead (explain_paths.h)
  std::map<int, std::string> pointers{};  ///< into the scene, of all objects that are told of
  std::vector<Note> notes{};
  std::size_t most_bytes = 0;  ///< an upper bound of its JSON's length
};

}  // namespace tia
