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

std::size_t place_of(int width, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(x));
}

int half(int side) { return std::max(side / 2, 1); }

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
    : image_(std::move(image)), light_(&light_of_codes(encoding)) {
  while (halves && (width(levels() - 1) > 1 || height(levels() - 1) > 1))
    halves_.push_back(half_of(levels() - 1));
}

int MipPyramid::width(int level) const {
  return level == 0 ? image_->width : halves_[static_cast<std::size_t>(level) - 1].width;
}
int MipPyramid::height(int level) const {
  return level == 0 ? image_->height : halves_[static_cast<std::size_t>(level) - 1].height;
}

Rgba MipPyramid::texel(int level, int x, int y) const {
  if (level == 0) {
    const std::uint8_t* code = &image_->rgba[place_of(image_->width, x, y)];
    const CodeLight& light = *light_;
    return {light[code[0]], light[code[1]], light[code[2]], code[3] / 255.0};
  }
  const Half& own = halves_[static_cast<std::size_t>(level) - 1];
  const std::uint16_t* code = &own.rgba[place_of(own.width, x, y)];
  return {code[0] / 65535.0, code[1] / 65535.0, code[2] / 65535.0, code[3] / 65535.0};
}

MipPyramid::Half MipPyramid::half_of(int level) const {
  const int w = width(level), h = height(level);
  Half made{half(w), half(h), {}};
  made.rgba.resize(place_of(made.width, 0, made.height));
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
      std::ranges::transform(sum, &made.rgba[place_of(made.width, x, y)], sixteen_bits);
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
    width = half(width), height = half(height);
    bytes += heap_block + sizeof(std::uint16_t) * place_of(width, 0, height);
  }
  return bytes;
}

}  // namespace tia
