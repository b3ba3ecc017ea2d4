// Glass by closed forms at random indices, angles and lengths: what mirror and glass share, plates,
// balls, and glass that is not there.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

Finish clear(double ior, bool fresnel = false) {
  Finish finish = glass(ior);
  finish.fresnel = fresnel;
  return finish;
}
double bent(double angle, double ior) { return std::asin(std::sin(angle) / ior); }

// Amplitudes by the sine and tangent laws. Source: Born, Wolf, 1.5.2 (21a).
double mirrored_share(double in, double out) {
  const double s = std::sin(in - out) / std::sin(in + out);
  const double p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}
// Schlick, "An inexpensive BRDF model for physically-based rendering", 1994: not what we want.
double schlick(double angle, double ior) {
  const double normal = std::pow((ior - 1) / (ior + 1), 2);
  return normal + (1 - normal) * std::pow(1 - std::cos(angle), 5);
}

struct Plate {
  Scene scene;
  Plate(double thickness, const Finish& finish) {
    scene.objects = {object(Box{{-1e3, -thickness, -1e3}, {1e3, 0, 1e3}}, finish)};
  }
  std::unique_ptr<RayNode> at(double angle, int depth = 5) const {
    return tree(scene, slanted(angle) * -2.0, slanted(angle), at_depth(depth));
  }
};

TEST(Slab, FresnelsSharesHoldAtEveryAngleFromBothSidesAndSchlicksDoNot) {
  Random random(480);
  int told = 0;
  for (int i = 0; i < 500; ++i) {
    const double ior = random.in(1.2, 3), angle = random.in(0.05, 1.45);
    const double share = mirrored_share(angle, bent(angle, ior));
    const auto node = Plate(1, clear(ior, true)).at(angle);
    EXPECT_NEAR(double(term(*node, TermName::reflection)->weight), share, 3e-6);
    EXPECT_NEAR(double(term(*node, TermName::refraction)->weight), 1 - share, 3e-6);
    const RayNode* inside = child(*node, TermName::refraction);
    EXPECT_NEAR(double(term(*inside, TermName::reflection)->weight), share, 3e-5) << angle;
    EXPECT_NEAR(double(term(*inside, TermName::refraction)->weight), 1 - share, 3e-5) << angle;
    told += std::fabs(schlick(angle, ior) - share) > 1e-3;
  }
  EXPECT_GT(told, 300) << "shares by Schlick's formula would have failed";
}

TEST(Slab, AtBrewstersAngleTheMirroredRayIsAcrossTheRefractedOne) {
  Random random(481);
  for (int i = 0; i < 100; ++i) {
    const double ior = random.in(1.1, 2.5), angle = std::atan(ior);
    const auto node = Plate(1, clear(ior, true)).at(angle);
    const RayNode *back = child(*node, TermName::reflection),
                  *on = child(*node, TermName::refraction);
    EXPECT_NEAR(double(dot(back->ray.direction, on->ray.direction)), 0, 2e-6);
    // One polarisation goes through whole: half of ((n^2 - 1) / (n^2 + 1))^2 is mirrored.
    const double across = (ior * ior - 1) / (ior * ior + 1);
    EXPECT_NEAR(double(term(*node, TermName::reflection)->weight), across * across / 2, 2e-6);
  }
}

TEST(Slab, RayLeavesWhereSnellSaysParallelToItself) {
  Random random(482);
  for (int i = 0; i < 300; ++i) {
    const double ior = random.in(1.1, 2.5), thick = random.in(0.5, 3), angle = random.in(0, 1.3);
    const auto node = Plate(thick, clear(ior)).at(angle);
    const RayNode* inside = child(*node, TermName::refraction);
    const RayNode* beyond = child(*inside, TermName::refraction);
    expect_near(beyond->ray.origin, {thick * std::tan(bent(angle, ior)), -thick, 0}, 5e-5);
    expect_near(beyond->ray.direction, slanted(angle), 3e-6);
  }
}

TEST(Slab, ApparentDepthIsTheTrueOneOverTheIndexAndTimesItFromBelow) {
  Random random(483);
  for (int i = 0; i < 100; ++i) {
    const double ior = random.in(1.1, 2.5), angle = random.in(5e-3, 1e-2);
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, clear(ior))};
    const auto drift = [](const RayNode& node) {
      const auto& d = child(node, TermName::refraction)->ray.direction;
      return double(d.x) / std::fabs(double(d.y));
    };
    const auto down = tree(scene, slanted(angle) * -2.0, slanted(angle));
    EXPECT_NEAR(std::tan(angle) / drift(*down), ior, 3e-4);
    const Vec3d up{std::sin(angle), std::cos(angle), 0};
    const auto from_below = tree(scene, up * -2.0, up);
    EXPECT_NEAR(std::tan(angle) / drift(*from_below), 1 / ior, 3e-4);
  }
}

TEST(Slab, TotalReflectionBeginsWithinOneHundredThousandthOfItsAngle) {
  Random random(484);
  for (int i = 0; i < 200; ++i) {
    const double ior = random.in(1.1, 3), critical = std::asin(1 / ior);
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, clear(ior, i % 2 == 0))};
    const auto goes_on = [&](double angle) {
      const Vec3d up{std::sin(angle), std::cos(angle), 0};
      return child(*tree(scene, up * -2.0, up), TermName::refraction) != nullptr;
    };
    EXPECT_TRUE(goes_on(critical - 1e-5)) << ior;
    EXPECT_FALSE(goes_on(critical + 1e-5)) << ior;
  }
}

// ---- the whole series ---------------------------------------------------------------------------

// Between faces that mirror F each, of which A is left on the way across: back come
// F + (1-F)^2 F A^2 / (1 - F^2 A^2), through go (1-F)^2 A / (1 - F^2 A^2).
// Source: Born, Wolf, 7.6, for light without phase.
TEST(Slab, SeriesOfBothSidesWithAbsorption) {
  Random random(485);
  for (int i = 0; i < 60; ++i) {
    const double ior = random.in(1.2, 2.5), thick = random.in(0.3, 2), angle = random.in(0.1, 1.4);
    Finish finish = clear(ior, true);
    const double a = random.in(0, 1), b = random.in(0, 1);
    finish.absorption = {a, b, 0};
    Plate plate(thick, finish);
    const double f = mirrored_share(angle, bent(angle, ior));
    const auto left = [&](double each) {
      return std::exp(-each * thick / std::cos(bent(angle, ior)));
    };
    const auto back = [&](double l) {
      return f + (1 - f) * (1 - f) * f * l * l / (1 - f * f * l * l);
    };
    const auto through = [&](double l) { return (1 - f) * (1 - f) * l / (1 - f * f * l * l); };
    // A black floor beneath shows what comes back, a black ceiling above the eye what goes through.
    Scene above = plate.scene, below = plate.scene;
    for (Scene* scene : {&above, &below}) scene->background = {1, 1, 1};
    above.objects.push_back(object(Plane{{0, -9, 0}, {0, 1, 0}}, dark()));
    below.objects.push_back(object(Plane{{0, 9, 0}, {0, 1, 0}}, dark()));
    const auto color = [&](const Scene& scene) {
      return tree(scene, slanted(angle) * -2.0, slanted(angle), at_depth(40))->color;
    };
    expect_near(color(above), {back(left(a)), back(left(b)), back(1)}, 1e-5);
    expect_near(color(below), {through(left(a)), through(left(b)), through(1)}, 1e-5);
    // Without absorption nothing is lost: 2F / (1 + F) and (1 - F) / (1 + F).
    EXPECT_NEAR(back(1), 2 * f / (1 + f), 1e-12);
    EXPECT_NEAR(through(1), (1 - f) / (1 + f), 1e-12);
  }
}

TEST(Slab, SeriesEndsWithTheDepthTermByTerm) {
  // To depth d, bounces inside counted, what comes back is F, then each (1-F)^2 F^(2k-1) at 2k + 1.
  const double ior = 1.7, angle = 0.8, f = mirrored_share(angle, bent(angle, ior));
  Plate plate(1, clear(ior, true));
  plate.scene.background = {1, 1, 1};
  plate.scene.objects.push_back(object(Plane{{0, -9, 0}, {0, 1, 0}}, dark()));
  for (int depth = 0; depth <= 9; ++depth) {
    double sum = depth > 0 ? f : 0;
    for (int k = 1; 2 * k + 1 <= depth; ++k) sum += (1 - f) * (1 - f) * std::pow(f, 2 * k - 1);
    EXPECT_NEAR(double(plate.at(angle, depth)->color.x), sum, 2e-6) << depth;
  }
}

// ---- balls --------------------------------------------------------------------------------------

TEST(GlassBall, AbsorbsAlongTheRefractedChord) {
  Random random(486);
  for (int i = 0; i < 300; ++i) {
    const double ior = random.in(1, 2.5), r = random.in(0.5, 3), h = random.in(0, 0.95) * r;
    Finish finish = clear(ior);
    const double a = random.in(0, 1), b = random.in(0, 1);
    finish.absorption = {a, b, 0};
    Scene scene;
    scene.background = {1, 1, 1};
    scene.objects = {object(Sphere{{0, 0, 0}, r}, finish)};
    const double chord = 2 * std::sqrt(r * r - h * h / (ior * ior));
    const auto node = tree(scene, {h, 0, 5}, {0, 0, -1});
    expect_near(node->color, {std::exp(-a * chord), std::exp(-b * chord), 1}, 2e-5);
  }
}

// A ray at the height h turns twice by a - b, sin(a) = h / r, sin(b) = h / (n r), and meets the
// axis h / sin(2 (a - b)) behind the middle: nearer than the paraxial n r / (2 (n - 1)) the higher
// it is. Source: Hecht, Optics, ch. 6, the ball lens.
TEST(GlassBall, FocusMovesInwardsWithTheHeightOfTheRay) {
  Random random(487);
  for (int i = 0; i < 100; ++i) {
    const double ior = random.in(1.2, 1.9), r = random.in(0.5, 2);
    Scene scene;
    scene.objects = {object(Sphere{{0, 0, 0}, r}, clear(ior))};
    double before = ior * r / (2 * (ior - 1));
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.85}) {
      const double h = share * r, a = std::asin(h / r), b = std::asin(h / (ior * r));
      const auto node = tree(scene, {h, 0, 5}, {0, 0, -1});
      const RayNode* out = child(*child(*node, TermName::refraction), TermName::refraction);
      ASSERT_NE(out, nullptr);
      const auto& [o, d] = out->ray;
      const double focus = -(double(o.z) - double(o.x) / double(d.x) * double(d.z));
      EXPECT_NEAR(focus, h / std::sin(2 * (a - b)), 2e-4 * before);
      EXPECT_LT(focus, before);
      before = focus;
    }
  }
}

// Equal indices mirror nothing and bend nothing, whatever is around: each ray sees what it would.
TEST(GlassBall, OfIndexOneIsInvisibleToEveryRay) {
  Random random(488);
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    Finish checked;
    checked.texture = Texture{Gradient{}};
    checked.ambient = 1;
    scene.objects = {object(Plane{{0, -3, 0}, {0, 1, 0}}, checked)};
    scene.background = {0.2, 0.5, 0.8};
    const Vec3d eye = random.direction() * 2.5, aim = random.point(0.6);
    const auto without = tree(scene, eye, aim - eye);
    Finish finish = clear(1, i % 2 == 0);
    scene.objects.push_back(object(Sphere{{0, 0, 0}, 1}, finish));
    scene.objects.push_back(object(Box{{-0.5, -0.4, -0.3}, {0.4, 0.3, 0.5}}, finish));
    const auto with = tree(scene, eye, aim - eye, at_depth(6));
    const double edge = without->point.x - std::floor(without->point.x);
    if (without->hit.t < 1e9F && (edge < 1e-3 || edge > 1 - 1e-3))
      continue;  // where it starts anew
    const double far = without->hit.t < 1e9F ? double(without->hit.t) : 0;
    expect_near(with->color, static_cast<Vec3d>(without->color), 2e-5 * (1 + far));
    EXPECT_NE(child(*with, TermName::refraction), nullptr);
    const Term* mirrored = term(*with, TermName::reflection);
    EXPECT_LT(mirrored != nullptr ? mirrored->weight : 0, 1e-12F);
  }
}

// Fresnel's equations are 0 / 0 for a ray along the surface between equal indices: all goes on.
TEST(GlassBall, OfIndexOneIsInvisibleToTheTangentToo) {
  Scene scene;
  scene.background = {0.25, 0.5, 1};
  scene.objects = {object(Sphere{{0, 0, -5}, 1}, glass(1))};
  expect_near(tree(scene, {1, 0, 0}, {0, 0, -1})->color, {0.25, 0.5, 1}, 1e-6);
}

}  // namespace
}  // namespace tia
