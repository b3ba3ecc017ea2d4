// Models whose files have no normals, with `smooth`, and no tangents, with a normal map.
#include <gtest/gtest.h>

#include "tests/core/accel/meshes.h"
#include "tests/core/scene/models.h"

namespace tia::test {
namespace {

ModelPart part_of(const Mesh& mesh) {
  ModelPart part;
  part.positions = mesh.positions.values.get();
  part.indices = mesh.indices.values.get();
  return part;
}
Model model_of_mesh(const Mesh& mesh) {
  Model model = triangle_model();
  model.meshes[0].parts[0] = part_of(mesh);
  return model;
}
std::vector<std::uint32_t> drawn_model(const Model& model, const std::string& members) {
  Scene scene = resolved(read_scene(model_scene(members)), model);
  scene.camera.location = {3, 2, 4};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.lights = {point_light({5, 4, 3})};
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  return bits_of(picture(scene, 32, 24, options).image);
}

TEST(ModelSmooth, CubeIsFlatToTheByteAtThirtyDegreesAndRoundAtAHundred) {
  const Model cube = model_of_mesh(box_mesh({1, 1, 1}));
  const auto flat = drawn_model(cube, "");
  EXPECT_EQ(drawn_model(cube, R"("smooth":30)"), flat);
  EXPECT_NE(drawn_model(cube, R"("smooth":100)"), flat);
}

TEST(ModelSmooth, BallIsAsOneWithItsRadiiForNormals) {
  const Mesh ball = ball_mesh(2);
  Model with_normals = model_of_mesh(ball);
  for (const double x : ball.positions.values)
    with_normals.meshes[0].parts[0].normals.push_back(static_cast<float>(x));
  const Mesh shown = mesh_in(shown_by(model_of_mesh(ball), R"("smooth":60)").at(0));
  ASSERT_EQ(shown.normals.values.size(), ball.positions.values.size());
  for (std::size_t i = 0; i < ball.positions.values.size(); ++i)
    EXPECT_NEAR(shown.normals.values[i], shown.positions.values[i], 1e-12);
  // A file's own normals stay.
  EXPECT_EQ(shown_by(with_normals, R"("smooth":60)"), shown_by(with_normals));
}

TEST(ModelSmooth, UvsFollowTheirVertices) {
  Model model = model_of_mesh(box_mesh({1, 1, 1}));
  ModelPart& part = model.meshes[0].parts[0];
  for (std::size_t i = 0; i < 8; ++i) {
    part.uvs[0].push_back(part.positions[3 * i]);
    part.uvs[0].push_back(part.positions[3 * i + 1]);
  }
  const Mesh mesh = mesh_in(shown_by(model, R"("smooth":100)").at(0));
  ASSERT_EQ(mesh.uvs.values.size(), 2 * mesh.vertices());
  for (std::size_t i = 0; i < mesh.vertices(); ++i) {
    EXPECT_EQ(mesh.uvs.values[2 * i], mesh.positions.values[3 * i]);
    EXPECT_EQ(mesh.uvs.values[2 * i + 1], 1 - mesh.positions.values[3 * i + 1]);
  }
}

// Of two nodes that show one mesh each, moved differently.
TEST(ModelSmooth, WhatIsMovedVertexByVertexIsSmoothAsItStands) {
  Model model = model_of_mesh(ball_mesh(1));
  ModelPart& part = model.meshes[0].parts[0];
  MorphTarget larger;
  for (const double x : part.positions) larger.positions.push_back(static_cast<float>(x));
  part.targets = {larger};
  model.nodes[0].weights = {1};
  model.nodes.push_back(model.nodes[0]);
  model.nodes[1].weights = {3};
  model.scenes[0].nodes = {0, 1};
  const auto shown = shown_by(model, R"("smooth":60)");
  ASSERT_EQ(shown.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Mesh& mesh = mesh_in(shown[k]);
    ASSERT_EQ(mesh.normals.values.size(), mesh.positions.values.size());
    for (std::size_t i = 0; i < mesh.positions.values.size(); ++i)
      EXPECT_NEAR(mesh.normals.values[i] * (k == 0 ? 2 : 4), mesh.positions.values[i], 1e-6);
  }
}

TEST(ModelSmooth, PartedVerticesCountAgainstTheBudget) {
  const Model cube = model_of_mesh(box_mesh({1, 1, 1}));  // 8 vertices, 12 faces, 36 corners
  EXPECT_TRUE(model_faults(cube, model_scene(), {10, 20}).empty());
  EXPECT_FALSE(model_faults(cube, model_scene(R"("smooth":30)"), {10, 55}).empty());
  EXPECT_TRUE(model_faults(cube, model_scene(R"("smooth":30)"), {10, 56}).empty());
}

// ---- tangents -----------------------------------------------------------------------------------

// Two squares side by side whose uvs mirror each other, with a normal map.
Model folded_model() {
  Mesh mesh;
  mesh.positions.values = {-1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0};
  mesh.indices.values = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  Model model = model_of_mesh(mesh);
  ModelPart& part = model.meshes[0].parts[0];
  for (std::size_t i = 0; i < 6; ++i) {
    const auto x = static_cast<float>(part.positions[3 * i]);
    const auto y = static_cast<float>(part.positions[3 * i + 1]);
    part.normals.insert(part.normals.end(), {0, 0, 1});
    part.uvs[0].insert(part.uvs[0].end(), {std::fabs(x), 1 - y});
    part.uvs[1].insert(part.uvs[1].end(), {y, x});
    part.colors.insert(part.colors.end(), {x + 1, y, 0, 1});
  }
  model.images = {{}};
  model.textures = {{}};
  model.materials = {{}};
  model.materials[0].normal_texture = TextureUse{};
  part.material = 0;
  return model;
}
// Where the mesh's tangents point that a corner of the side x < 0 or x > 0 has.
std::vector<Vec3d> tangents_on(const Mesh& mesh, double side) {
  std::vector<Vec3d> all;
  for (std::size_t c = side < 0 ? 0 : 6; c < (side < 0 ? 6U : 12U); ++c) {
    const double* at = &mesh.tangents.values.get()[4 * mesh.indices.values.get()[c]];
    all.push_back({at[0], at[1], at[2]});
  }
  return all;
}

TEST(ModelTangents, OfAFileWithoutAnyPointAlongTheRowsOfItsNormalMap) {
  Model model = folded_model();
  TextureUse& use = *model.materials[0].normal_texture;
  const Mesh folded = mesh_in(shown_by(model).at(0));
  EXPECT_EQ(folded.vertices(), 8U) << "those between the squares are parted";
  for (const double side : {-1, 1})
    for (const Vec3d& t : tangents_on(folded, side)) EXPECT_EQ(t, (Vec3d{side, 0, 0}));
  for (std::size_t i = 0; i < 8; ++i) {  // the others' numbers follow
    EXPECT_EQ(folded.colors.values[4 * i], std::min(folded.positions.values[3 * i] + 1, 1.0));
    EXPECT_EQ(folded.uvs.values[2 * i], std::fabs(folded.positions.values[3 * i]));
    EXPECT_EQ(folded.normals.values[3 * i + 2], 1);
  }
  // KHR_texture_transform turns uv' = (v, -u) of v downward: rows run where v grows, down.
  use.rotation = M_PI / 2;
  for (const double side : {-1, 1})
    for (const Vec3d& t : tangents_on(mesh_in(shown_by(model).at(0)), side))
      EXPECT_LE(length(t - Vec3d{0, -1, 0}), 1e-12);
  use.rotation = 0, use.uv_set = 1;
  const Mesh other = mesh_in(shown_by(model).at(0));
  EXPECT_EQ(other.vertices(), 6U);
  for (const Vec3d& t : tangents_on(other, 1)) EXPECT_EQ(t, (Vec3d{0, 1, 0}));
}

TEST(ModelTangents, AreTheFilesOwnOrNoneWhereNothingAsksForThem) {
  Model model = folded_model();
  ModelPart& part = model.meshes[0].parts[0];
  for (std::size_t i = 0; i < 6; ++i) part.tangents.insert(part.tangents.end(), {0, 1, 0, 1});
  const Mesh own = mesh_in(shown_by(model).at(0));
  EXPECT_EQ(own.vertices(), 6U);
  for (const Vec3d& t : tangents_on(own, 1)) EXPECT_EQ(t, (Vec3d{0, 1, 0}));
  part.tangents.clear();
  model.materials[0].unlit = true;
  EXPECT_TRUE(mesh_in(shown_by(model).at(0)).tangents.values.empty());
  model.materials[0].unlit = false, part.uvs[0].clear();
  EXPECT_TRUE(mesh_in(shown_by(model).at(0)).tangents.values.empty());
}

// A morph that turns the squares about x.
TEST(ModelTangents, FollowWhatIsMovedVertexByVertex) {
  Model model = folded_model();
  ModelPart& part = model.meshes[0].parts[0];
  MorphTarget turned;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto x = static_cast<float>(part.positions[3 * i]);
    turned.positions.insert(turned.positions.end(), {-x, 0, x});
    turned.normals.insert(turned.normals.end(), {-1, 0, -1});
  }
  part.targets = {turned};
  model.nodes[0].weights = {1};
  const Mesh mesh = mesh_in(shown_by(model).at(0));
  EXPECT_EQ(mesh.vertices(), 8U);
  for (const double side : {-1, 1})
    for (const Vec3d& t : tangents_on(mesh, side)) EXPECT_EQ(t, (Vec3d{0, 0, side}));
}

}  // namespace
}  // namespace tia::test
