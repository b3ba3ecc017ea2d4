#include "core/film/pfm.h"

#include <bit>

#include "core/parallel/stopped.h"

namespace tia {

static_assert(std::endian::native == std::endian::little, "PFM is written little-endian");

namespace {

std::string head_of(int width, int height) {
  return std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
}

// Adds rows of so many floats, the last one first.
void add_rows(std::string& out, const float* values, std::size_t row_floats, int height,
              const std::stop_token& stop) {
  const std::size_t row = row_floats * sizeof(float);
  out.reserve(out.size() + static_cast<std::size_t>(height) * row);
  for (int y = height - 1; y >= 0; --y) {
    end_if_asked(stop);
    out.append(reinterpret_cast<const char*>(values + static_cast<std::size_t>(y) * row_floats),
               row);
  }
}

}  // namespace

std::string encode_pfm(const Image& image, const std::stop_token& stop) {
  std::string out = "PF\n" + head_of(image.width, image.height);
  add_rows(out, image.rgb.data(), 3 * static_cast<std::size_t>(image.width), image.height, stop);
  return out;
}

std::string encode_pfm(int width, int height, std::span<const float> values,
                       const std::stop_token& stop) {
  std::string out = "Pf\n" + head_of(width, height);
  add_rows(out, values.data(), static_cast<std::size_t>(width), height, stop);
  return out;
}

}  // namespace tia
