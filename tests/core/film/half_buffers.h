// Half buffers that are made, not traced.
#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "core/film/denoise.h"

namespace tia::test {

constexpr int width = 70, height = 40;  // neither is a multiple of a tile
using Plane = PixelPlanes::Plane;
using Field = std::function<double(double x, double y)>;

/// Chance: independent numbers, the same in every run.
class Chance {
 public:
  double unit() { return static_cast<double>(bits_()) / 4294967296.0; }
  double normal() {  // of mean 0 and variance 1: the sum of twelve uniform ones less 6
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

 private:
  std::mt19937 bits_{20160622};
};

inline HalfBuffers blank(int w = width, int h = height) {
  HalfBuffers halves{PixelPlanes(w, h), PixelPlanes(w, h)};
  for (PixelPlanes* half : {&halves.a, &halves.b})
    for (const int plane : {0, 1, 2, 3, 4, 5, 7, 10})
      half->planes[static_cast<std::size_t>(plane)].assign(half->size(), 1);
  return halves;
}
inline void fill(PixelPlanes& half, int plane, const Field& field) {
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int at = y * half.width + x;
      half.planes[static_cast<std::size_t>(plane)][static_cast<std::size_t>(at)] =
          static_cast<float>(field(x, y));
    }
}
inline void fill(HalfBuffers& halves, int plane, const Field& field) {
  fill(halves.a, plane, field);
  fill(halves.b, plane, field);
}
inline void fill_light(HalfBuffers& halves, const Field& field) {
  for (PixelPlanes* half : {&halves.a, &halves.b}) {
    fill(*half, Plane::light, field);
    half->planes[1] = half->planes[2] = half->planes[0];
  }
}

inline double mean_square(const Image& image, const Field& truth, int channel = 0) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += std::pow(static_cast<double>(image.at(x, y)[channel]) - truth(x, y), 2);
  return sum / (image.width * image.height);
}
inline double mean_of(const Image& image) {
  double sum = 0;
  for (const float each : image.rgb) sum += static_cast<double>(each);
  return sum / static_cast<double>(image.rgb.size());
}
// The picture that is there without a filter.
inline Image noisy(const HalfBuffers& halves) {
  Image image(halves.a.width, halves.a.height);
  for (std::size_t i = 0; i < halves.a.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.rgb[3 * i + c] = (halves.a.planes[c][i] + halves.b.planes[c][i]) / 2;
  return image;
}

}  // namespace tia::test
