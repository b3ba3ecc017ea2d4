// Glass within glass: what is around a ray once it has entered and left several bodies.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// The ray and what becomes of it at one surface after the other.
std::vector<const RayNode*> way_through(const RayNode& first) {
  std::vector<const RayNode*> way{&first};
  while (const RayNode* next = child(*way.back(), TermName::refraction)) way.push_back(next);
  return way;
}

TEST(Media, BubbleInGlassIsLessDenseThanWhatIsAroundIt) {
  // Concentric balls, n 1.5 outside and 1 inside: straight through the middle nothing bends; a ray
  // aside bends at four surfaces by n r sin(angle) = const (Bouguer), symmetric about its middle.
  Scene scene;
  scene.objects = {object(Sphere{{0, 0, 0}, 2}, clear_glass(1.5)),
                   object(Sphere{{0, 0, 0}, 1}, clear_glass(1))};
  for (const double aside : {0.0, 0.4, 0.9}) {
    const auto node = tree(scene, {aside, 0, 5}, {0, 0, -1}, at_depth(8));
    const std::vector<const RayNode*> way = way_through(*node);
    ASSERT_EQ(way.size(), 5U);
    const double index[] = {1, 1.5, 1, 1.5, 1};
    for (std::size_t i = 0; i < 5; ++i) {
      const Vec3d o = static_cast<Vec3d>(way[i]->ray.origin);
      const Vec3d d = static_cast<Vec3d>(way[i]->ray.direction);
      EXPECT_NEAR(index[i] * length(cross(o, d)), aside, 2e-4) << i;
    }
  }
}

TEST(Media, OverlappingObjectsCountInTheOrderInWhichTheyWereEntered) {
  // Along z: into a (n 1.5) at 0, into b (n 2) at 1, out of a at 2, out of b at 3.
  Scene scene;
  scene.objects = {object(Box{{-9, -9, -2}, {9, 9, 0}}, clear_glass(1.5)),
                   object(Box{{-9, -9, -3}, {9, 9, -1}}, clear_glass(2))};
  const double angle = 0.6;
  const auto node = tree(scene, {-3, 0, 1}, {std::sin(angle), 0, -std::cos(angle)}, at_depth(8));
  const std::vector<const RayNode*> way = way_through(*node);
  ASSERT_EQ(way.size(), 5U);
  // Leaving a: from 1.5 to what is still around, b's 2; leaving b: from 2 to nothing.
  const double ratio[] = {1 / 1.5, 1.5 / 2, 1.5 / 2, 2.0};
  double sine = std::sin(angle);
  for (std::size_t i = 0; i < 4; ++i) {
    sine *= ratio[i];
    EXPECT_NEAR(double(way[i + 1]->ray.direction.x), sine, 2e-6) << i;
  }
}

TEST(Media, SolidWithAHoleIsEnteredWhereItIsCut) {
  // A ball with a ball cut out of it: air, glass, air, glass, air.
  Csg shell;
  shell.operation = Operation::difference;
  shell.children = {object(Sphere{{0, 0, 0}, 2}, clear_glass(1.5)),
                    object(Sphere{{0, 0, 0}, 1}, clear_glass(1.5))};
  Scene scene;
  scene.objects = {object(shell, clear_glass(1.5))};
  const auto node = tree(scene, {0.5, 0, 5}, {0, 0, -1}, at_depth(8));
  const std::vector<const RayNode*> way = way_through(*node);
  ASSERT_EQ(way.size(), 5U);
  const double index[] = {1, 1.5, 1, 1.5, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3d o = static_cast<Vec3d>(way[i]->ray.origin);
    EXPECT_NEAR(index[i] * length(cross(o, static_cast<Vec3d>(way[i]->ray.direction))), 0.5, 2e-4);
  }
}

}  // namespace
}  // namespace tia
