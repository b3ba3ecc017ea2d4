#include "core/film/denoise_fit.h"

namespace tia {
namespace {

constexpr double least_term_variance = 1e-6;

void add_lane_products(const CenterFits::Lanes& a, const CenterFits::Lanes& b,
                       CenterFits::Lanes& to) {
  for (std::size_t i = 0; i < CenterFits::lanes; ++i) to[i] += a[i] * b[i];
}
void take_lane_products(const CenterFits::Lanes& a, const CenterFits::Lanes& b,
                        CenterFits::Lanes& from) {
  for (std::size_t i = 0; i < CenterFits::lanes; ++i) from[i] -= a[i] * b[i];
}
CenterFits::Lanes lane_products(const CenterFits::Lanes& a, const CenterFits::Lanes& b) {
  CenterFits::Lanes both;
  for (std::size_t i = 0; i < CenterFits::lanes; ++i) both[i] = a[i] * b[i];
  return both;
}

}  // namespace

void CenterFits::add(const Lanes& weight, const Terms& x, const Channels& y) {
  for (std::size_t j = 0; j < terms; ++j) {
    const Lanes weighted = j == 0 ? weight : lane_products(weight, x[j]);
    for (std::size_t k = j; k < terms; ++k) add_lane_products(weighted, x[k], products_[j][k]);
    for (std::size_t c = 0; c < channels; ++c) add_lane_products(weighted, y[c], light_[j][c]);
  }
}

std::array<CenterFits::Channels, CenterFits::terms> CenterFits::solved(const Terms& scale) {
  const Lanes all = products_[0][0];
  Terms inverse;
  for (std::size_t j = 0; j < terms; ++j) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const double pivot = products_[j][j][i];
      const double least = j == 0 ? 0 : least_term_variance * all[i] * scale[j][i] * scale[j][i];
      inverse[j][i] = pivot > least ? 1 / pivot : 0;
    }
    for (std::size_t k = j + 1; k < terms; ++k) {
      const Lanes factor = lane_products(products_[j][k], inverse[j]);
      for (std::size_t m = k; m < terms; ++m)
        take_lane_products(factor, products_[j][m], products_[k][m]);
      for (std::size_t c = 0; c < channels; ++c)
        take_lane_products(factor, light_[j][c], light_[k][c]);
    }
  }
  std::array<Channels, terms> factors;
  for (std::size_t j = terms; j-- > 0;)
    for (std::size_t c = 0; c < channels; ++c) {
      Lanes left = light_[j][c];
      for (std::size_t k = j + 1; k < terms; ++k)
        take_lane_products(products_[j][k], factors[k][c], left);
      factors[j][c] = lane_products(left, inverse[j]);
    }
  return factors;
}

}  // namespace tia
