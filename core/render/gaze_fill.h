// How pixels beside the fovea are filled from the rings' rays.
#pragma once

#include <array>
#include <vector>

#include "core/film/image.h"
#include "core/render/gaze_rings.h"

namespace tia {

/// GazeSample: what a ring's ray, or several beside it, have come to: light and alpha.
struct alignas(16) GazeSample {
  std::array<float, 4> numbers;
};

/// GazeFilling: what pixels are filled from.
struct GazeFilling {
  const GazeFrame& frame;
  const GazeFovea& fovea;
  const GazeRings& rings;
  const std::vector<GazeSample>& samples;  ///< by slot
  double slope;
  bool nearest;  ///< by the nearest ray alone, as numbers must be that have no mean
};

/// Fills the pixels of a tile that are not of the fovea: linear in the eccentricity and the angle
/// around the gaze. `x0`, `y0`: the place of the window in the picture.
void fill_from_rings(const GazeFilling& from, int x0, int y0, FilmTile& tile);

}  // namespace tia
