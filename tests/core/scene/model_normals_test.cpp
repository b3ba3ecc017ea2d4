// Normal maps of models: which way they bend the normals of what they lie on.
#include <gtest/gtest.h>

#include "tests/core/scene/textured_models.h"

namespace tia {
namespace {

using namespace test;

constexpr std::array<std::uint8_t, 4> bump_code{204, 102, 230, 255};
// What it says: x along the tangent, y along the bitangent, z along the normal.
Vec3d said_normal(double strength = 1) {
  const auto signed_code = [](int code) { return 2 * code / 255.0 - 1; };
  return normalize(Vec3d{signed_code(bump_code[0]) * strength, signed_code(bump_code[1]) * strength,
                         signed_code(bump_code[2])});
}

Model bumpy_square(double strength = 1) {
  Model model = square_model(1);
  TextureUse use;
  use.strength = strength;
  paint_of(model).normal_texture = use;
  return model;
}
// The normal in the middle, as a camera at z = 5 sees it, or at -5.
Vec3d seen_normal(const Model& model, bool from_behind = false) {
  Scene scene = square_scene(source_of(model, {even_rgba(2, 2, bump_code)}));
  if (from_behind) scene.camera.location.z = -5, scene.camera.direction = Vec3d{0, 0, 1};
  const Image seen = drawn(scene, IntegratorName::normal, 3, 3);
  EXPECT_EQ(seen.rgb, drawn(scene, IntegratorName::normal, 3, 3, Scalar::narrow).rgb);
  const float* n = seen.at(1, 1);
  return {n[0], n[1], n[2]};
}
void expect_normal(const Vec3d& got, const Vec3d& expected) {
  EXPECT_LE(length(got - expected), 1e-6)
      << testing::PrintToString(got) << " expected " << testing::PrintToString(expected);
}

TEST(ModelNormals, AreTiltedByTheArcTangentOfTheSlope) {
  const Vec3d n = seen_normal(bumpy_square());
  expect_normal(n, said_normal());
  const double slope = std::hypot(0.6, -0.2) / (2 * 230 / 255.0 - 1);
  EXPECT_NEAR(std::acos(n.z), std::atan(slope), 1e-6);
}

TEST(ModelNormals, ScaleCountsInTheSurface) {
  expect_normal(seen_normal(bumpy_square(0.25)), said_normal(0.25));
}

TEST(ModelNormals, TurnWithTheCoordinates) {
  const Vec3d m = said_normal();
  Model mirrored = bumpy_square();
  part_of(mirrored).uvs[0] = {1, 1, 0, 1, 0, 0, 1, 0};
  expect_normal(seen_normal(mirrored), {-m.x, m.y, m.z});
  Model turned = bumpy_square();  // u along y, v against x
  part_of(turned).uvs[0] = {0, 0, 0, 1, 1, 1, 1, 0};
  expect_normal(seen_normal(turned), {-m.y, m.x, m.z});
  Model by_transform = bumpy_square();
  paint_of(by_transform).normal_texture->scale = {-1, 1};
  expect_normal(seen_normal(by_transform), {-m.x, m.y, m.z});
}

TEST(ModelNormals, FollowTheTangentsOfTheFile) {
  const Vec3d m = said_normal();
  for (const float w : {1.0F, -1.0F}) {
    Model model = bumpy_square();
    for (int i = 0; i < 4; ++i)
      for (const float x : {0.0F, 2.0F, 0.0F, w}) part_of(model).tangents.push_back(x);
    // t = y; b = w z x y = -w x
    expect_normal(seen_normal(model), {-w * m.y, m.x, m.z});
  }
}

TEST(ModelNormals, OfTheBackAreTurnedRound) {
  expect_normal(seen_normal(bumpy_square(), true), -said_normal());
}

TEST(ModelNormals, OfAMirroredNodeAreTheMirrorImage) {
  Model model = bumpy_square();
  model.nodes[0].placement.scale = {-1, 1, 1};
  model.nodes[0].placement.translation = {1, 0, 0};
  const Vec3d m = said_normal();
  expect_normal(seen_normal(model), {-m.x, m.y, m.z});
}

TEST(ModelNormals, StandOnTheInterpolatedNormal) {
  Model model = bumpy_square();
  const Vec3d n = normalize(Vec3d{0.6, 0, 0.8});
  for (int i = 0; i < 4; ++i)
    for (const double x : {n.x, n.y, n.z}) part_of(model).normals.push_back(static_cast<float>(x));
  const Vec3d m = said_normal(), t{0.8, 0, -0.6};
  expect_normal(seen_normal(model), t * m.x + Vec3d{0, 1, 0} * m.y + n * m.z);
}

// Where the coordinates tell no direction there is some tangent all the same.
TEST(ModelNormals, WithoutADirectionAreTiltedSomehow) {
  Model model = bumpy_square();
  part_of(model).uvs[0].assign(8, 0.5);
  EXPECT_NEAR(seen_normal(model).z, said_normal().z, 1e-6);
  part_of(model).uvs[0].clear();
  EXPECT_NEAR(seen_normal(model).z, said_normal().z, 1e-6);
}

// ---- tangents that move -------------------------------------------------------------------------

TEST(ModelNormals, TangentsAreMorphedAndMoveWithTheSkin) {
  Model model = bumpy_square();
  ModelPart& part = part_of(model);
  MorphTarget target;
  for (int i = 0; i < 4; ++i) {
    for (const float x : {1.0F, 0.0F, 0.0F, 1.0F}) part.tangents.push_back(x);
    for (const float x : {-2.0F, 2.0F, 0.0F}) target.tangents.push_back(x);
  }
  part.targets = {target};
  model.meshes[0].weights = {0.5};  // (1, 0, 0) becomes (0, 1, 0)
  const Vec3d m = said_normal();
  expect_normal(seen_normal(model), {-m.y, m.x, m.z});

  // A joint that turns by 90 degrees about z makes (-1, 0, 0) of it.
  ModelNode joint;
  const double half = std::sqrt(0.5);
  joint.placement.rotation = {0, 0, half, half};
  joint.placement.translation = {1, 0, 0};
  model.nodes.push_back(joint);
  model.scenes[0].nodes.push_back(1);
  model.skins.push_back({"", {1}, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  model.nodes[0].skin = 0;
  for (int i = 0; i < 4; ++i) {
    for (const std::uint32_t j : {0U, 0U, 0U, 0U}) part.joints.push_back(j);
    for (const float w : {1.0F, 0.0F, 0.0F, 0.0F}) part.weights.push_back(w);
  }
  expect_normal(seen_normal(model), {-m.x, -m.y, m.z});
}

}  // namespace
}  // namespace tia
