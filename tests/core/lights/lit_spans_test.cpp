// Where along a line a light shines: what its samples say of points of the line.
#include "core/lights/lit_spans.h"

#include <gtest/gtest.h>

#include "core/lights/spot.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

SpotForm random_spot(Random& random) {
  SpotLight spot;
  spot.position = random.point(3);
  spot.point_at = *spot.position + random.direction();
  spot.falloff_degrees = random.chance(0.2) ? 90 : random.in(0.5, 180);
  spot.radius_degrees = random.in(0, 1) * spot.falloff_degrees;
  spot.tightness = random.chance(0.3) ? random.in(0, 3) : 0;
  return prepare(spot);
}

// How far p is from the edge of what the spot lights, by cosine.
double margin(const SpotForm& spot, const Vec3d& p) {
  const double cosine = dot(normalize(p - spot.position.exact), spot.axis.exact);
  const double edge = spot.tightness > 0 ? std::max(spot.cos_falloff, 0.0) : spot.cos_falloff;
  return cosine - edge;
}

TEST(LitSpans, AreWhereASpotShines) {
  Random random(960);
  int lit = 0, dark = 0, twice = 0;
  for (int round = 0; round < test::rounds(4000); ++round) {
    const SpotForm spot = random_spot(random);
    Vec3d direction = random.direction();
    const Vec3d axis = spot.axis.exact;
    if (round % 8 == 0) direction = normalize(cross(axis, direction));  // across, through, along
    Vec3d origin = random.point(6);
    if (round % 8 == 1) origin = spot.position.exact - direction * random.in(0, 5);
    if (round % 8 == 2) direction = axis;
    const LitSpans spans = lit_spans(spot, origin, direction);
    twice += spans.count == 2 ? 1 : 0;
    for (int i = 0; i < 40; ++i) {
      const double t = i < 30 ? random.in(-12, 12) : random.in(-1, 1) * std::pow(10, i - 30);
      const Vec3d p = origin + direction * t;
      if (std::fabs(margin(spot, p)) < 1e-8) continue;
      const bool inside = std::any_of(spans.begin(), spans.end(), [&](const LitSpans::Span& span) {
        return span.from <= t && t <= span.to;
      });
      ASSERT_EQ(inside, margin(spot, p) > 0) << round << ' ' << t;
      const double strength = sample_li(spot, p).strength;
      if (!inside) {
        ASSERT_EQ(strength, 0);
      }
      ++(inside ? lit : dark);
    }
  }
  EXPECT_GT(std::min(lit, dark), test::rounds(20000));
  EXPECT_GT(twice, test::rounds(100));
}

}  // namespace
}  // namespace tia
