#include "core/film/similarity.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

constexpr int side = 11, middle = side / 2;  // of a window

// exp(-d^2 / (2 * 1.5^2)) for d = 0 .. 5, and divided by their sum over a window.
constexpr std::array<double, side> window_weights = [] {
  constexpr std::array half{1.0,
                            0.80073740291680804,
                            0.41111229050718745,
                            0.13533528323661270,
                            0.028565500784550377,
                            0.0038659201394728077};
  double sum = half[0];
  for (int d = 1; d <= middle; ++d) sum += 2 * half[static_cast<std::size_t>(d)];
  std::array<double, side> all{};
  for (int i = 0; i < side; ++i)
    all[static_cast<std::size_t>(i)] =
        half[static_cast<std::size_t>(i < middle ? middle - i : i - middle)] / sum;
  return all;
}();

/// Moments: of two pictures' luma in a window, by its weights.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(double weight, const Moments& more) {
    a += weight * more.a, b += weight * more.b;
    aa += weight * more.aa, bb += weight * more.bb, ab += weight * more.ab;
  }
  double ssim() const {
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const double variances = (aa - a * a) + (bb - b * b), covariance = ab - a * b;
    return (2 * a * b + c1) * (2 * covariance + c2) / ((a * a + b * b + c1) * (variances + c2));
  }
};
using MomentsRow = std::vector<Moments>;

double luma_of(const float* rgb) {
  return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
         0.0722 * static_cast<double>(rgb[2]);
}

// Of the windows' rows: the one whose middle is at x stands at x - middle.
MomentsRow row_of(const Image& a, const Image& b, int y) {
  MomentsRow of_pixels, row;
  for (int x = 0; x < a.width; ++x) {
    const double la = luma_of(a.at(x, y)), lb = luma_of(b.at(x, y));
    of_pixels.push_back({la, lb, la * la, lb * lb, la * lb});
  }
  for (std::size_t x = 0; x + side <= of_pixels.size(); ++x) {
    Moments sum;
    for (std::size_t i = 0; i < side; ++i) sum.add(window_weights[i], of_pixels[x + i]);
    row.push_back(sum);
  }
  return row;
}

/// Sums: what a class' numbers are made from.
struct DifferenceSums {
  std::int64_t pixels = 0, windows = 0;
  double squares = 0, max = 0, ssim = 0;

  void add_pixel(const float* a, const float* b) {
    ++pixels;
    for (int c = 0; c < 3; ++c) {
      const double difference = std::fabs(static_cast<double>(a[c]) - static_cast<double>(b[c]));
      squares += difference * difference;
      max = std::max(max, difference);
    }
  }
  void add_window(double index) { ++windows, ssim += index; }
  Similarity similarity() const {
    Similarity of{.pixels = pixels, .max = max};
    if (pixels > 0) of.mse = squares / (3 * static_cast<double>(pixels));
    if (windows > 0) of.ssim = ssim / static_cast<double>(windows);
    return of;
  }
};

}  // namespace

std::optional<double> Similarity::psnr_db() const {
  if (mse == 0) return std::nullopt;
  constexpr double ln10 = 2.302585092994045684;
  return -10 * log_of(mse) / ln10;
}

Similarities similarity_of(const Image& a, const Image& b, int classes,
                           const std::function<int(int x, int y)>& class_of,
                           const std::stop_token& stop) {
  DifferenceSums whole;
  std::vector<DifferenceSums> each(static_cast<std::size_t>(classes));
  const auto of_class = [&](int x, int y) {
    const int number = classes > 0 ? class_of(x, y) : -1;
    return number < 0 ? nullptr : &each[static_cast<std::size_t>(number)];
  };
  std::array<MomentsRow, side> rows;  // the last ones, row y at y % side
  for (int y = 0; y < a.height; ++y) {
    end_if_asked(stop);
    for (int x = 0; x < a.width; ++x) {
      whole.add_pixel(a.at(x, y), b.at(x, y));
      if (auto* const sums = of_class(x, y)) sums->add_pixel(a.at(x, y), b.at(x, y));
    }
    rows[static_cast<std::size_t>(y % side)] = row_of(a, b, y);
    if (y + 1 < side) continue;
    for (int x = 0; x + side <= a.width; ++x) {
      Moments moments;
      for (int i = 0; i < side; ++i)
        moments.add(
            window_weights[static_cast<std::size_t>(i)],
            rows[static_cast<std::size_t>((y + 1 + i) % side)][static_cast<std::size_t>(x)]);
      const double index = moments.ssim();
      whole.add_window(index);
      if (auto* const sums = of_class(x + middle, y - middle)) sums->add_window(index);
    }
  }
  Similarities all{whole.similarity(), {}};
  for (const DifferenceSums& sums : each) all.classes.push_back(sums.similarity());
  return all;
}

}  // namespace tia
