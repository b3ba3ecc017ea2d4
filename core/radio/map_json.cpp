// A map as JSON, and its schema.
#include <cmath>

#include "core/input/object_schema.h"
#include "core/radio/radio_map.h"

namespace tia {
namespace {

Value row_json(const RadioMap& map, int row) {
  const auto width = static_cast<std::size_t>(map.grid.width);
  const double* first = map.values.data() + static_cast<std::size_t>(row) * width;
  Value::Array list;
  list.reserve(width);
  for (std::size_t i = 0; i < width; ++i)
    list.push_back(std::isnan(first[i]) ? Value() : Value(first[i]));
  return list;
}

}  // namespace

Value radio_map_json(const RadioMapQuestion& question, const RadioMap& map) {
  const MapGrid& grid = map.grid;
  Value::Array rows;
  for (int row = 0; row < grid.height; ++row) {
    give_way();
    rows.push_back(row_json(map, row));
  }
  Value::Object told{{"width", grid.width}, {"height", grid.height}};
  if (question.origin) {
    told.emplace_back("origin", write_value(grid.origin));
    told.emplace_back("u", write_value(grid.at(grid.width, 0) - grid.origin));
    told.emplace_back("v", write_value(grid.at(0, grid.height) - grid.origin));
  } else {
    const Vec3d end = grid.at(grid.width, grid.height);
    told.emplace_back("area", Value::Array{grid.origin.x, grid.origin.z, end.x, end.z});
    told.emplace_back("y", grid.origin.y);
  }
  told.emplace_back("cell", grid.cell);
  told.emplace_back("quantity", name_of(question.quantity));
  told.emplace_back("unit", unit_of(question.quantity));
  told.emplace_back("values", std::move(rows));
  return told;
}

Value radio_map_schema() {
  const Value number = plain_schema<double>(), count = plain_schema<int>();
  const Value place = list_schema(number), text = plain_schema<std::string>();
  return object_schema({{"width", count, "cells in a row"},
                        {"height", count, "rows"},
                        {"cell", number, "the side of a cell"},
                        {"quantity", text, "what the values are"},
                        {"unit", text, "and in what"},
                        {"values", list_schema(list_schema(nullable_schema(number))),
                         "row by row; null where no path is, and in bodies"},
                        {"area", place, "x0,z0,x1,z1 of what the cells cover", false},
                        {"y", number, "the plane of the area", false},
                        {"origin", place, "of a plane that was asked for, its corner", false},
                        {"u", place, "along its rows", false},
                        {"v", place, "along its columns", false}});
}

}  // namespace tia
