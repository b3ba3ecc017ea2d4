// Which points of a model a still shows.
#include "core/scene/still_points.h"

#include "tests/core/scene/models.h"
#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

using Points = std::vector<Vec3d>;

StillPoints points_shown(const Model& model, const std::string& members = "") {
  return points_of(shown_by(model, members));
}
// With a fourth vertex that the triangle does not use.
Model sheet_and_stray() {
  Model model = test::triangle_model();
  std::vector<double>& positions = model.meshes[0].parts[0].positions;
  positions.insert(positions.end(), {100, 100, 100});
  return model;
}
Model cloud_model() {
  Model model = sheet_and_stray();
  model.meshes[0].parts[0].points = true;
  model.meshes[0].parts[0].indices.clear();
  return model;
}

TEST(StillPointsOf, AreTheCornersOfTrianglesWhereTheyStand) {
  Model model = sheet_and_stray();
  model.nodes[0].placement.translation = {1, 0, 0};
  const StillPoints points = points_shown(model, R"("up":"z")");
  // p + (1, 0, 0), then (x, y, z) to (x, z, -y).
  EXPECT_EQ(points.corners, (Points{{1, 0, 0}, {5, 0, 0}, {1, 0, -2}}));
  EXPECT_TRUE(points.balls.empty());
  EXPECT_FALSE(points.empty());
}

// The sheet is 4 wide and 2 high: it fills the width of a box of 1.
TEST(StillPointsOf, AreWhereTheModelIsFitted) {
  const StillPoints points =
      points_shown(sheet_and_stray(), R"("fit":{"min":[0,0,0],"max":[1,1,1],"align":[0,0,0]})");
  // The box is that of all vertices, 100 on each side.
  expect_near_points(points.corners, {{0, 0, 0}, {0.04, 0, 0}, {0, 0.02, 0}}, 1e-15);
}

TEST(StillPointsOf, PointsAreBallsAndInstancesCountEach) {
  Model model = cloud_model();
  model.nodes[0].instances.resize(2);
  model.nodes[0].instances[1].translation = {0, 0, 7};
  const StillPoints points = points_shown(model, R"("point_radius":0.25)");
  EXPECT_TRUE(points.corners.empty());
  EXPECT_EQ(points.ball_radius, 0.25);
  EXPECT_EQ(points.balls, (Points{{0, 0, 0},
                                  {4, 0, 0},
                                  {0, 2, 0},
                                  {100, 100, 100},
                                  {0, 0, 7},
                                  {4, 0, 7},
                                  {0, 2, 7},
                                  {100, 100, 107}}));
}

TEST(StillPointsOf, WhatIsHiddenHasNone) {
  EXPECT_TRUE(points_shown(sheet_and_stray(), R"("hide":["paint"])").empty());
  EXPECT_TRUE(points_shown(cloud_model(), R"("hide":["root"])").empty());
}

// Two skinned halves are where the skin puts them, whatever their node says.
TEST(StillPointsOf, ASkinMovesThemInsteadOfTheNode) {
  Model model = test::triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.joints.assign(12, 0);
  for (int i = 0; i < 3; ++i) part.weights.insert(part.weights.end(), {1, 0, 0, 0});
  model.nodes[0].placement.translation = {1, 0, 0};
  model.nodes.resize(2);
  model.nodes[1].placement.translation = {0, 0, 9};
  model.scenes[0].nodes = {0, 1};
  model.skins.resize(1);
  model.skins[0].joints = {1};
  model.skins[0].inverse_binds = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  model.nodes[0].skin = 0;
  EXPECT_EQ(points_shown(model).corners, (Points{{0, 0, 9}, {4, 0, 9}, {0, 2, 9}}));
}

// 2^22 vertices and their boxes' corners: those have the same bounds.
TEST(StillPointsOf, OfTooManyTheBoxesCornersCount) {
  constexpr std::size_t vertices = std::size_t{3} << 18U, places = 7;
  Mesh mesh;
  std::vector<double>& positions = mesh.positions.values.edit();
  positions.assign(3 * vertices, 0);
  for (std::size_t i = 0; i < vertices; ++i) {
    positions[3 * i + i % 3] = static_cast<double>(i % 7) - 3;
    mesh.indices.values.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<Object> shown;
  for (std::size_t i = 0; i < places; ++i)
    shown.push_back({"", mesh, {{Translate{{static_cast<double>(i), 0, 0}}}}, {}});
  const StillPoints points = points_of(shown);
  EXPECT_EQ(points.corners.size(), 5 * vertices + 2 * 8);
  Aabb box;
  for (const Vec3d& p : points.corners) box = around(box, p);
  EXPECT_EQ(box, (Aabb{{-3, -3, -3}, {9, 3, 3}}));
}

}  // namespace
}  // namespace tia
