#include "core/materials/mip_pyramid.h"

#include <algorithm>
#include <utility>

#include "core/math/heap.h"

namespace tia {
namespace {

using CodeLight = std::array<double, 256>;

CodeLight code_light(Encoding encoding) {
  CodeLight light{};
  for (std::size_t code = 0; code < light.size(); ++code) {
    const double signal = static_cast<double>(code) / 255;
    light[code] = encoding == Encoding::srgb ? srgb_to_linear(signal) : signal;
  }
  return light;
}

const CodeLight& light_of_codes(Encoding encoding) {
  static const CodeLight srgb = code_light(Encoding::srgb), linear = code_light(Encoding::linear);
  return encoding == Encoding::srgb ? srgb : linear;
}

int half_side(int side) { return std::max(side / 2, 1); }

/// Cover: which texels of a side of n one of its half covers, and their shares of it. Of an odd n
/// it covers 2 + 1/m: of the i-th of m three texels, m - i, m and i + 1 parts of n.
struct Cover {
  int first = 0, count = 1;
  std::array<double, 3> share{1, 0, 0};

  Cover(int n, int i) {
    if (n == 1) return;
    first = 2 * i;
    if (n % 2 == 0) {
      count = 2, share = {0.5, 0.5, 0};
      return;
    }
    const int m = n / 2;
    count = 3;
    share = {static_cast<double>(m - i) / n, static_cast<double>(m) / n,
             static_cast<double>(i + 1) / n};
  }
};

std::uint16_t sixteen_bits(double value) {
  return static_cast<std::uint16_t>(std::min(value, 1.0) * 65535 + 0.5);
}

}  // namespace

MipPyramid::MipPyramid(std::shared_ptr<const ImageRgba8> image, Encoding encoding, bool halves)
    : image_(std::move(image)),
      light_(&light_of_codes(encoding)),
      shares_(&light_of_codes(Encoding::linear)) {
  while (halves && (width(levels() - 1) > 1 || height(levels() - 1) > 1))
    halves_.push_back(half_of(levels() - 1));
}

MipPyramid::Half MipPyramid::half_of(int level) const {
  const int w = width(level), h = height(level);
  Half made{half_side(w), half_side(h), {}};
  made.rgba.resize(place(made.width, 0, made.height));
  for (int y = 0; y < made.height; ++y) {
    const Cover rows(h, y);
    for (int x = 0; x < made.width; ++x) {
      const Cover columns(w, x);
      Rgba sum{};
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i) {
          const Rgba one = texel(level, columns.first + i, rows.first + j);
          const double share =
              columns.share[static_cast<std::size_t>(i)] * rows.share[static_cast<std::size_t>(j)];
          for (std::size_t k = 0; k < 4; ++k) sum[k] += share * one[k];
        }
      std::ranges::transform(sum, &made.rgba[place(made.width, x, y)], sixteen_bits);
    }
  }
  return made;
}

std::size_t heap_bytes(const MipPyramid& pyramid) {
  std::size_t bytes = 2 * heap_block + sizeof(ImageRgba8) + heap_bytes(pyramid.image_->rgba) +
                      heap_bytes(pyramid.halves_);
  for (const auto& each : pyramid.halves_) bytes += heap_bytes(each.rgba);
  return bytes;
}

std::size_t bytes_of_halves(int width, int height) {
  std::size_t bytes = 0;
  while (width > 1 || height > 1) {
    width = half_side(width), height = half_side(height);
    bytes += heap_block + sizeof(std::uint16_t) * MipPyramid::place(width, 0, height);
  }
  return bytes;
}

}  // namespace tia
