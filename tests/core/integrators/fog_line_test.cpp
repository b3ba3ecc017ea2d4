// Where along a ray fog scatters, and whereto, as dense as it says.
#include "core/integrators/fog_line.h"

#include "core/integrators/phase.h"
#include "tests/core/integrators/paths.h"
#include "tests/core/integrators/quadrature.h"

namespace tia {
namespace {

using namespace test;

TEST(Phase, IsDrawnAsDenseAsItSays) {
  Random random(910);
  for (int round = 0; round < 20; ++round) {
    const double g = round == 0 ? 0 : random.in(-0.95, 0.95);
    const HenyeyGreenstein<double> phase{g};
    const Vec3d w = random.direction();
    EXPECT_NEAR(simpson(-1, 1, 4000, [&](double c) { return 2 * pi * phase.value(c); }), 1, 1e-6);
    // The cosine's cumulative distribution, by integration of the definition.
    const auto below = [&](double c) {
      if (g == 0) return (1 + c) / 2;
      return (1 - g * g) / (2 * g) *
             (1 / std::sqrt(1 + g * g - 2 * g * c) - 1 / std::sqrt(1 + g * g + 2 * g));
    };
    constexpr int n = 4096, bins = 16;
    std::array<int, bins> found{};
    Vec3d sum{};
    for (int i = 0; i < n; ++i) {
      const Vec3d wi = phase.sample(w, random.in(0, 1), random.in(0, 1));
      EXPECT_NEAR(length(wi), 1, 1e-9);
      sum = sum + wi;
      const double share = below(std::clamp(dot(w, wi), -1.0, 1.0));
      ++found[static_cast<std::size_t>(std::clamp(share, 0.0, 1 - 1e-12) * bins)];
    }
    double chi = 0;
    constexpr double expected = static_cast<double>(n) / bins;
    for (const int each : found) chi += std::pow(each - expected, 2) / expected;
    EXPECT_LT(chi, 15 + 5 * std::sqrt(2 * 15)) << g;
    EXPECT_LT(length(sum * (1.0 / n) - w * g), 5 / std::sqrt(n)) << g;
  }
}

TEST(FogLine, DistancesAreDrawnAsDenseAsTheySay) {
  Random random(911);
  for (int round = 0; round < 60; ++round) {
    const double near = random.in(0, 3);
    const double far = round % 3 == 0 ? infinity : near + std::pow(10, random.in(-4, 2));
    const double density = std::pow(10, random.in(-3, 1));
    const FogLine line(random.point(5), random.direction(), near, far, density);
    const Vec3d lamp = round % 5 == 0 ? line.point(near + random.in(0.1, 1)) : random.point(5);
    const FogLine::View view(line, lamp);
    for (const bool aimed : {false, true}) {
      const auto at = [&](double u) { return aimed ? view.draw(u) : line.within(u); };
      const auto pdf = [&](double t) { return aimed ? view.pdf(t) : line.met(t) / line.taken(); };
      // dt/du = 1 / pdf.
      for (const double u : {0.1, 0.37, 0.8, 0.95}) {
        const double step = 1e-5, slope = (at(u + step) - at(u - step)) / (2 * step);
        EXPECT_NEAR(slope * pdf(at(u)), 1, 1e-3) << round << ' ' << aimed << ' ' << u;
      }
      EXPECT_NEAR(at(0), near, 1e-6 * (near + 1));
      if (far < infinity && (aimed || line.taken() < 0.99)) {
        EXPECT_NEAR(at(1 - 1e-12), far, 1e-4 * far);
      }
    }
    const double passed = std::exp(-density * (far - near));
    EXPECT_NEAR(line.taken(), 1 - passed, 1e-12);
    EXPECT_NEAR(line.flight(0.5), near + std::log(2) / density, 1e-9 * line.flight(0.5));
    EXPECT_NEAR(line.met(near), density, 1e-12 * density);
  }
}

// Two parts of a line, and what is drawn of them: how much of it lies before a distance, by
// summing up the densities that the whole line tells.
TEST(FogLine, KeepsToWhereALightShines) {
  Random random(915);
  for (int round = 0; round < 40; ++round) {
    const FogLine line(random.point(5), random.direction(), 1, round % 2 == 0 ? 9 : infinity,
                       std::pow(10, random.in(-2, 0.3)));
    const double a = random.in(-1, 3), b = random.in(3, 4), c = random.in(4, 6);
    LitSpans spans;
    spans.add(a, b), spans.add(c, round % 3 == 0 ? LitSpans::endless : c + 2);
    const FogLine lit = line.lit_by(spans);
    const Vec3d lamp = random.point(5);
    const FogLine::View whole(line, lamp), view(lit, lamp);
    for (const bool aimed : {false, true}) {
      const auto at = [&](double u) { return aimed ? view.draw(u) : lit.within(u); };
      const auto pdf = [&](double t) { return aimed ? view.pdf(t) : lit.met(t) / lit.taken(); };
      const auto before = [&](double t) { return aimed ? 1 / whole.pdf(t) : 1 / line.met(t); };
      double last = 0;
      for (int i = 0; i <= 64; ++i) {
        const double u = i / 64.0 * (1 - 1e-9), t = at(u);
        EXPECT_TRUE(lit.has(t) && t >= last) << round << ' ' << t;
        // The densities are those of the whole line over one share of it.
        EXPECT_NEAR(pdf(t) * before(t), pdf(at(0.5)) * before(at(0.5)), 1e-9 * pdf(t) * before(t));
        last = t;
      }
      for (const double u : {0.1, 0.37, 0.8, 0.95}) {
        const double step = 1e-6, slope = (at(u + step) - at(u - step)) / (2 * step);
        if (at(u + step) - at(u - step) < 0.5) {
          EXPECT_NEAR(slope * pdf(at(u)), 1, 1e-3) << round << ' ' << aimed << ' ' << u;
        }
      }
    }
    EXPECT_FALSE(lit.has((b + c) / 2));
    EXPECT_EQ(view.pdf((b + c) / 2), 0);
  }
}
}  // namespace
}  // namespace tia
