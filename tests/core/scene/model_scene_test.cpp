// A model's file as a scene: its camera and lights, and what stands in for them.
#include "core/scene/model_scene.h"

#include "core/scene/model_lights.h"
#include "core/scene/read_scene.h"
#include "tests/core/integrators/paths.h"
#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

constexpr double eps = 1e-12;

// A triangle within [0, 2] x [0, 1] on a node of its own, and room for other nodes.
Model lone_triangle() {
  Model model;
  ModelPart part;
  part.positions = {0, 0, 0, 2, 0, 0, 0, 1, 0};
  part.indices = {0, 1, 2};
  model.meshes = {ModelMesh{"", {part}, {}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes = {ModelScene{"", {0}}};
  return model;
}

// Adds a node to the scene. Turned by 90 degrees about +y its -z looks along -x.
ModelNode& with_node(Model& model, const Vec3d& place, bool turned = false) {
  ModelNode node;
  node.placement.translation = place;
  const double half = std::sqrt(0.5);
  if (turned) node.placement.rotation = {0, half, 0, half};
  model.scenes[0].nodes.push_back(static_cast<ModelIndex>(model.nodes.size()));
  return model.nodes.emplace_back(node);
}

ModelLight lit(ModelLightKind kind) {
  ModelLight light;
  light.kind = kind;
  light.color = {1, 0.5, 0.25};
  light.intensity = 7;
  light.inner_angle = 0.3, light.outer_angle = 0.6;
  return light;
}

Scene scene_of_file(const Model& model) {
  const auto kept =
      std::make_shared<const KeptModel>(KeptModel{std::make_shared<const Model>(model), {}});
  return model_scene(kept, "name", 4.0 / 3);
}

TEST(ModelScene, IsItsModelAloneUnderTheIdThatWasAskedFor) {
  const Scene scene = scene_of_file(lone_triangle());
  ASSERT_EQ(scene.objects.size(), 1U);
  PlacedModel placed;
  placed.id = "name";
  EXPECT_EQ(std::get<PlacedModel>(scene.objects[0].shape), placed);
  EXPECT_EQ(scene.options.integrator, IntegratorName::path);
  EXPECT_FALSE(scene.backdrop);
  EXPECT_EQ(read_scene(canonical_text(scene)), scene);
}

TEST(ModelScene, WithoutACameraItTouchesTheFrameFromTheUsualSide) {
  const Scene scene = scene_of_file(lone_triangle());
  StillPoints corners;
  corners.corners = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  const SeenBox box = seen_box(corners, scene.camera, 4.0 / 3);
  EXPECT_NEAR(std::max(box.across(), box.along()), 0.9, 1e-9);
  const double azimuth = pi / 6, elevation = pi / 9;
  const Vec3d towards{-std::cos(elevation) * std::sin(azimuth), -std::sin(elevation),
                      -std::cos(elevation) * std::cos(azimuth)};
  EXPECT_LT(length(unit(*scene.camera.direction) - towards), eps);
}

TEST(ModelScene, WithoutLightsTheSkyIsOneAllAround) {
  const Scene scene = scene_of_file(lone_triangle());
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<SkyLight>(scene.lights[0].kind));
  EXPECT_EQ(scene.lights[0].color, (Color{1, 1, 1}));
  EXPECT_EQ(scene.lights[0].intensity, 1);
}

TEST(ModelScene, SeesByTheFirstOfTheCamerasThatAreShown) {
  Model model = lone_triangle();
  model.cameras.resize(3);
  for (ModelCamera& camera : model.cameras) camera.yfov = 0.5;
  model.cameras[1].yfov = 0.25;
  with_node(model, {9, 8, 7}, true).camera = 1;
  with_node(model, {1, 2, 3}).camera = 2;
  const Camera camera = scene_of_file(model).camera;  // camera 0 is on no node
  EXPECT_EQ(camera.location, (Vec3d{9, 8, 7}));
  EXPECT_LT(length(*camera.direction - Vec3d{-1, 0, 0}), eps);
  EXPECT_NEAR(camera.fov_degrees, 0.25 * 180 / pi, eps);
}

TEST(ModelScene, AFileWhoseUpIsZIsTurnedWithCameraAndLights) {
  Model model = lone_triangle();
  model.z_up = true;  // (x, y, z) stands at (x, z, -y)
  model.cameras.resize(1);
  model.cameras[0].yfov = 0.5;
  model.lights = {lit(ModelLightKind::directional)};
  with_node(model, {1, 2, 3}).camera = 0;
  with_node(model, {0, 0, 0}).light = 0;
  const Scene scene = scene_of_file(model);
  EXPECT_EQ(scene.camera.location, (Vec3d{1, 3, -2}));
  EXPECT_LT(length(*scene.camera.direction - Vec3d{0, -1, 0}), eps);  // the file's -z
  const auto& light = std::get<DirectionalLight>(scene.lights.at(0).kind);
  EXPECT_LT(length(*light.direction - Vec3d{0, -1, 0}), eps);
}

TEST(ModelScene, OfPointsItFramesTheBallsThatStandForThem) {
  Model model = lone_triangle();
  ModelPart& part = model.meshes[0].parts[0];
  part.points = true;
  part.indices.clear();
  StillPoints balls;
  balls.balls = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  balls.ball_radius = std::sqrt(5.0) / 500;  // the box's diagonal over 500
  const Camera camera = scene_of_file(model).camera;
  const Camera expected = framed(balls, {orbit_basis(30, 20), 30, 1, 4.0 / 3});
  EXPECT_LT(length(camera.location - expected.location), 1e-9);
}

TEST(ModelScene, OfASceneThatShowsNothingIsAScene) {
  Model model = lone_triangle();
  model.nodes[0].mesh.reset();
  const Scene scene = scene_of_file(model);
  EXPECT_EQ(read_scene(canonical_text(scene)), scene);
}

// ---- lights -------------------------------------------------------------------------------------

Light only_light(const ModelLight& light, bool turned = true) {
  Model model = lone_triangle();
  model.lights = {light};
  with_node(model, {1, 2, 3}, turned).light = 0;
  const auto lights = model_lights(model, pose_of(model), {});
  EXPECT_EQ(lights.size(), 1U);
  return lights.at(0);
}

TEST(ModelLights, StandAtTheirNodesAndShineAlongTheirMinusZ) {
  const Light point = only_light(lit(ModelLightKind::point));
  EXPECT_EQ(std::get<PointLight>(point.kind).position, (Vec3d{1, 2, 3}));
  const Light sun = only_light(lit(ModelLightKind::directional));
  EXPECT_LT(length(*std::get<DirectionalLight>(sun.kind).direction - Vec3d{-1, 0, 0}), eps);
  const Light spot = only_light(lit(ModelLightKind::spot));
  const auto& cone = std::get<SpotLight>(spot.kind);
  EXPECT_EQ(cone.position, (Vec3d{1, 2, 3}));
  EXPECT_LT(length(cone.point_at - Vec3d{0, 2, 3}), eps);
  EXPECT_NEAR(cone.radius_degrees, 0.3 * 180 / pi, eps);
  EXPECT_NEAR(cone.falloff_degrees, 0.6 * 180 / pi, eps);
  for (const Light& light : {point, sun, spot}) {
    EXPECT_EQ(light.color, (Color{1, 0.5, 0.25}));
    EXPECT_EQ(light.intensity, 7);
  }
}

TEST(ModelLights, BeyondAScenesIntensityTheColourSaysTheRest) {
  ModelLight bright = lit(ModelLightKind::point);
  bright.intensity = 4e6;
  const Light light = only_light(bright);
  EXPECT_EQ(light.intensity, 1e6);
  EXPECT_EQ(light.color, (Color{4, 2, 1}));
  bright.intensity = 1e30;
  EXPECT_EQ(only_light(bright).color, (Color{1e6, 1e6, 1e6}));
}

TEST(ModelLights, OfNodesThatAreNotShownOrHaveNoSizeThereAreNone) {
  Model model = lone_triangle();
  model.lights = {lit(ModelLightKind::directional)};
  with_node(model, {1, 2, 3}).light = 0;
  with_node(model, {1, 2, 3}).light = 0;
  model.nodes[1].placement.scale = {1, 1, 0};
  model.scenes[0].nodes.pop_back();
  EXPECT_TRUE(model_lights(model, pose_of(model), {}).empty());
}

// What a lamp of I candela gives a white floor straight below it at the distance d: radiance
// I / (pi d^2); and a sun of E lux E / pi.
TEST(ModelLights, LightAWhiteFloorByTheirCandelaAndLux) {
  Model model = lone_triangle();
  model.lights = {lit(ModelLightKind::point), lit(ModelLightKind::directional)};
  model.lights[0].intensity = 5;
  model.lights[1].intensity = 3;
  for (const ModelIndex number : {ModelIndex{0}, ModelIndex{1}}) {
    Model one = model;
    with_node(one, {0, 0, 2}).light = number;  // above the plane z = 0
    Scene scene;
    scene.lights = model_lights(one, pose_of(one), {});
    scene.objects = {object(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1))};
    scene.camera.location = {0, 0, 1};
    scene.camera.fov_degrees = 0.01;
    RenderOptions options;
    options.integrator = IntegratorName::path;
    const Image image = picture(scene, 1, 1, options).image;
    EXPECT_NEAR(image.rgb[0], (number == 0 ? 5 / 4.0 : 3) / pi, 1e-3);
  }
}

}  // namespace
}  // namespace tia
