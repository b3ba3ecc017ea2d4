// Refraction by closed forms: Snell, Fresnel, slabs, absorption, lenses.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// A half space of glass below y = 0.
Scene water(double ior, bool with_fresnel = true) {
  Scene scene;
  Finish finish = glass(ior);
  finish.fresnel = with_fresnel;
  scene.background = {1, 1, 1};
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, finish)};
  return scene;
}

TEST(Glass, RefractsBySnellsLawFromBothSides) {
  Random random(410);
  for (int i = 0; i < 500; ++i) {
    const double ior = random.in(1.05, 2.5), angle = random.in(0, 1.5);
    const Scene scene = water(ior);
    const double behind = std::asin(std::sin(angle) / ior);
    const auto in = tree(scene, slanted(angle) * -2.0, slanted(angle));
    const RayNode* bent = child(*in, TermName::refraction);
    ASSERT_NE(bent, nullptr);
    expect_near(bent->ray.direction, slanted(behind), 1e-6);
    // And back the same way.
    const auto out = tree(scene, slanted(behind, false) * -2.0, slanted(behind, false));
    const RayNode* free = child(*out, TermName::refraction);
    ASSERT_NE(free, nullptr);
    EXPECT_NEAR(double(free->ray.direction.x), std::sin(angle), 2e-6 / std::cos(angle));
  }
}

TEST(Glass, TotalReflectionBeginsAtTheCriticalAngle) {
  for (const double ior : {1.1, 1.33, 1.5, 2.4}) {
    const Scene scene = water(ior);
    const double critical = std::asin(1 / ior);
    const auto below =
        tree(scene, slanted(critical - 1e-3, false) * -2.0, slanted(critical - 1e-3, false));
    EXPECT_NE(child(*below, TermName::refraction), nullptr);
    const auto beyond =
        tree(scene, slanted(critical + 1e-3, false) * -2.0, slanted(critical + 1e-3, false));
    EXPECT_EQ(child(*beyond, TermName::refraction), nullptr);
    const Term* all = term(*beyond, TermName::reflection);
    ASSERT_NE(all, nullptr);
    EXPECT_EQ(all->weight, 1.0F);
  }
}

TEST(Glass, TotalReflectionTakesTheWholeShareWithoutFresnelToo) {
  Scene scene = water(1.5, false);
  std::get<Finish>(std::get<Boxed<Material>>(*scene.objects[0].material)->kind).transmission = 0.75;
  const auto node = tree(scene, slanted(1, false) * -2.0, slanted(1, false));
  EXPECT_EQ(term(*node, TermName::refraction), nullptr);
  EXPECT_EQ(term(*node, TermName::reflection)->weight, 0.75F);
}

// Both polarisations by Fresnel's sine and tangent laws, which are written otherwise than the
// code's; at 0 their limit ((n - 1) / (n + 1))^2. Source: Born, Wolf, 1.5.2 (21a).
double fresnel_share(double in, double out) {
  const double s = std::sin(in - out) / std::sin(in + out);
  const double p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}

TEST(Glass, PartsLightByFresnelsEquationsFromBothSides) {
  for (const double ior : {1.33, 1.5, 2.4}) {
    const double brewster = std::atan(ior), normal = std::pow((ior - 1) / (ior + 1), 2);
    for (const double angle : {0.0, pi / 4, brewster, 85 * pi / 180}) {
      const double behind = std::asin(std::sin(angle) / ior);
      const double share = angle == 0 ? normal : fresnel_share(angle, behind);
      const Scene scene = water(ior);
      const auto in = tree(scene, slanted(angle) * -2.0, slanted(angle));
      EXPECT_NEAR(double(term(*in, TermName::reflection)->weight), share, 2e-6);
      EXPECT_NEAR(double(term(*in, TermName::refraction)->weight), 1 - share, 2e-6);
      const auto out = tree(scene, slanted(behind, false) * -2.0, slanted(behind, false));
      EXPECT_NEAR(double(term(*out, TermName::reflection)->weight), share,
                  angle > 1.4 ? 2e-5 : 2e-6);
    }
    // Schlick's approximation would be off by more.
    const double schlick = normal + (1 - normal) * std::pow(1 - std::cos(pi / 4), 5);
    EXPECT_GT(std::fabs(schlick - fresnel_share(pi / 4, std::asin(std::sin(pi / 4) / ior))), 1e-3);
  }
}

// ---- slabs --------------------------------------------------------------------------------------

Scene slab(double thickness, const Finish& finish) {
  Scene scene;
  scene.objects = {object(Box{{-1e3, -thickness, -1e3}, {1e3, 0, 1e3}}, finish)};
  return scene;
}
TEST(Glass, SlabDisplacesARayThatLeavesItParallel) {
  Random random(411);
  for (int i = 0; i < 200; ++i) {
    const double ior = random.in(1.1, 2.5), thick = random.in(0.5, 3), angle = random.in(0, 1.3);
    const auto node = tree(slab(thick, clear_glass(ior)), slanted(angle) * -2.0, slanted(angle));
    const RayNode* inside = child(*node, TermName::refraction);
    ASSERT_NE(inside, nullptr);
    const RayNode* beyond = child(*inside, TermName::refraction);
    ASSERT_NE(beyond, nullptr);
    expect_near(beyond->ray.direction, slanted(angle), 3e-6);
    // d sin(a - b) / cos b aside; Hecht, Optics, ch. 4.
    const double b = std::asin(std::sin(angle) / ior);
    const Vec3d from = static_cast<Vec3d>(beyond->ray.origin);
    const Vec3d aside = from - slanted(angle) * dot(from, slanted(angle));
    EXPECT_NEAR(length(aside), thick * std::sin(angle - b) / std::cos(b), 1e-4);
  }
}

TEST(Glass, SlabsReflectionsAddUpToTheWholeSeries) {
  // A light sky above, nothing below: what comes back from a slab is
  // F + (1-F)^2 F / (1 - F^2) = 2F / (1 + F), of both faces and all orders.
  Scene scene = slab(1, glass(1.5));
  Finish black = dark();
  scene.objects.push_back(object(Plane{{0, -5, 0}, {0, 1, 0}}, black));
  scene.background = {1, 1, 1};
  for (const double angle : {0.0, 0.5, 1.0, 1.4}) {
    const double behind = std::asin(std::sin(angle) / 1.5);
    const double f = angle == 0 ? 0.04 : fresnel_share(angle, behind);
    const auto node = tree(scene, slanted(angle) * -2.0, slanted(angle), at_depth(40));
    EXPECT_NEAR(double(node->color.x), 2 * f / (1 + f), 5e-6);
    // And each order by its own: to depth 2 there are F and (1-F)^2 F.
    const auto few = tree(scene, slanted(angle) * -2.0, slanted(angle), at_depth(3));
    EXPECT_NEAR(double(few->color.x), f + (1 - f) * (1 - f) * f, 5e-6);
  }
}

TEST(Glass, AbsorbsByBeerAndLambertAlongThePathInside) {
  Random random(412);
  for (int i = 0; i < 200; ++i) {
    Finish finish = clear_glass(random.in(1, 2.5));
    const double r = random.in(0, 2), g = random.in(0, 2), thick = random.in(0.2, 2);
    finish.absorption = {r, g, 0};
    Scene scene = slab(thick, finish);
    scene.background = {1, 1, 1};
    const double angle = random.in(0, 1.3), b = std::asin(std::sin(angle) / finish.ior);
    const double path = thick / std::cos(b);
    const auto node = tree(scene, slanted(angle) * -2.0, slanted(angle));
    expect_near(node->color, {std::exp(-r * path), std::exp(-g * path), 1}, 2e-5);
  }
}

TEST(Glass, BallAbsorbsAlongItsChord) {
  Finish finish = clear_glass(1);
  finish.absorption = {0.7, 0, 0.1};
  Scene scene;
  scene.background = {1, 1, 1};
  scene.objects = {object(Sphere{{0, 0, -5}, 2}, finish)};
  for (const double aside : {0.0, 0.5, 1.5, 1.9}) {
    const double chord = 2 * std::sqrt(4 - aside * aside);
    const auto node = tree(scene, {aside, 0, 0}, {0, 0, -1});
    expect_near(node->color, {std::exp(-0.7 * chord), 1, std::exp(-0.1 * chord)}, 2e-5);
  }
}

TEST(Glass, IndexOneIsInvisible) {
  Scene scene;
  scene.camera.location = {0, 1, 5};
  scene.objects = {ball({0, 0, -4}, 1.5), object(Plane{{0, -2, 0}, {0, 1, 0}}, Finish{})};
  scene.lights = {point_light({5, 8, 3})};
  scene.camera.fov_degrees = 50;
  scene.options.transparent_shadows = true;
  const Image without = picture(scene, 80, 60, {0, 0, 80, 60}, at_depth(5)).image;
  scene.objects.push_back(object(Sphere{{0.3, 0, -1}, 1.2}, clear_glass(1)));
  const Image with = picture(scene, 80, 60, {0, 0, 80, 60}, at_depth(5)).image;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < without.rgb.size(); ++i)
    differ += std::fabs(without.rgb[i] - with.rgb[i]) > 1e-4F;
  EXPECT_LT(differ, without.rgb.size() / 500) << "edges of shadows aside";
}

TEST(Glass, ApparentDepthIsTheTrueOneOverTheIndex) {
  // Near the vertical a thing at depth d under water seems to lie at d / n.
  const double angle = 1e-2, ior = 1.33;
  const auto node = tree(water(ior), slanted(angle) * -2.0, slanted(angle));
  const RayNode* below = child(*node, TermName::refraction);
  ASSERT_NE(below, nullptr);
  const double drift = below->ray.direction.x / -below->ray.direction.y;  // per depth
  EXPECT_NEAR(std::tan(angle) / drift, ior, 1e-4);
}

TEST(Glass, BallLensFocusesByTheClosedFormWithItsSphericalAberration) {
  // A ray at height h meets the axis at -r sin(a) / sin(2(a - b)) ... from the centre, sin a = h/r,
  // sin b = h/(n r); near the axis n r / (2 (n - 1)).
  const double ior = 1.5, r = 1;
  Scene scene;
  scene.objects = {object(Sphere{{0, 0, 0}, r}, clear_glass(ior))};
  for (const double h : {0.01, 0.2, 0.5, 0.8}) {
    const auto node = tree(scene, {h, 0, 5}, {0, 0, -1}, at_depth(4));
    const RayNode* out = child(*child(*node, TermName::refraction), TermName::refraction);
    ASSERT_NE(out, nullptr);
    const auto& [o, d] = out->ray;
    const double focus = -(o.z - o.x / d.x * d.z);
    const double a = std::asin(h / r), b = std::asin(h / (ior * r));
    EXPECT_NEAR(focus, h / std::sin(2 * (a - b)), h < 0.1 ? 2e-3 : 2e-5);
  }
  EXPECT_NEAR(0.01 / std::sin(2 * (std::asin(0.01) - std::asin(0.01 / ior))),
              ior * r / (2 * (ior - 1)), 1e-4);
}

TEST(Glass, EveryOrderBeyondTheDepthIsBlackAndItsWeightIsLost) {
  Scene scene = water(1.5);
  const auto node = tree(scene, {0, 2, 0}, {0, -1, 0}, at_depth(0));
  EXPECT_EQ(node->color, (Vec3f{0, 0, 0}));
}

}  // namespace
}  // namespace tia
