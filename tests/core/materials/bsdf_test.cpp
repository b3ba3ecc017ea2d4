// Scattering by its laws: directions are drawn as densely as is said, and what goes one way goes
// the other.
#include "tests/core/materials/bsdfs.h"

namespace tia {
namespace {

using namespace test;

// The sphere in cells of equal solid angle.
constexpr int rows = 16, columns = 12;
std::size_t cell_of(const Vec3d& w) {
  const double turn = turn_of(w.y, w.x);
  const int row = std::clamp(static_cast<int>((w.z + 1) / 2 * rows), 0, rows - 1);
  const int column = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
  return static_cast<std::size_t>(row * columns + column);
}
// The mean and the most of the density over a cell, by finer * finer directions.
std::pair<double, double> density_in(const Bsdf<Wide>& bsdf, int row, int column, int finer) {
  double sum = 0, most = 0;
  for (int begin = 0; begin < finer * finer; begin += n) {
    std::array<float, n> x, y, z;
    for (std::size_t i = 0; i < n; ++i) {
      const int at = begin + static_cast<int>(i);
      const Vec3f w(direction_at(2 * (row + (at / finer + 0.5) / finer) / rows - 1,
                                 (column + (at % finer + 0.5) / finer) / columns));
      x[i] = w.x, y[i] = w.y, z[i] = w.z;
    }
    const BsdfValue<Wide> value =
        bsdf.value({load<Wide>(x.data()), load<Wide>(y.data()), load<Wide>(z.data())});
    for (int i = 0; i < n; ++i) {
      const double pdf = static_cast<double>(lane(value.pdf, i));
      sum += pdf, most = std::max(most, pdf);
    }
  }
  return {sum / (finer * finer), most};
}
// By 64 directions in each cell, and where the density has a peak by 1024 and more.
std::vector<double> expected_shares(const Bsdf<Wide>& bsdf) {
  std::vector<double> shares;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      auto [mean, most] = density_in(bsdf, row, column, 8);
      for (const int finer : {32, 64})
        if (most > 0.1 && most > (finer == 32 ? 1.3 : 10) * mean)
          std::tie(mean, most) = density_in(bsdf, row, column, finer);
      shares.push_back(mean * 4 * pi / (rows * columns));
    }
  return shares;
}

// Pearson's sum over the cells of more than five samples against its mean and deviation.
TEST(Bsdf, DirectionsComeAsOftenAsTheirDensitySays) {
  Random random(840), of_frames(846);
  constexpr int count = 1 << 14;
  for (int i = 0; i < rounds(100, 5); ++i) {
    Principled principled = any_of(random);
    if (i % 2 == 0) principled = coated(principled, random);
    const Vec3d wo = direction_at(random.in(0.2, 1), random.in(0, 1));
    const double eta = random.in(0, 1) < 0.5 ? principled.ior : 1 / principled.ior;
    const LayerFrames<Wide> frames = any_frames(of_frames);
    const Bsdf<Wide> bsdf =
        bsdf_of(parameters_of(principled), wo, eta, i % 4 < 2 ? nullptr : &frames);
    const std::vector<double> expected = expected_shares(bsdf);
    std::vector<int> found(expected.size());
    int lost = 0;
    each_sample(bsdf, count, [&](const BsdfSample<Wide>& sample, int lane) {
      if (!has(sample.here, lane)) ++lost;
      else ++found[cell_of(lane_of(sample.wi, lane))];
    });
    double squares = 0, all = 0;
    int cells = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      all += expected[k];
      if (expected[k] * count < 5) continue;
      const double off = found[k] - expected[k] * count;
      squares += off * off / (expected[k] * count), ++cells;
    }
    EXPECT_NEAR(all, 1 - static_cast<double>(lost) / count, 0.01) << i;
    EXPECT_LT(squares, cells + 5 * std::sqrt(2.0 * cells)) << i << " of " << cells;
  }
}

// ---- reciprocity, energy -----------------------------------------------------------------------

// The same from both ends; light that passes is denser by the square of the index on the far side.
TEST(Bsdf, ScattersTheSameBothWays) {
  Random random(841);
  for (int i = 0; i < 2000; ++i) {
    const Principled principled = any_of(random);
    const BsdfParameters<double> parameters = parameters_of(principled);
    const Vec3d wo = direction_at(random.in(0.05, 1), random.in(0, 1));
    const Vec3d wi = direction_at(random.in(-1, 1), random.in(0, 1));
    const double eta = random.in(0, 1) < 0.5 ? principled.ior : 1 / principled.ior;
    const bool passes = wi.z < 0;
    const double back = passes && !principled.thin ? 1 / eta : eta;
    const Vec3d there = value_of(parameters, wo, wi, eta),
                again = value_of(parameters, wi, wo, back);
    const double denser = passes && !principled.thin ? eta * eta : 1;
    for (const auto& [a, b] : {std::pair{there.x, again.x}, {there.y, again.y}, {there.z, again.z}})
      EXPECT_NEAR(a * denser, b, 1e-5 + 2e-3 * b) << i;
  }
}
}  // namespace
}  // namespace tia
