// A scene's building ends when it is told to: each part of it asks for itself.
#include "core/input/stopped.h"

#include <gtest/gtest.h>

#include "core/accel/world.h"

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

}  // namespace
}  // namespace tia
