// What one transmitter comes to in the cells of a map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/radio/map_question.h"
#include "core/radio/radio_search.h"

namespace tia {

/// Whether each cell's centre is in a body, or on its surface.
std::vector<std::uint8_t> cells_inside(const RadioWorld& world, const MapGrid& grid,
                                       const Workers& workers);

/// Where the plane cuts flat bodies: lines x, y, x, y in cells from the map's corner.
std::vector<std::array<double, 4>> walls_in(const RadioWorld& world, const MapGrid& grid);

/// SenderCells: of one transmitter, by cell; NaN where no path is.
struct SenderCells {
  std::vector<double> gain_db, delay_spread_s;
};

/// MapSearch: what all transmitters' cells are found by.
struct MapSearch {
  const RadioWorld& world;
  const RadioMapQuestion& question;
  const MapGrid& grid;
  const std::vector<std::uint8_t>& inside;  ///< cells that are left out
  const RadioLimits& limits;
};
/// Adds what it took to `counts`; images are those that cells try, too.
/// Errors: InputError (limit); Stopped.
SenderCells received_of(const Antenna& sender, const MapSearch& search, const Workers& workers,
                        PathCounts& counts);

}  // namespace tia
