// Scattering by its energy: white bodies lose nothing, none gives more than it gets.
#include "tests/core/materials/bsdfs.h"

namespace tia {
namespace {

using namespace test;

// The light that a white sky all around gives: energy, so not denser where it passes.
double albedo_of(const Principled& principled, double mu, double eta, double turn = 0.1,
                 const LayerFrames<Wide>* frames = nullptr) {
  const Bsdf<Wide> bsdf = bsdf_of(parameters_of(principled), direction_at(mu, turn), eta, frames);
  double sum = 0;
  constexpr int count = 1 << 12;
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
    for (const double roughness : {0.0, 0.1, 0.3, 0.6})
      for (const double mu : {0.05, 0.25, 0.5, 0.75, 1.0})
        for (const double turn : {0.03, 0.22}) {
          if (sanitized() && anisotropy != 0.6) continue;
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
// As fine as its lines may be: what is stretched still has no single direction.
TEST(Bsdf, GrainIsNeverSmooth) {
  for (const double roughness : {0.0, 0.01})
    for (const double anisotropy : {0.0, 0.02, 0.05, 1.0}) {
      Principled p = white(roughness);
      p.metallic = 1, p.anisotropy = anisotropy;
      const Bsdf<Wide> bsdf = bsdf_of(parameters_of(p), direction_at(0.5, 0.1), 1.5);
      EXPECT_EQ(any(bsdf.scatters()), anisotropy > 0.04) << roughness << ' ' << anisotropy;
    }
}
TEST(Bsdf, NothingGivesMoreThanItGets) {
  Random random(842), of_frames(847);
  for (int i = 0; i < rounds(200, 10); ++i) {
    const Principled principled = coated(any_of(random), random);
    const double mu = random.in(0.02, 1);
    const double eta = random.in(0, 1) < 0.5 ? principled.ior : 1 / principled.ior;
    const LayerFrames<Wide> frames = any_frames(of_frames);
    EXPECT_LT(albedo_of(principled, mu, eta, 0.1, i % 4 < 2 ? nullptr : &frames), 1.012) << i;
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
// Of the facets' direction only what lies in the surface counts.
TEST(Bsdf, GrainThatIsToldIsGrainTurnedAsFar) {
  Random random(848);
  for (int i = 0; i < 50; ++i) {
    Principled p = any_of(random);
    p.anisotropy = random.in(0.2, 0.8);
    const Vec3d along{std::cos(p.anisotropy_rotation), std::sin(p.anisotropy_rotation), 0};
    const LayerFrames<Wide> frames =
        frames_of({0, 0, 1}, along * random.in(0.1, 3) + Vec3d{0, 0, random.in(-1, 1)});
    const Vec3d wo = direction_at(random.in(0.2, 1), random.in(0, 1));
    const Vec3d wi = direction_at(random.in(-1, 1), random.in(0, 1));
    const BsdfParameters<double> turned = parameters_of(p);
    p.anisotropy_rotation += random.in(0.3, 1);
    const Vec3d expected = lane_of(bsdf_of(turned, wo, 1.5).value(lift<Wide>(wi)).f_cos, 0);
    const Vec3d told =
        lane_of(bsdf_of(parameters_of(p), wo, 1.5, &frames).value(lift<Wide>(wi)).f_cos, 0);
    EXPECT_LE(length(told - expected), 1e-6 + 1e-4 * length(expected)) << i;
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
