// The layers that come of a pixel's own samples, as planes.
#pragma once

#include <vector>

#include "core/render/trace_tile.h"

namespace tia {

/// Those of a tile whose samples are there: of each layer but rgba and other integrators', in the
/// order of the list. Shape: as FilmTile::more.
std::vector<float> planes_of(const TilePixels& tile, LayerSet layers);

}  // namespace tia
