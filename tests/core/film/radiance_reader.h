// An independent reader of Radiance's pictures, after the format's own description. The writer's
// library is not used here.
// Source: Radiance, color.c: freadcolrs, oldreadcolrs, colr_color.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tia::test {

/// Rgbe: three mantissas and an exponent.
using Rgbe = std::array<int, 4>;

/// What one mantissa stands for. Space/units: linear light.
inline double step_of(const Rgbe& pixel) {
  return pixel[3] == 0 ? 0 : std::ldexp(1.0, pixel[3] - (128 + 8));
}
/// A component as Ward reads it: in the middle of what has this mantissa.
inline double component_of(const Rgbe& pixel, std::size_t channel) {
  return (pixel[channel] + 0.5) * step_of(pixel);
}

/// RadiancePicture: its pixels, row 0 on top.
struct RadiancePicture {
  int width = 0, height = 0;
  std::vector<Rgbe> pixels;

  const Rgbe& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

namespace radiance {

inline int byte(std::istream& file) {
  const int value = file.get();
  if (value < 0) throw std::runtime_error("a Radiance picture ends early");
  return value;
}

// Returns: the picture without its pixels. Variables up to an empty line, then the resolution.
inline RadiancePicture read_head(std::istream& file) {
  std::string line;
  if (!std::getline(file, line) || line != "#?RADIANCE")
    throw std::runtime_error("not a Radiance picture");
  bool is_rgbe = false;
  while (std::getline(file, line) && !line.empty())
    is_rgbe = is_rgbe || line == "FORMAT=32-bit_rle_rgbe";
  RadiancePicture picture;
  std::string y, x;
  file >> y >> picture.height >> x >> picture.width;
  if (!is_rgbe || y != "-Y" || x != "+X" || file.get() != '\n')
    throw std::runtime_error("not RGBE with rows from the top and columns from the left");
  return picture;
}

// One of the four planes of a row: a count up to 128 with as many bytes, or 128 more than a count
// with one byte that is repeated.
inline void read_plane(std::istream& file, std::vector<Rgbe>& row, std::size_t plane) {
  for (std::size_t x = 0; x < row.size();) {
    const int mark = byte(file);
    const bool is_run = mark > 128;
    const auto count = static_cast<std::size_t>(is_run ? mark - 128 : mark);
    if (count == 0 || count > row.size() - x) throw std::runtime_error("a run beyond its row");
    int value = is_run ? byte(file) : 0;
    for (const std::size_t end = x + count; x < end; ++x)
      row[x][plane] = is_run ? value : value = byte(file);
  }
}

inline std::vector<Rgbe> read_row(std::istream& file, int width) {
  std::vector<Rgbe> row(static_cast<std::size_t>(width));
  const bool in_planes = width >= 8 && width < 32768;
  if (in_planes) {
    if (byte(file) != 2 || byte(file) != 2 || (byte(file) << 8) + byte(file) != width)
      throw std::runtime_error("a row that does not begin as one");
    for (std::size_t plane = 0; plane < 4; ++plane) read_plane(file, row, plane);
    return row;
  }
  for (Rgbe& pixel : row) {
    for (int& each : pixel) each = byte(file);
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1)
      throw std::runtime_error("a run of the old kind, which no mantissas look like");
  }
  return row;
}

}  // namespace radiance

/// Errors: std::runtime_error where the file is no picture, or longer than one.
inline RadiancePicture read_radiance(const std::string& bytes) {
  std::istringstream file(bytes);
  RadiancePicture picture = radiance::read_head(file);
  for (int y = 0; y < picture.height; ++y) {
    const std::vector<Rgbe> row = radiance::read_row(file, picture.width);
    picture.pixels.insert(picture.pixels.end(), row.begin(), row.end());
  }
  if (file.peek() != std::istringstream::traits_type::eof())
    throw std::runtime_error("bytes behind a Radiance picture");
  return picture;
}

}  // namespace tia::test
