// A map as a picture: colours, contours, walls and a legend.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/film/image.h"
#include "core/radio/radio_map.h"

namespace tia {

/// MapLook: how a map is drawn.
struct MapLook {
  int scale = 4;                                    ///< pixels of a cell's side
  bool legend = true;                               ///< at the right of the map
  std::optional<std::array<double, 2>> range = {};  ///< what the legend spans, in the unit
};

/// MapScale: the legend's numbers, in the unit that it writes.
struct MapScale {
  double low = 0, high = 1;  ///< at the ends of the colours
  double step = 1;           ///< between numbers
  double unit = 1;           ///< what the legend's unit is in the map's: nanoseconds 1e-9
  std::string_view name = "dB";
};
/// Of decibels whole threes around the values, at most 90 below the highest; of delays from 0.
/// Its ends are the range's where there is one.
MapScale scale_of(const RadioMap& map, MapQuantity quantity, const MapLook& look);

/// The picture's size. Of a low map it is as high as its legend.
struct MapSize {
  int width = 0, height = 0;
};
MapSize picture_size(const MapGrid& grid, const MapLook& look);

/// Each cell in its colour: viridis (palette.h) between the ends of the scale, of best_server one
/// of eight; light grey where no path is, dark grey in bodies. Of decibels a contour, drawn darker,
/// each 3 dB where cells have 3 pixels at least; black where the plane cuts flat bodies.
Image8 map_picture(const RadioMap& map, MapQuantity quantity, const MapLook& look);

}  // namespace tia
