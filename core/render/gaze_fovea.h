// The pixels around the gaze, of which each has a ray of its own where an eye is as sharp as that.
#pragma once

#include <vector>

#include "core/render/gaze.h"
#include "core/render/gaze_frame.h"

namespace tia {

/// GazePixel: one near the gaze.
struct GazePixel {
  Polar<float> polar;
  double last_slope;  ///< up to which it is of the fovea; negative: it never is
};

/// GazeFovea: all pixels of a window that are of the fovea or within its first ring, for an acuity
/// of a slope and for any greater one.
class GazeFovea {
 public:
  GazeFovea(const GazeFrame& frame, const Acuity& acuity, const Window& window);

  /// Those that it looks at. Shape: row by row.
  const Window& box() const { return box_; }
  const std::vector<GazePixel>& pixels() const { return pixels_; }
  /// Whether a pixel is of the fovea at that slope: where the smallest angle that is seen is at
  /// most its own size.
  bool has(int x, int y, double slope) const {
    return x >= box_.x0 && x < box_.x1 && y >= box_.y0 && y < box_.y1 &&
           is_of_fovea(pixels_[index(x, y)], slope);
  }
  static bool is_of_fovea(const GazePixel& pixel, double slope) {
    return slope <= pixel.last_slope;
  }
  std::int64_t count(double slope) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - box_.y0) * static_cast<std::size_t>(box_.width()) +
           static_cast<std::size_t>(x - box_.x0);
  }
  Window box_;
  std::vector<GazePixel> pixels_;
};

/// The first ring's eccentricity: the least beyond which less is seen than a pixel in the picture's
/// centre. Space/units: radians.
double first_ring(const GazeFrame& frame, const Acuity& acuity);

/// A window that holds all pixels which GazeFovea looks at. Cost: its sides.
Window around_gaze(const GazeFrame& frame, const Acuity& acuity, const Window& window);

/// Up to which slope a pixel is of the fovea, whatever the acuity's own; negative: it never is.
double last_slope_of(const GazeFrame& frame, double w0, int x, int y);

}  // namespace tia
