// Images in mirrors, each looked for where it must stand.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

double distance_of(const RayNode& first, int& mirrors) {
  double sum = static_cast<double>(first.hit.t);
  mirrors = 0;
  for (const RayNode* at = child(first, TermName::reflection); at != nullptr;
       at = child(*at, TermName::reflection)) {
    sum += static_cast<double>(at->hit.t);
    ++mirrors;
  }
  return sum;
}

// Between two mirrors that meet at pi / k a thing at the angle a has its images on its own circle,
// at 2 j pi / k + a after an even number of reflections and at 2 j pi / k - a after an odd one:
// with the thing itself 2 k of them, all seen from everywhere between, as far as they seem. Source:
// Hecht, Optics, ch. 5, the kaleidoscope.
TEST(Images, StandOnTheCircleOfTheThing) {
  Random random(470);
  for (const int k : {2, 3, 4}) {
    for (int i = 0; i < 40; ++i) {
      const double wedge = pi / k, radius = random.in(1, 3);
      const double a = random.in(0.1, 0.9) * wedge, b = random.in(0.1, 0.9) * wedge;
      if (std::fabs(a - b) < 0.05 * wedge) continue;
      const Onb frame = onb_around(random.direction());
      const auto at = [&](double angle, double far, double up) {
        return (frame.u * std::cos(angle) + frame.v * std::sin(angle)) * far + frame.n * up;
      };
      const double size = 0.01;
      Scene scene;
      Finish glow = dark();
      glow.emission = {1, 1, 1};
      scene.objects = {object(Plane{{0, 0, 0}, at(pi / 2, 1, 0)}, mirror(1)),
                       object(Plane{{0, 0, 0}, at(wedge - pi / 2, 1, 0)}, mirror(1)),
                       object(Sphere{at(a, radius, 0), size}, glow)};
      const double up = random.in(-1, 1), far = random.in(1, 3);
      const Vec3d eye = at(b, far, up);  // by this seed nowhere behind the thing
      for (int j = 0; j < k; ++j) {
        for (const double side : {1.0, -1.0}) {
          const Vec3d image = at(2 * j * wedge + side * a, radius, 0);
          const auto node = tree(scene, eye, image - eye, at_depth(k + 1));
          int mirrors = 0;
          EXPECT_NEAR(distance_of(*node, mirrors), length(image - eye) - size, 1e-4);
          EXPECT_EQ(mirrors % 2, side < 0 ? 1 : 0);
          EXPECT_LE(mirrors, k);
          EXPECT_EQ(node->color, (Vec3f{1, 1, 1})) << 180 / k << " degrees, " << j << " " << side;
        }
      }
    }
  }
}

// One after the other: a thing between facing mirrors has an image in the other for each order, at
// the distances of the unfolded room.
TEST(Images, OfFacingMirrorsStandInARow) {
  Random random(471);
  for (int i = 0; i < 50; ++i) {
    const double wide = random.in(1, 3), x = random.in(0.2, 0.8) * wide, size = 0.01;
    const double eye = random.in(0.2, 0.8) * wide, aside = random.in(0.5, 2);
    Scene scene;
    Finish glow = dark();
    glow.emission = {1, 1, 1};
    const double share = random.in(0.5, 1);
    scene.objects = {object(Plane{{0, 0, 0}, {1, 0, 0}}, mirror(share)),
                     object(Plane{{wide, 0, 0}, {-1, 0, 0}}, mirror(share)),
                     object(Sphere{{x, 0, 0}, size}, glow)};
    for (int order = -4; order <= 4; ++order) {
      // The cell of that number shows the thing as it is where it is even, else turned round.
      const double place = order * wide + (order % 2 == 0 ? x : wide - x);
      const Vec3d way = Vec3d{place, 0, 0} - Vec3d{eye, aside, 0};
      const auto node = tree(scene, {eye, aside, 0}, way, at_depth(5));
      int mirrors = 0;
      EXPECT_NEAR(distance_of(*node, mirrors), length(way) - size, 1e-4);
      EXPECT_EQ(mirrors, std::abs(order));
      EXPECT_NEAR(double(node->color.x), std::pow(share, std::abs(order)), 1e-5);
    }
  }
}

// A corner any way up sends rays back, moved to the other side of its apex.
TEST(Images, CornerOfThreeSendsRaysBackThroughTheMirroredPoint) {
  Random random(472);
  for (int i = 0; i < 300; ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d apex = random.point(2);
    Scene scene;
    for (const Vec3d& n : {frame.u, frame.v, frame.n})
      scene.objects.push_back(object(Plane{apex, n}, mirror(1)));
    const auto out = [&](double x, double y, double z) {
      return frame.u * x + frame.v * y + frame.n * z;
    };
    const double x = random.in(0.2, 1), y = random.in(0.2, 1);
    const Vec3d d = normalize(out(-x, -y, -random.in(0.2, 1)));
    const double ox = random.in(1, 4), oy = random.in(1, 4);
    const Vec3d from = out(ox, oy, random.in(1, 4));
    const auto node = tree(scene, apex + from, d);
    const RayNode* at = node.get();
    while (const RayNode* next = child(*at, TermName::reflection)) at = next;
    EXPECT_EQ(at->depth, 3);
    expect_near(at->ray.direction, -d, 2e-6);
    // The way back is the way in, mirrored at the apex: at -from.
    const Vec3d back = static_cast<Vec3d>(at->ray.origin) + compile(scene).origin;
    const Vec3d off = back - apex + from;
    EXPECT_NEAR(length(cross(off, d)), 0, 2e-4);
  }
}

}  // namespace
}  // namespace tia
