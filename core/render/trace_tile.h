// Traces one tile of a picture, in any of the three scalars.
#pragma once

#include "core/film/image.h"
#include "core/render/meter.h"
#include "core/render/sampler.h"

namespace tia {

/// The arithmetic of a render: `wide` is what pictures are made with, `narrow` gives the same bytes
/// one ray at a time, `exact` traces in double, for tests and explanations.
enum class Scalar { wide, narrow, exact };

/// What all tiles of a picture share.
struct Shot {
  const World& world;
  const View& view;  ///< in world space
  IntegratorName integrator;
  Rules rules;
  const Sampler& sampler;
  RayMeter& meter;
};

/// Fills the tile's pixels, whose corner is pixel (x0, y0) of the picture, and counts their rays.
/// Errors: the meter's.
void trace_tile(const Shot& shot, Scalar scalar, int x0, int y0, FilmTile& tile);

}  // namespace tia
