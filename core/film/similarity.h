// How far two pictures are from each other, as a display shows them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/film/image.h"

namespace tia {

/// Similarity: of some pixels of two pictures. Space/units: signals in [0, 1].
struct Similarity {
  std::int64_t pixels = 0;
  double mse = 0;                   ///< the mean of the squared differences of all channels
  double max = 0;                   ///< the largest difference of a channel
  std::optional<double> ssim = {};  ///< none where no window has its centre there

  /// The peak signal-to-noise ratio; none of what is the same.
  std::optional<double> psnr_db() const;
};

/// Similarities: of all pixels, and of each class of them.
struct Similarities {
  Similarity whole;
  std::vector<Similarity> classes;
};

/// Holds two pictures of signals against each other. SSIM is the mean of Wang's index over all
/// windows of 11 x 11 that lie in the picture, weighted by a Gaussian of sigma 1.5, K = 0.01 and
/// 0.03, of the luma by BT.709's weights; of a class, over those whose centre is of it.
/// `class_of`: the class of pixel (x, y), 0 .. classes - 1, or -1: none.
/// Domain: pictures of one size. Errors: Stopped.
/// Source: Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to
/// structural similarity", IEEE TIP 13(4), 2004, 13 and section III-B.
Similarities similarity_of(const Image& a, const Image& b, int classes,
                           const std::function<int(int x, int y)>& class_of,
                           const std::stop_token& stop = {});

}  // namespace tia
