// Where nodes and vertices are, against the scene's own transforms and sums written out.
#include "core/models/pose.h"

#include <gtest/gtest.h>

#include "core/input/transform_steps.h"
#include "core/math/deterministic.h"
#include "tests/core/models/random_model.h"

namespace tia::test {
namespace {

void expect_near(const Vec3d& a, const Vec3d& b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

// A rotation about an axis of the scene's, as a quaternion.
Placement turned_about(int axis, double degrees) {
  Placement placement;
  placement.rotation = {0, 0, 0, std::cos(degrees / 360 * pi)};
  placement.rotation[static_cast<std::size_t>(axis)] = std::sin(degrees / 360 * pi);
  return placement;
}
Vec3d about(int axis, double degrees) {
  return axis == 0 ? Vec3d{degrees, 0, 0} : axis == 1 ? Vec3d{0, degrees, 0} : Vec3d{0, 0, degrees};
}

TEST(Pose, PlacesAsTheScenesTransformsDo) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const int axis = random.below(3);
    const double degrees = random.in(-180, 180);
    Placement own = turned_about(axis, degrees);
    own.scale = {random.in(0.1, 3), random.in(-3, -0.1), random.in(0.1, 3)};
    own.translation = {random.in(-9, 9), random.in(-9, 9), random.in(-9, 9)};
    for (double& each : own.rotation) each *= 3;  // of any length
    const TransformSteps steps{
        {Scale{own.scale}, RotateDegrees{about(axis, degrees)}, Translate{own.translation}}};
    const Vec3d p{random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
    expect_near(affine_of(own).point(p), steps.affine().point(p), 1e-12);
  }
}

TEST(Pose, WithoutAPlacementIsExactlyTheSame) { EXPECT_EQ(affine_of(Placement{}), Affine{}); }

// Each node's place is the product of those above it, found here from the leaf upwards.
TEST(Pose, OfATreeIsTheProductOfItsPath) {
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    const Model model = random_model(random);
    std::vector<MaybeIndex> parents(model.nodes.size());
    for (ModelIndex n = 0; n < model.nodes.size(); ++n)
      for (const ModelIndex child : model.nodes[n].children) parents[child] = n;
    const Pose pose = pose_of(model);
    EXPECT_EQ(pose.shown.size(), model.nodes.size());
    for (ModelIndex n = 0; n < model.nodes.size(); ++n) {
      Vec3d p{1, 2, 3};
      const Vec3d placed = pose.places[n].point(p);
      for (MaybeIndex at = n; at; at = parents[*at])
        p = affine_of(model.nodes[*at].placement).point(p);
      expect_near(placed, p, 1e-9 * (1 + std::sqrt(dot(p, p))));
    }
  }
}

TEST(Pose, AMatrixIsReadColumnByColumn) {
  Model model = full_model();
  model.nodes[0].matrix = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  expect_near(pose_of(model).places[0].point(Vec3d{1, 0, 0}), {5, 7, 7}, 0);
}

TEST(Pose, ChannelsReplaceWhatTheyName) {
  Model model = full_model();
  model.nodes[1].placement.translation = {9, 9, 9};
  const Pose pose = pose_of(model, {{}, 0, 0.5});
  EXPECT_EQ(pose.places[1].offset, (Vec3d{0.5, 1, 1.5}));
  EXPECT_EQ(pose_of(model).places[1].offset, (Vec3d{9, 9, 9}));
}

// ---- vertices -----------------------------------------------------------------------------------

// The full model without a skin, or with one whose joints are where they were bound.
Model sheet(bool skinned) {
  Model model = full_model();
  model.nodes[0].instances.clear();
  model.nodes[0].weights = {0};
  model.animations.clear();
  if (!skinned) model.nodes[0].skin.reset();
  for (auto& each : model.skins[0].inverse_binds)
    each = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  return model;
}
PartShape shape_of(const Model& model) {
  return shape_of(model, pose_of(model), 0, model.meshes[0].parts[0]);
}

TEST(PartShape, MorphsAddTheirShare) {
  Model model = sheet(false);
  const std::vector<double> rest = shape_of(model).positions;
  for (const double weight : {0.25, 1.0, -2.0}) {
    model.nodes[0].weights = {weight};
    const std::vector<double> moved = shape_of(model).positions;
    for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_EQ(moved[i], rest[i] + weight);
  }
  model.nodes[0].weights.clear();  // then the mesh's own
  EXPECT_EQ(shape_of(model).positions[0], rest[0] + 0.5);
}

TEST(PartShape, OfARigidSkinIsAMovedNode) {
  Random random(11);
  Model model = sheet(true);
  ModelPart& part = model.meshes[0].parts[0];
  part.joints.assign(16, 1);
  model.nodes[1].placement = turned_about(1, 40);
  model.nodes[1].placement.translation = {3, -2, 1};
  model.nodes[1].placement.scale = {2, 0.5, 1};
  const Affine place = affine_of(model.nodes[1].placement);
  const PartShape shape = shape_of(model);
  const Vec3d normal = place.inverse().row(Vec3d{0, 0, 1});
  for (std::size_t i = 0; i < part.vertices(); ++i) {
    const Vec3d p{part.positions[3 * i], part.positions[3 * i + 1], part.positions[3 * i + 2]};
    expect_near({shape.positions[3 * i], shape.positions[3 * i + 1], shape.positions[3 * i + 2]},
                place.point(p), 1e-12);
    const Vec3d n{shape.normals[3 * i], shape.normals[3 * i + 1], shape.normals[3 * i + 2]};
    expect_near(cross(n, normal), {}, 1e-12);
    EXPECT_GT(dot(n, normal), 0);
  }
}

// Where two joints pull alike a vertex is in the middle, whatever the sum of its weights.
TEST(PartShape, HalfWeightsAreTheMiddle) {
  Model model = sheet(true);
  ModelPart& part = model.meshes[0].parts[0];
  part.weights = {0.5F, 0.5F, 0, 0, 2, 2, 0, 0, 0.1F, 0.1F, 0, 0, 1, 0, 0, 0};
  model.nodes[1].placement.translation = {4, 0, 0};
  const PartShape shape = shape_of(model);
  EXPECT_NEAR(shape.positions[0], 0 + 2, 1e-12);
  EXPECT_NEAR(shape.positions[3], 1 + 2, 1e-12);
  EXPECT_NEAR(shape.positions[6], 1 + 2, 1e-6);
  EXPECT_NEAR(shape.positions[9], 0, 1e-12);
}

TEST(ModelBounds, AreThoseOfAllThatIsShown) {
  Random random(12);
  for (int i = 0; i < 50; ++i) {
    Model model = random_model(random);
    model.nodes[0].skin.reset();
    model.nodes[0].instances.clear();
    const Pose pose = pose_of(model);
    Aabb box;
    for (ModelIndex n = 0; n < model.nodes.size(); ++n) {
      if (!model.nodes[n].mesh) continue;
      const PartShape shape = shape_of(model, pose, n, model.meshes[0].parts[0]);
      for (std::size_t v = 0; v < 4; ++v)
        box = around(box,
                     pose.places[n].point(Vec3d{shape.positions[3 * v], shape.positions[3 * v + 1],
                                                shape.positions[3 * v + 2]}));
    }
    EXPECT_EQ(bounds_of(model, pose), box);
  }
}

}  // namespace
}  // namespace tia::test
