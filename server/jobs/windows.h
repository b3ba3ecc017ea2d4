// A picture cut into windows, and put together again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/film/image.h"
#include "core/render/reached.h"
#include "core/render/window.h"
#include "server/requests/plan.h"

namespace tia::server {

/// Whether the windows of a picture are the picture, with its rays: not where noise is taken off,
/// for which more is traced around each; nor for a gaze, whose rings windows share; nor of a
/// sheet's views, layers or an archive of views, which are more than one picture.
bool can_be_cut(const Plan& plan);

/// Windows: squares of a window of a picture, row by row; those at the right and at the bottom are
/// what is left.
struct Windows {
  Window whole;
  int side = 1;

  int columns() const { return (whole.width() + side - 1) / side; }
  int count() const { return columns() * ((whole.height() + side - 1) / side); }
  Window window(int n) const;
};

/// Bytes of a pixel of a piece: 8-bit codes for a PNG, else floats.
std::size_t piece_pixel_bytes(const Plan& plan);

/// Mosaic: a picture that pieces are put into.
class Mosaic {
 public:
  /// Of the whole picture's plan.
  explicit Mosaic(const Plan& plan);
  /// Errors: std::runtime_error for a piece that is not as long as its window.
  void put(const Window& window, const std::string& piece);
  /// The file. Errors: Stopped.
  std::string file(const Workers& workers) &&;

 private:
  const Plan& plan_;
  std::size_t pixel_;  // bytes
  Image8 codes_;
  ImageRgba8 codes_with_alpha_;
  Image light_;
  char* bytes_ = nullptr;  // of the one that is in use
};

/// How far the samples of a picture have come whose windows have come so far.
class ReachedOfWindows {
 public:
  void add(const Reached& window, const Window& of);
  std::optional<Reached> reached() const { return all_; }

 private:
  std::optional<Reached> all_;
  double samples_ = 0, pixels_ = 0;
};

}  // namespace tia::server
