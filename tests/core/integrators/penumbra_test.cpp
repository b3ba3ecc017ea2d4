// Soft shadows of a ball under a luminous ball, by closed forms of their tangents and of the share
// of one disc that another covers.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// A luminous ball of radius `big` at the height `top`, a ball of radius `small` at `low` below it,
// and the floor at 0.
struct BallUnderLamp {
  double big, top, small, low;
  Scene scene;

  BallUnderLamp(double light_radius, double light_height, double radius, double height, int samples)
      : big(light_radius), top(light_height), small(radius), low(height) {
    Light light = sphere_light({0, top, 0}, big);
    std::get<SphereLight>(light.kind).samples = samples;
    scene.lights = {light};
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{}),
                     ball({0, low, 0}, small, matte({0, 0, 0}))};
  }
  double visible(double x) const {
    const double eye = (low - small) / 2;
    const auto node = tree(scene, {x, eye, 0}, {0, -1, 0});
    return double(term(*node, TermName::diffuse)->light.visible);
  }
  // Where a line that touches both balls meets the floor: its angle to the axis has the sine
  // (r - R) / gap where it touches them on one side, (r + R) / gap on different ones, and it meets
  // the axis r / sine above the lower ball's middle.
  double rim(double sum) const {
    const double angle = std::asin(sum / (top - low));
    return small / std::cos(angle) + low * std::tan(angle);
  }
  double umbra() const { return rim(small - big); }
  double penumbra() const { return rim(small + big); }
};

TEST(Penumbra, UmbraAndPenumbraEndAtTheTangents) {
  Random random(460);
  for (int i = 0; i < 25; ++i) {
    const double low = random.in(2, 5), top = low + random.in(4, 9), small = random.in(0.7, 1.3);
    const BallUnderLamp stage(random.in(0.2, 0.6), top, small, low, 1024);
    const double umbra = stage.umbra(), penumbra = stage.penumbra(), width = penumbra - umbra;
    ASSERT_GT(umbra, 0);
    for (const double share : {0.0, 0.5, 0.999}) EXPECT_EQ(stage.visible(share * umbra), 0);
    EXPECT_GT(stage.visible(umbra + 0.05 * width), 0);
    EXPECT_LT(stage.visible(penumbra - 0.05 * width), 1);
    for (const double share : {1.001, 1.5}) EXPECT_EQ(stage.visible(share * penumbra), 1);
  }
}

// Beyond the tip of the umbra the ball covers the middle of the light, and of the cone of the
// light's directions the share of its own: (1 - cos(b)) / (1 - cos(a)), sin(a) = R / top, sin(b) =
// r / low.
TEST(Penumbra, RingAroundAFarBallIsTheDifferenceOfTheCones) {
  Random random(461);
  for (int i = 0; i < 25; ++i) {
    const double low = random.in(4, 6), top = low + random.in(4, 9), big = random.in(2, 3);
    const double small = random.in(0.2, 0.9) * big * low / top;
    const BallUnderLamp stage(big, top, small, low, 4096);
    const auto height = [](double sine) { return 1 - std::sqrt(1 - sine * sine); };
    EXPECT_NEAR(stage.visible(0), 1 - height(small / low) / height(big / top), 6e-3);
  }
}

// Elsewhere: the share of the light's directions that miss the ball, even over the solid angle,
// counted on a lattice in double.
TEST(Penumbra, IsTheShareOfTheLampsSolidAngleThatIsSeen) {
  Random random(462);
  constexpr int n = 300;
  for (int i = 0; i < 12; ++i) {
    const double low = random.in(2, 4), top = low + random.in(3, 6), small = random.in(0.4, 1.2);
    const BallUnderLamp stage(random.in(0.3, 1.5), top, small, low, 4096);
    const double x = random.in(0, 1.1) * stage.penumbra();
    const Vec3d p{x, 0, 0}, to_lamp = Vec3d{0, top, 0} - p, to_ball = Vec3d{0, low, 0} - p;
    const Onb frame = onb_around(normalize(to_lamp));
    const double sine = stage.big / length(to_lamp), edge = std::sqrt(1 - sine * sine);
    int seen = 0;
    for (int k = 0; k < n; ++k) {
      for (int m = 0; m < n; ++m) {
        const double cosine = 1 - (1 - edge) * (k + 0.5) / n, turn = 2 * pi * (m + 0.5) / n;
        const double aside = std::sqrt(1 - cosine * cosine);
        const Vec3d way = frame.n * cosine + frame.u * (aside * std::cos(turn)) +
                          frame.v * (aside * std::sin(turn));
        seen += length(cross(to_ball, way)) > small;
      }
    }
    EXPECT_NEAR(stage.visible(x), double(seen) / (n * n), 6e-3) << x;
  }
}

// A straight edge: a quad's light is covered in proportion as an opaque half plane comes before it.
TEST(Penumbra, HalfPlaneCoversAQuadInProportion) {
  Random random(463);
  for (int i = 0; i < 30; ++i) {
    const double half = random.in(0.2, 1), top = random.in(4, 9), low = top * random.in(0.2, 0.8);
    QuadLight quad;
    quad.corner = Vec3d{-half, top, -half};
    quad.u = {2 * half, 0, 0};
    quad.v = {0, 0, 2 * half};
    quad.samples = 1024;
    Light light;
    light.kind = quad;
    Scene scene;
    scene.lights = {light};
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{}),
                     object(Box{{0, low, -99}, {99, low + 1e-3, 99}}, dark())};
    // From x the edge at (0, low) is seen before the light's x + (0 - x) top / low.
    const double x = random.in(-1.2, 1.2) * half * low / (top - low);
    const double cut = std::clamp((x - x * top / low + half) / (2 * half), 0.0, 1.0);
    const auto node = tree(scene, {x, low / 2, 0}, {0, -1, 0});
    EXPECT_NEAR(double(term(*node, TermName::diffuse)->light.visible), cut, 0.02) << x;
  }
}

}  // namespace
}  // namespace tia
