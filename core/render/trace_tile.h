// Traces one tile of a picture, in any of the three scalars.
#pragma once

#include <algorithm>

#include "core/film/image.h"
#include "core/render/estimate.h"
#include "core/render/instant.h"
#include "core/render/layers.h"
#include "core/render/meter.h"
#include "core/render/sampler.h"
#include "core/render/target.h"

namespace tia {

/// The arithmetic of a render: `wide` is what pictures are made with, `narrow` gives the same bytes
/// one ray at a time, `exact` traces in double, for tests and explanations.
enum class Scalar { wide, narrow, exact };

/// What all tiles of a picture share.
struct Shot {
  Instants instants;  ///< views in their worlds' spaces
  IntegratorName integrator;
  Rules rules;
  const Sampler& sampler;
  const Convergence& convergence;
  RayMeter& meter;
  LayerSet layers = {};  ///< what is to be known besides the light
  bool guided = false;   ///< whether pixels' guides are summed, too

  /// What a picture of one time is of, else of the first stratum.
  const Instant& first() const { return instants.front(); }
  bool has_lens() const {
    return std::ranges::any_of(instants, [](const Instant& at) { return at.view.has_lens(); });
  }
  bool parts_light() const {
    return layers.any([](const LayerRow& row) { return row.of_paths; });
  }
  bool watches() const { return convergence.watches() || layers.has(Layer::variance); }
};

/// TilePixels: a tile of a picture whose pixels take samples by rounds. Shape: row by row, and
/// nothing before the first round: a large picture's sums take seconds to make.
struct TilePixels {
  int x0 = 0, y0 = 0;  ///< the corner's place in the picture
  int width = 0, height = 0;
  bool has_parts = false, has_guides = false;
  std::vector<Estimate> estimates = {};
  std::vector<PartSums> parts = {};     ///< where they are asked for, else none
  std::vector<GuidedSums> guided = {};  ///< the same
  std::vector<int> unsettled = {};      ///< the numbers of those that need more samples
  RayCounts rays = {};                  ///< that its whole rounds have taken
  float error = 1;                      ///< the largest of its pixels, where errors are shown
  std::vector<Target> targets = {};     ///< where its pixels are none of the view's
  double spread = 0;                    ///< of those: how wide a ray sees (PixelCone)

  /// Makes what a first round needs, where there is nothing yet.
  void begin();
};

/// Traces rounds first .. last - 1 of the tile's unsettled pixels, and counts their rays.
/// Errors: the meter's.
void trace_rounds(const Shot& shot, Scalar scalar, int first, int last, TilePixels& tile);

/// Fills a tile whose pixels have one ray each, through their centres, and counts them.
/// Domain: one instant, a centred sampler and no orthographic view. Errors: the
/// meter's.
void trace_centers(const Shot& shot, Scalar scalar, int x0, int y0, FilmTile& tile);

}  // namespace tia
