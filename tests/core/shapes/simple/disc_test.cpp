#include "core/shapes/simple/disc.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

// A point is chosen in the disc's plane, then a line through it: t is known, and whether it hits.
TEST(Disc, IsHitWithinTheRadiusAndMissedBeyond) {
  Random random(30);
  for (const double scale : scales) {
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      const Disc disc{random.point(5) * scale, random.vector(0.01, 10), random.in(0.1, 3) * scale};
      const Vec3d within = normalize(cross(disc.normal, random.direction()));
      const double share = random.chance(0.3)   ? random.in(0, 0.9)
                           : random.chance(0.5) ? 1 - 1e-9
                                                : 1 + 1e-9;
      const Vec3d target = disc.center + within * (share * disc.radius);
      const SceneLine line{target + random.vector(0.5, 5) * scale, {}};
      const double pace = random.in(-3, 3);
      const SceneLine sent{line.origin, (target - line.origin) * (1 / pace)};
      if (std::fabs(dot(normalize(sent.direction), normalize(disc.normal))) < 0.1) continue;
      const DiscForm form = prepare(disc);
      const std::vector<double> roots = roots_along(form, sent);
      if (share > 1) {
        EXPECT_TRUE(roots.empty());
        continue;
      }
      ++hits;
      ASSERT_EQ(roots.size(), 1u) << share;
      EXPECT_NEAR(roots[0], pace, 1e-12);
      const auto n = static_cast<Vec3l>(disc.normal);
      expect_on_surface(
          form,
          [&](const Vec3l& p) {
            return dot(p - static_cast<Vec3l>(disc.center), n) / std::sqrt(dot(n, n));
          },
          sent.at(static_cast<Long>(roots[0])), 0, 5 * scale);
    }
    EXPECT_GT(hits, 800);
  }
}

TEST(Disc, RayThroughTheRimHits) {
  for (const double scale : {0.125, 1.0, 1024.0}) {
    const DiscForm disc = prepare(Disc{{0, 0, 0}, {0, 0, 1}, scale});
    expect_distances(roots_along(disc, {{scale, 0, 2 * scale}, {0, 0, -1}}), {2 * scale}, 0);
    expect_distances(roots_along(disc, {{scale * (1 + 1e-12), 0, 2 * scale}, {0, 0, -1}}), {}, 0);
  }
}

TEST(Disc, RayInItsPlaneMisses) {
  const DiscForm disc = prepare(Disc{{0, 1, 0}, {0, 1, 0}, 2});
  EXPECT_TRUE(roots_along(disc, {{-5, 1, 0}, {1, 0, 0}}).empty());
  EXPECT_TRUE(roots_along(disc, {{-5, 1.5, 0}, {1, 0, 0}}).empty());
  expect_nothing_from_nan(disc);
}

TEST(Disc, IsNoSolid) { EXPECT_FALSE(DiscForm::solid); }

// A circle's box is tight: its points reach the bounds, r sqrt(1 - n_i^2) along the axis i.
TEST(Disc, BoundsTouchTheRim) {
  Random random(31);
  for (int i = 0; i < 20; ++i) {
    const Disc disc{random.point(2), random.vector(0.5, 2), random.in(0.5, 2)};
    const DiscForm form = prepare(disc);
    Aabb rim;
    for (int k = 0; k < 720; ++k) {
      const double angle = k * std::acos(-1.0) / 360;
      rim = around(rim, disc.center + form.frame.u * (disc.radius * std::cos(angle)) +
                            form.frame.v * (disc.radius * std::sin(angle)));
    }
    EXPECT_LT(length(rim.min - bounds(form).min), 1e-4);
    EXPECT_LT(length(rim.max - bounds(form).max), 1e-4);
  }
}

TEST(Disc, WithoutADirectionOrRadiusIsRefused) {
  expect_faults(faults_in<Disc>(R"({"center":[0,0,0],"normal":[0,0,0],"radius":1})"),
                {{out_of_range, "/normal", "[0,0,0]", "a direction of some length"}});
  expect_faults(faults_in<Disc>(R"({"center":[0,0,0],"normal":[0,0,0],"radius":0})"),
                {{out_of_range, "/radius", "0", "above 0"}});
  EXPECT_TRUE(faults_in<Disc>(R"({"center":[0,0,0],"normal":[0,0,5],"radius":1})").empty());
}

}  // namespace
}  // namespace tia
