// A scene's building ends when it is told to: each primitive of it asks for itself.
#include "core/parallel/stopped.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/accel/world/world.h"
#include "tests/sanitizer.h"

namespace tia {
namespace {

std::stop_token asked() {
  std::stop_source source;
  source.request_stop();
  return source.get_token();
}

Mesh one_triangle() {
  Mesh mesh;
  mesh.positions.values = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.indices.values = {0, 1, 2};
  return mesh;
}

TEST(StoppedBuild, EndsBetweenObjects) {
  Scene scene;
  EXPECT_NO_THROW(compile(scene, asked()));
  scene.objects.emplace_back().shape = Sphere{};
  EXPECT_THROW(compile(scene, asked()), Stopped);
}

TEST(StoppedBuild, EndsInsideAMesh) {
  EXPECT_THROW(MeshIndex(one_triangle(), asked()), Stopped);
  EXPECT_EQ(MeshIndex(one_triangle(), std::stop_source().get_token()).triangles.size(), 1U);
}

TEST(StoppedBuild, EndsInsideAnIndex) {
  const std::vector<Box32> boxes(2, Box32{{0, 0, 0}, {1, 1, 1}});
  EXPECT_THROW(build_bvh(boxes, asked()), Stopped);
  EXPECT_EQ(build_bvh(boxes, std::stop_source().get_token()).order.size(), 2U);
}

using Clock = std::chrono::steady_clock;

// Of a solid with so many operands, each of which takes a moment to build.
Scene costly_solid(std::size_t operands) {
  Implicit costly;
  costly.f = "x^2 + y^2 + z^2 - 1";
  for (int i = 0; i < test::rounds(40, 4); ++i)
    costly.f = "(" + costly.f + ") + 0.01 * sin(7 * x * y + z)";
  costly.bounds.min = Vec3d{-2, -2, -2};
  costly.bounds.max = Vec3d{2, 2, 2};
  Csg all;
  all.children.resize(operands);
  for (Object& each : all.children) each.shape = costly;
  Scene scene;
  scene.objects.emplace_back().shape = all;
  return scene;
}

// However fast the processor is: in less time than a tenth of them takes.
TEST(StoppedBuild, EndsBetweenTheOperandsOfASolid) {
  constexpr std::size_t operands = 300;
  const Scene few = costly_solid(2), all = costly_solid(operands);
  const auto begin = Clock::now();
  compile(few);
  const auto one = (Clock::now() - begin) / 2;
  std::stop_source source;
  const auto start = Clock::now();
  std::jthread asks([&] {
    std::this_thread::sleep_for(one);
    source.request_stop();
  });
  EXPECT_THROW(compile(all, source.get_token()), Stopped);
  EXPECT_LT(Clock::now() - start, one * (operands / 10));
}

}  // namespace
}  // namespace tia
