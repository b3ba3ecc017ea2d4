// Where what a model shows stands: nodes, which way up, in which box.
#include <gtest/gtest.h>

#include "core/accel/world/world.h"
#include "tests/core/models/random_model.h"
#include "tests/core/scene/models.h"

namespace tia::test {
namespace {

Placement random_node_place(Random& random) {
  Placement own;
  own.translation = random.point(3);
  own.scale = {random.in(0.3, 2), random.in(-2, -0.3), random.in(0.3, 2)};
  const int axis = random.below(3);
  const double half = random.in(-1.5, 1.5);
  own.rotation = {0, 0, 0, std::cos(half)};
  own.rotation[static_cast<std::size_t>(axis)] = std::sin(half);
  return own;
}

// The scene's steps of such a place, found from the angle about its one axis.
TransformSteps steps_of_place(const Placement& own) {
  const double w = own.rotation[3];
  Vec3d degrees;
  const auto angle = [&](std::size_t axis) {
    return 2 * std::atan2(own.rotation[axis], w) * 180 / 3.14159265358979323846;
  };
  degrees = {angle(0), angle(1), angle(2)};
  return {{Scale{own.scale}, RotateDegrees{degrees}, Translate{own.translation}}};
}

TEST(ModelPlace, OfNodesInNodesIsThatOfGroupsInGroups) {
  Random random(2210);
  for (int i = 0; i < 60; ++i) {
    Model model = triangle_model();
    Object nested{"", Mesh{}, {}, {}};
    std::get<Mesh>(nested.shape).positions.values = {0, 0, 0, 4, 0, 0, 0, 2, 0};
    std::get<Mesh>(nested.shape).indices.values = {0, 1, 2};
    Affine expected;
    for (int depth = random.below(5); depth >= 0; --depth) {
      ModelNode& last = model.nodes.back();
      last.placement = random_node_place(random);
      expected = expected * steps_of_place(last.placement).affine();
      if (depth == 0) break;
      last.children = {static_cast<ModelIndex>(model.nodes.size())};
      last.mesh.reset();
      model.nodes.push_back({});
      model.nodes.back().mesh = 0;
    }
    const std::vector<Object> shown = shown_by(model);
    ASSERT_EQ(shown.size(), 1U);
    std::vector<Vec3d> corners;
    for (const Vec3d& p : triangle_corners) corners.push_back(expected.point(p));
    expect_near_points(placed_vertices(shown[0]), corners, 1e-6);
  }
}

// Front is where its corners turn clockwise, as the mirrored mesh's with its corners swapped.
TEST(ModelPlace, AMirroredNodeIsTheMirroredMesh) {
  Model model = triangle_model();
  model.nodes[0].placement.scale = {-1, 1, 1};
  Mesh mirrored;
  mirrored.positions.values = {0, 0, 0, -4, 0, 0, 0, 2, 0};
  mirrored.indices.values = {0, 2, 1};
  for (const double side : {5.0, -5.0}) {
    Scene scene;
    scene.lights = {point_light({-1, 1, 9})};
    Scene other = scene;
    scene.objects = read_scene(model_scene()).objects;
    scene.objects.edit()[0].material = MaterialRef(matte({1, 1, 1}));
    other.objects = {{"", mirrored, {}, MaterialRef(matte({1, 1, 1}))}};
    const Vec3d from{-0.5, 0.5, side}, way{0, 0, -side};
    const Vec3f seen = light_along(resolved(scene, model), from, way);
    EXPECT_EQ(seen, light_along(other, from, way));
    EXPECT_EQ(seen.x > 0.5F, side > 0);
  }
}

// Zero along an axis leaves a flat thing, along all axes nothing to see.
TEST(ModelPlace, OfNoVolumeKeepsWhatIsFlat) {
  Model model = triangle_model();
  model.meshes[0].parts[0].positions = {0, 0, 1, 4, 0, 2, 0, 2, 3};
  model.meshes[0].parts[0].normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  model.nodes[0].placement.scale = {1, 1, 0};
  const std::vector<Object> shown = shown_by(model);
  EXPECT_EQ(placed_vertices(shown[0]), triangle_corners);
  EXPECT_TRUE(mesh_in(shown[0]).normals.values.empty());
  model.nodes[0].placement.scale = {};
  Scene scene = resolved(read_scene(model_scene()), model);
  EXPECT_EQ(compile(scene).objects, 1);
  EXPECT_EQ(light_along(scene, {0.5, 0.5, 5}, {0, 0, -1}), (Vec3f{0, 0, 0}));
}

// A place that is too large for objects, mirrored: the corners are swapped instead.
TEST(ModelPlace, OfVerticesThatAreMovedThemselvesKeepsTheFront) {
  Model model = triangle_model();
  model.meshes[0].parts[0].positions = {0, 0, 0, 4e-9, 0, 0, 0, 2e-9, 0};
  model.nodes[0].placement.scale = {-1e9, 1e9, 1e9};
  model.nodes[0].children = {1};
  model.nodes.push_back(model.nodes[0]);
  model.nodes[1].children.clear();
  model.nodes[1].placement.scale = {10, 10, 10};
  model.nodes[0].mesh.reset();
  const std::vector<Object> shown = shown_by(model);
  EXPECT_TRUE(shown[0].transform.steps.empty());
  expect_near_points(placed_vertices(shown[0]), {{0, 0, 0}, {-40, 0, 0}, {0, 20, 0}}, 1e-12);
  EXPECT_EQ(mesh_in(shown[0]).indices.values.get(), (std::vector<std::uint32_t>{0, 2, 1}));
}

// ---- up, fit ------------------------------------------------------------------------------------

TEST(ModelUp, TurnsThatAxisToY) {
  Model model = triangle_model();
  model.meshes[0].parts[0].positions = {1, 2, 3, 0, 0, 0, 5, 0, 0};
  const std::vector<std::pair<const char*, Vec3d>> turned{{"y", {1, 2, 3}},    {"z", {1, 3, -2}},
                                                          {"-y", {1, -2, -3}}, {"-z", {1, -3, 2}},
                                                          {"x", {-2, 1, 3}},   {"-x", {2, -1, 3}}};
  for (const auto& [up, expected] : turned) {
    const auto shown = shown_by(model, R"("up":")" + std::string(up) + "\"");
    EXPECT_EQ(placed_vertices(shown[0])[0], expected) << up;
    EXPECT_EQ(shown[0].transform.affine().determinant(), 1) << up;
  }
}

std::vector<Vec3d> fitted_corners(const std::string& fit, const std::string& more = "") {
  return placed_vertices(shown_by(triangle_model(), R"("fit":)" + fit + more)[0]);
}

// 4 x 2 x 0 into 8 x 8 x 8: twice as large, which fills x; y has 4 to spare, z 8.
TEST(ModelFit, FillsTheBoxAndStandsWhereAlignSays) {
  EXPECT_EQ(fitted_corners(R"({"min":[0,0,0],"max":[8,8,8]})"),
            (std::vector<Vec3d>{{0, 2, 4}, {8, 2, 4}, {0, 6, 4}}));
  EXPECT_EQ(fitted_corners(R"({"min":[0,0,0],"max":[8,8,8],"align":[0,0,0]})"),
            (std::vector<Vec3d>{{0, 0, 0}, {8, 0, 0}, {0, 4, 0}}));
  EXPECT_EQ(fitted_corners(R"({"min":[-4,-4,-4],"max":[4,4,4],"align":[1,1,0.25]})"),
            (std::vector<Vec3d>{{-4, 0, -2}, {4, 0, -2}, {-4, 4, -2}}));
  // Half as large, for y has 1 only; x then has 2 of 3.
  EXPECT_EQ(fitted_corners(R"({"min":[0,0,0],"max":[3,1,1],"align":[1,0,0]})"),
            (std::vector<Vec3d>{{1, 0, 0}, {3, 0, 0}, {1, 1, 0}}));
}

// x up: (x, y, z) to (-y, x, z), so 2 x 4 x 0; into 1 x 1 x 1 a quarter as large.
TEST(ModelFit, IsOfTheModelAsItStands) {
  EXPECT_EQ(fitted_corners(R"({"min":[0,0,0],"max":[1,1,1],"align":[0,0,0]})", R"(,"up":"x")"),
            (std::vector<Vec3d>{{0.5, 0, 0}, {0.5, 1, 0}, {0, 0, 0}}));
}

TEST(ModelFit, IsOfWhatIsShown) {
  Model model = triangle_model();
  model.nodes.push_back(model.nodes[0]);
  model.nodes[1].name = "far";
  model.nodes[1].placement.translation = {100, 0, 0};
  model.scenes[0].nodes.push_back(1);
  const std::string fit = R"("fit":{"min":[0,0,0],"max":[8,8,8],"align":[0,0,0]})";
  EXPECT_EQ(placed_vertices(shown_by(model, fit + R"(,"hide":["far"])")[0])[1], (Vec3d{8, 0, 0}));
  EXPECT_EQ(placed_vertices(shown_by(model, fit)[0])[1].x, 4 * (8.0 / 104));
}

TEST(ModelFit, OfAPointKeepsItsSize) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.positions = {7, 7, 7};
  part.indices.clear();
  part.points = true;
  const auto shown = shown_by(model, R"("fit":{"min":[0,0,0],"max":[2,2,2]})");
  EXPECT_EQ(std::get<Sphere>(shown[0].shape).center, (Vec3d{1, 1, 1}));
  EXPECT_EQ(std::get<Sphere>(shown[0].shape).radius, 1.0 / 500);
}

// ---- points -------------------------------------------------------------------------------------

TEST(ModelPoints, AreBallsOfA500thOfTheDiagonal) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.positions = {0, 0, 0, 3, 4, 0};
  part.indices.clear();
  part.points = true;
  model.nodes[0].placement.scale = {2, 2, 2};
  const auto balls = [&](const std::string& members) {
    const std::vector<Object> shown = shown_by(model, members);
    return *children_of(shown.at(0));
  };
  EXPECT_EQ(balls("")[1].shape, (Shape{Sphere{{6, 8, 0}, 10.0 / 500}}));
  EXPECT_EQ(balls(R"("point_radius":0.5)")[1].shape, (Shape{Sphere{{6, 8, 0}, 0.5}}));
  EXPECT_EQ(balls(R"("fit":{"min":[0,0,0],"max":[3,4,1]})")[1].shape,
            (Shape{Sphere{{3, 4, 0.5}, 5.0 / 500}}));
}

// glTF 2.0, 3.7.2.1: colour = factor x vertex colour; so its alpha.
TEST(ModelPoints, OfOneColourAreAGroupInIt) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.positions = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  part.colors = {0.5F, 1, 0.25F, 1, 0, 1, 0, 0.5F, 0.5F, 1, 0.25F, 1};
  part.indices.clear();
  part.points = true;
  model.materials = {{}};
  model.materials[0].base_color = {0.5, 0.75, 1}, model.materials[0].alpha = 0.5;
  part.material = 0;
  const std::vector<Object> shown = shown_by(model, "");
  const std::vector<Object>& groups = *children_of(shown.at(0));
  ASSERT_EQ(groups.size(), 2U);
  const auto worn = [](const Object& object) {
    const Material& material = *std::get<Boxed<Material>>(*object.material);
    return *std::get<Boxed<Principled>>(material.kind);
  };
  EXPECT_EQ(std::get<Color>(worn(groups[0]).base_color), (Color{0.25, 0.75, 0.25}));
  EXPECT_EQ(std::get<Color>(worn(groups[1]).base_color), (Color{0, 0.75, 0}));
  EXPECT_EQ(std::get<double>(worn(groups[0]).alpha), 0.5);
  EXPECT_EQ(std::get<double>(worn(groups[1]).alpha), 0.25);
  ASSERT_EQ(children_of(groups[0])->size(), 2U);
  EXPECT_EQ(std::get<Sphere>(children_of(groups[0])->at(1).shape).center, (Vec3d{2, 0, 0}));

  part.colors = {0.5F, 1, 0.25F, 1, 0.5F, 1, 0.25F, 1, 0.5F, 1, 0.25F, 1};
  const std::vector<Object> alike = shown_by(model, "");
  EXPECT_EQ(children_of(alike.at(0))->size(), 3U);
  EXPECT_EQ(std::get<Color>(worn(alike[0]).base_color), (Color{0.25, 0.75, 0.25}));
  const std::vector<Object> other = shown_by(model, R"("material":{"color":[1,0,0]})");
  EXPECT_EQ(children_of(other.at(0))->size(), 3U) << "another material has none of them";
}

}  // namespace
}  // namespace tia::test
