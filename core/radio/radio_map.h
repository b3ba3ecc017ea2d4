// Maps: what radio waves come to in each cell of a rectangle.
#pragma once

#include <string>
#include <vector>

#include "core/radio/map_question.h"
#include "core/radio/radio_search.h"
#include "core/scene/scene.h"

namespace tia {

/// RadioMap: row by row, row 0 first.
struct RadioMap {
  MapGrid grid;
  std::vector<double> values;        ///< in the quantity's unit; NaN where there is none
  std::vector<std::uint8_t> inside;  ///< whether a cell's centre is in a body, or on one
  /// Where the plane cuts flat bodies: x, y, x, y in cells from the map's corner.
  std::vector<std::array<double, 4>> walls;
  std::size_t transmitters = 1;
  PathCounts counts;
};

/// MapLimits: what one map may take.
struct MapLimits : RadioLimits {
  std::int64_t max_cells = 16'777'216;
};

/// Each cell tells what radio_paths does of a receiver at its centre, isotropic and of the
/// transmitter's polarisation, to the bit; the same map whoever works.
/// Errors: InputError: as radio_paths; of a map without a place or with too many cells; Stopped.
RadioMap radio_map(const Scene& scene, const RadioMapQuestion& question,
                   const MapLimits& limits = {}, const Workers& workers = {});

/// The cells that radio_map would tell of. Errors: the same.
MapGrid grid_of(const Scene& scene, const RadioMapQuestion& question, const MapLimits& limits = {});

/// Of what the values are: "dB".
std::string_view unit_of(MapQuantity quantity);

/// What is asked of the paths to the centre of a cell. Domain: a cell of the grid.
RadioQuestion paths_question(const RadioMapQuestion& question, const MapGrid& grid, int column,
                             int row);

/// {"width", "height", "area", "cell", "y", "quantity", "unit", "values"}; of other planes
/// "origin", "u" and "v" instead of "area" and "y".
Value radio_map_json(const RadioMapQuestion& question, const RadioMap& map);
Value radio_map_schema();

}  // namespace tia
