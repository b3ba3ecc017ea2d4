// Which points of a model a still shows.
#include <algorithm>

#include "core/scene/still_framing.h"
#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

// A triangle with a fourth vertex that it does not use, in a node at (1, 0, 0).
Model triangle_model() {
  Model model;
  ModelPart part;
  part.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 100, 100, 100};
  part.indices = {0, 1, 2};
  model.meshes.resize(1);
  model.meshes[0].parts = {part};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.nodes[0].placement.translation = {1, 0, 0};
  model.scenes.resize(1);
  model.scenes[0].nodes = {0};
  return model;
}

TEST(StillPointsOf, AreTheCornersOfTrianglesWhereTheyStand) {
  const Model model = triangle_model();
  const Affine to_scene{{0, 0, -2}, {0, 2, 0}, {2, 0, 0}, {0, 0, 5}};
  const StillPoints points = still_points(model, pose_of(model), to_scene, 0.25);
  // p + (1, 0, 0), then (x, y, z) to (2z, 2y, 5 - 2x).
  EXPECT_EQ(points.corners, (std::vector<Vec3d>{{0, 0, 3}, {0, 0, 1}, {0, 2, 3}}));
  EXPECT_TRUE(points.balls.empty());
  EXPECT_EQ(points.ball_radius, 0.25);
}

TEST(StillPointsOf, PointsAreBallsAndInstancesCountEach) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.points = true;
  part.indices.clear();
  model.nodes[0].instances.resize(2);
  model.nodes[0].instances[1].translation = {0, 0, 7};
  const StillPoints points = still_points(model, pose_of(model), {});
  EXPECT_TRUE(points.corners.empty());
  EXPECT_EQ(points.balls, (std::vector<Vec3d>{{1, 0, 0},
                                              {2, 0, 0},
                                              {1, 1, 0},
                                              {101, 100, 100},
                                              {1, 0, 7},
                                              {2, 0, 7},
                                              {1, 1, 7},
                                              {101, 100, 107}}));
}

TEST(StillPointsOf, HiddenNodesAndThoseWithoutAMeshHaveNone) {
  Model model = triangle_model();
  Pose pose = pose_of(model);
  EXPECT_FALSE(still_points(model, pose, {}).empty());
  pose.shown.clear();
  EXPECT_TRUE(still_points(model, pose, {}).empty());
  model.nodes[0].mesh.reset();
  EXPECT_TRUE(still_points(model, pose_of(model), {}).empty());
}

// Two skinned halves are where the skin puts them, whatever their node says.
TEST(StillPointsOf, ASkinMovesThemInsteadOfTheNode) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.joints.assign(16, 0);
  for (int i = 0; i < 4; ++i) part.weights.insert(part.weights.end(), {1, 0, 0, 0});
  model.nodes.resize(2);
  model.nodes[1].placement.translation = {0, 0, 9};
  model.scenes[0].nodes = {0, 1};
  model.skins.resize(1);
  model.skins[0].joints = {1};
  model.skins[0].inverse_binds = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  model.nodes[0].skin = 0;
  const StillPoints points = still_points(model, pose_of(model), {});
  EXPECT_EQ(points.corners, (std::vector<Vec3d>{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}));
}

// 2^22 points and their boxes' corners: those have the same bounds.
TEST(StillPointsOf, OfTooManyTheBoxesCornersCount) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  constexpr std::size_t vertices = std::size_t{1} << 20U, places = 7;
  part.points = true;
  part.indices.clear();
  part.positions.assign(3 * vertices, 0);
  for (std::size_t i = 0; i < vertices; ++i)
    part.positions[3 * i + i % 3] = static_cast<double>(i % 7) - 3;
  model.nodes[0].instances.resize(places);
  for (std::size_t i = 0; i < places; ++i)
    model.nodes[0].instances[i].translation = {static_cast<double>(i), 0, 0};
  const StillPoints points = still_points(model, pose_of(model), {});
  EXPECT_EQ(points.balls.size(), 4 * vertices + 3 * 8);
  Aabb box;
  for (const Vec3d& p : points.balls) box = around(box, p);
  EXPECT_EQ(box, (Aabb{{-2, -3, -3}, {10, 3, 3}}));
}

}  // namespace
}  // namespace tia
