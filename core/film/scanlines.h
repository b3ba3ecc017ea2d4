// Scanlines: the form in which PNG compresses a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/film/image.h"
#include "core/parallel/workers.h"

namespace tia {

/// Scanlines: the rows of a picture of 8-bit codes, each behind a byte that names its filter.
/// Shape: height x (1 + 3 width).
/// Source: W3C PNG (third edition), 7.2 and 9.
class Scanlines {
 public:
  /// Rows to be filled in: threads that do so touch the memory first, so nothing clears it.
  Scanlines(int width, int height)
      : width_(width),
        height_(height),
        bytes_(std::make_unique_for_overwrite<std::uint8_t[]>(size())) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t row_bytes() const { return 1 + 3 * static_cast<std::size_t>(width_); }
  std::size_t size() const { return row_bytes() * static_cast<std::size_t>(height_); }
  const std::uint8_t* data() const { return bytes_.get(); }
  /// The first code of pixel (x, y).
  std::uint8_t* at(int x, int y) {
    return bytes_.get() + static_cast<std::size_t>(y) * row_bytes() + 1 +
           3 * static_cast<std::size_t>(x);
  }
  /// Turns row y from codes into differences to the pixel at their left (filter Sub).
  void filter(int y);

 private:
  int width_, height_;
  std::unique_ptr<std::uint8_t[]> bytes_;
};

/// The filtered rows of a picture. Errors: what the workers throw.
Scanlines scanlines_of(const Image8& image, const Workers& workers);

}  // namespace tia
