// STL files put together, as bytes and as text.
#pragma once

#include <array>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "core/models/stl.h"
#include "tests/core/models/model_reading.h"

namespace tia::test {

/// StlTriangle: the coordinates of three corners.
using StlTriangle = std::array<float, 9>;

inline std::string stl_bytes(const std::vector<StlTriangle>& triangles,
                             const std::string& head = "") {
  std::string file = head;
  file.resize(80, ' ');
  file += bytes_of_number(static_cast<std::uint32_t>(triangles.size()));
  for (const StlTriangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) file += bytes_of_number(std::numeric_limits<float>::quiet_NaN());
    for (const float x : triangle) file += bytes_of_number(x);
    file += "\x7F\x7F";  // attributes
  }
  return file;
}

/// As many digits as tell doubles apart.
inline std::string stl_text(const std::vector<StlTriangle>& triangles, const std::string& name) {
  std::ostringstream text;
  text.precision(17);
  text << "solid " << name << "\n";
  for (const StlTriangle& t : triangles) {
    text << "  facet normal 0 0 1\n    outer loop\n";
    for (std::size_t i = 0; i < 9; i += 3)
      text << "      vertex " << double{t[i]} << " " << double{t[i + 1]} << " " << double{t[i + 2]}
           << "\n";
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid " << name << "\n";
  return text.str();
}

inline ReadModel read_stl_file(const std::string& file, const ModelLimits& limits = {}) {
  return read_model_file(read_stl, file, limits);
}

inline const std::string stl_facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// Corners on a coarse grid, so that many are equal; 0 of either sign.
inline std::vector<StlTriangle> stl_on_a_grid(Random& random, int count, int grid) {
  std::vector<StlTriangle> triangles(static_cast<std::size_t>(count));
  for (StlTriangle& triangle : triangles)
    for (float& x : triangle) {
      x = static_cast<float>(random.whole(-grid, grid)) * 0.1F;
      if (x == 0 && random.chance(0.5)) x = -x;
    }
  return triangles;
}

}  // namespace tia::test
