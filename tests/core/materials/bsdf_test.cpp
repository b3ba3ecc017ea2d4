// Scattering by its laws: directions are drawn as densely as is said, what goes one way goes the
// other, and white bodies lose nothing. Materials at random, of the kinds that a scene can say.
#include <gtest/gtest.h>

#include <functional>

#include "core/materials/bsdf.h"
#include "core/materials/material.h"
#include "core/math/lanes.h"
#include "core/math/sobol.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using namespace test;

constexpr int n = lanes<Wide>;

Bsdf<Wide> bsdf_of(const BsdfParameters<double>& parameters, const Vec3d& wo, double eta) {
  BsdfParameters<Wide> wide;
  wide.take(parameters, Wide(0) == Wide(0), true);
  const Vec3<Wide> up{Wide(0), Wide(0), Wide(1)};
  return {wide, lift<Wide>(wo), up, up, lift<Wide>(eta), Wide(0) == Wide(0)};
}
Vec3d direction_at(double z, double turn) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
}

BsdfParameters<double> parameters_of(const Principled& principled) {
  return shading_of(principled, {}).bsdf;
}
Principled white(double roughness) {
  Principled p;
  p.roughness = roughness;
  return p;
}
Principled any_of(Random& random) {
  Principled p = white(random.in(0.3, 1));
  p.base_color = Color{random.in(0, 1), random.in(0, 1), random.in(0, 1)};
  p.metallic = random.in(0, 1);
  p.transmission = random.in(0, 1);
  p.ior = random.in(1.1, 2.4);
  p.thin = random.in(0, 1) < 0.3;
  p.anisotropy = random.in(0, 1) < 0.7 ? 0 : random.in(0, 0.7);
  p.anisotropy_rotation = random.in(0, 6);
  return p;
}
Principled coated(Principled p, Random& random) {
  p.clearcoat = random.in(0, 1);
  p.clearcoat_roughness = random.in(0.2, 1);
  p.sheen_color = {random.in(0, 1), random.in(0, 1), random.in(0, 1)};
  p.sheen_roughness = random.in(0.3, 1);
  return p;
}

// ---- directions drawn --------------------------------------------------------------------------

// Calls to(sample, lane) with samples of a bsdf.
void each_sample(const Bsdf<Wide>& bsdf, int count,
                 const std::function<void(const BsdfSample<Wide>&, int)>& to) {
  const std::array<std::uint32_t, 1> origin{0};
  for (int begin = 0; begin < count; begin += n) {
    std::array<float, n> lobe, u, v;
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto words =
          sobol_words(origin, origin, static_cast<std::uint32_t>(begin + i), 7, RandomKey(3));
      lobe[at] = unit_float(words.a[0]), u[at] = unit_float(words.b[0]),
      v[at] = unit_float(words.c[0]);
    }
    const auto sample =
        bsdf.sample(load<Wide>(lobe.data()), load<Wide>(u.data()), load<Wide>(v.data()));
    for (int i = 0; i < n; ++i) to(sample, i);
  }
}
bool has(Mask<Wide> mask, int i) { return (bits(mask) >> i & 1U) != 0; }
Vec3d lane_of(const Vec3<Wide>& v, int i) {
  return {static_cast<double>(lane(v.x, i)), static_cast<double>(lane(v.y, i)),
          static_cast<double>(lane(v.z, i))};
}

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
  Random random(840);
  constexpr int count = 1 << 14;
  for (int i = 0; i < rounds(100, 5); ++i) {
    Principled principled = any_of(random);
    if (i % 2 == 0) principled = coated(principled, random);
    const Vec3d wo = direction_at(random.in(0.2, 1), random.in(0, 1));
    const double eta = random.in(0, 1) < 0.5 ? principled.ior : 1 / principled.ior;
    const Bsdf<Wide> bsdf = bsdf_of(parameters_of(principled), wo, eta);
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

Vec3d value_of(const BsdfParameters<double>& parameters, const Vec3d& wo, const Vec3d& wi,
               double eta) {
  BsdfParameters<double> own = parameters;
  if (wo.z < 0) own.grain_sin = -own.grain_sin;  // as scatterers() has it behind a surface
  const Vec3d side{0, 0, wo.z < 0 ? -1.0 : 1.0};
  return Bsdf<double>(own, wo, side, side, eta, true).value(wi).f_cos * (1 / std::fabs(wi.z));
}
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

// The light that a white sky all around gives: energy, so not denser where it passes.
double albedo_of(const Principled& principled, double mu, double eta, double turn = 0.1) {
  const Bsdf<Wide> bsdf = bsdf_of(parameters_of(principled), direction_at(mu, turn), eta);
  double sum = 0;
  const int count = rounds(1 << 12, 4);
  each_sample(bsdf, count, [&](const BsdfSample<Wide>& sample, int lane) {
    if (!has(sample.here, lane)) return;
    const double denser = has(sample.transmitted, lane) && !principled.thin ? eta * eta : 1;
    sum += lane_of(sample.weight, lane).y * denser;
  });
  return sum / count;
}
TEST(Bsdf, WhiteSurfacesLoseNothing) {
  for (const double roughness : {0.0, 0.25, 0.5, 0.75, 1.0})
    for (const double mu : {0.05, 0.25, 0.5, 0.75, 1.0}) {
      const auto expect_white = [&](const char* what, const Principled& p, double eta) {
        EXPECT_NEAR(albedo_of(p, mu, eta), 1, 0.01) << what << ' ' << roughness << ' ' << mu;
      };
      Principled p = white(roughness);
      expect_white("plastic", p, 1.5);
      p.clearcoat = 1, p.clearcoat_roughness = roughness / 2;
      expect_white("coated", p, 1.5);
      p = white(roughness), p.sheen_color = {1, 1, 1}, p.sheen_roughness = roughness;
      expect_white("cloth", p, 1.5);
      p = white(roughness), p.metallic = 1;
      expect_white("metal", p, 1.5);
      p = white(roughness), p.transmission = 1;
      expect_white("glass", p, 1.5);
      expect_white("glass from inside", p, 1 / 1.5);
      expect_white("diamond", p, 2.4);
      p.thin = true;
      expect_white("pane", p, 1.5);
      p = white(roughness), p.transmission = 0.5, p.metallic = 0.3;
      expect_white("all of them", p, 1.5);
    }
}
// What stretched facets send on is the mean of few of them.
TEST(Bsdf, WhiteGrainLosesLittle) {
  for (const double anisotropy : {0.3, 0.6, 1.0})
    for (const double roughness : {0.1, 0.3, 0.6})
      for (const double mu : {0.05, 0.25, 0.5, 0.75, 1.0})
        for (const double turn : {0.03, 0.22}) {
          const auto expect_white = [&](const char* what, const Principled& p, double eta,
                                        double off) {
            EXPECT_NEAR(albedo_of(p, mu, eta, turn), 1, off)
                << what << ' ' << anisotropy << ' ' << roughness << ' ' << mu << ' ' << turn;
          };
          Principled p = white(roughness);
          p.anisotropy = anisotropy;
          expect_white("plastic", p, 1.5, 0.02);
          p.metallic = 1;
          expect_white("metal", p, 1.5, 0.03);
          p.metallic = 0, p.transmission = 1;
          expect_white("glass", p, 1.5, 0.03);
          expect_white("glass from inside", p, 1 / 1.5, 0.08);
        }
}
TEST(Bsdf, NothingGivesMoreThanItGets) {
  Random random(842);
  for (int i = 0; i < rounds(200, 10); ++i) {
    const Principled principled = coated(any_of(random), random);
    const double mu = random.in(0.02, 1);
    EXPECT_LT(
        albedo_of(principled, mu, random.in(0, 1) < 0.5 ? principled.ior : 1 / principled.ior),
        1.012)
        << i;
  }
}

// A boundary between equal indices cannot be seen, however rough it is.
TEST(Bsdf, EqualIndicesLetLightGoStraightOn) {
  for (const double roughness : {0.0, 0.3, 1.0}) {
    Principled p = white(roughness);
    p.transmission = 1;
    const Vec3d wo = direction_at(0.4, 0.3);
    each_sample(bsdf_of(parameters_of(p), wo, 1), 64,
                [&](const BsdfSample<Wide>& sample, int lane) {
                  const Vec3d on = lane_of(sample.wi, lane) + wo;
                  EXPECT_LT(length(on), 1e-5) << roughness;
                  EXPECT_NEAR(lane_of(sample.weight, lane).y, 1, 1e-5);
                });
  }
}

// ---- closed forms -------------------------------------------------------------------------------

// ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) of gold at 650 nm, n = 0.183 and k = 3.4242.
TEST(Bsdf, MetalsReflectWhatTheirIndicesSay) {
  Principled gold = white(0);
  gold.base_color = Metal::gold;
  const Vec3d base = parameters_of(gold).base;
  EXPECT_NEAR(base.x, 0.944, 0.001);
  EXPECT_GT(base.x, base.y);
  EXPECT_GT(base.y, base.z);
}
// Straight down the facets' share is an integral over one angle: of D G / 4, with the facet's angle
// half of the light's.
TEST(Bsdf, TableIsTheIntegralOverTheLight) {
  for (const double rough : {0.1, 0.23, 0.25, 0.3, 0.45, 0.6, 0.8, 1.0}) {
    const Ggx<double> ggx{rough * rough, rough * rough};
    constexpr int count = 200'000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
      const double angle = pi / 2 * (i + 0.5) / count;
      const Vec3d wi{std::sin(angle), 0, std::cos(angle)};
      const Vec3d h{std::sin(angle / 2), 0, std::cos(angle / 2)};
      sum += ggx.density(h) * ggx.visible({0, 0, 1}, wi) / 4 * 2 * pi * wi.x * pi / 2 / count;
    }
    const auto table = schlick_albedo(1.0, rough);
    EXPECT_NEAR(table.a + table.b, sum, 1e-3) << rough;
  }
}
// Straight down on GGX: D = 1 / (pi alpha^2), all facets seen, f = F D / 4.
TEST(Bsdf, MirrorOfFacetsIsAsBrightAsItsPeak) {
  Random random(843);
  for (int i = 0; i < 20; ++i) {
    const double roughness = random.in(0.3, 0.6), alpha = roughness * roughness;
    Principled metal = white(roughness);
    metal.metallic = 1;
    const Vec3d value = value_of(parameters_of(metal), {0, 0, 1}, {0, 0, 1}, 1.5);
    const double peak = 1 / (4 * pi * alpha * alpha);
    EXPECT_NEAR(value.x, peak, 0.003 * peak + 0.2 * alpha);
  }
}

}  // namespace
}  // namespace tia
