// Scenes of stills: what a request makes of a model's objects.
#include "core/scene/still.h"

#include "core/input/described.h"
#include "tests/core/integrators/paths.h"
#include "tests/core/scene/models.h"
#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

StillBody cube(const Finish& finish = matt(1)) {
  StillBody body;
  body.objects = {object(Box{{-1, -1, -1}, {1, 1, 1}}, finish)};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) body.points.corners.push_back({x, y, z});
  return body;
}

TEST(StillScene, IsPlainJson) {
  for (std::size_t studio = 0; studio < Names<Studio>::names.size(); ++studio)
    for (const Ground ground : {Ground::shadow, Ground::floor, Ground::none})
      for (const IntegratorName integrator : {IntegratorName::path, IntegratorName::whitted}) {
        StillRequest request;
        request.studio = static_cast<Studio>(studio);
        request.ground = ground;
        request.fov = ground == Ground::none ? 0 : 45;
        if (ground == Ground::shadow) request.turntable = 3;
        const Scene scene = still_scene(request, cube(), 1.5, integrator);
        EXPECT_EQ(read_scene(canonical_text(scene)), scene);
        EXPECT_EQ(scene.options.integrator, integrator);
        EXPECT_EQ(scene.backdrop, Backdrop{});
        EXPECT_EQ(scene.objects.front(), cube().objects.front());
        EXPECT_EQ(scene.objects.size(), ground == Ground::floor ? 2U : 1U);
        EXPECT_EQ(scene.shadow_ground.has_value(), ground == Ground::shadow);
        EXPECT_EQ(scene.sheet.has_value(), ground == Ground::shadow);
      }
}

TEST(StillScene, IsFramedByTheRequest) {
  StillRequest request;
  request.orbit = {75, -10};
  request.zoom = 2;
  request.fov = 20;
  request.background.color = Color{0.1, 0.2, 0.3};
  const Scene scene = still_scene(request, cube(), 0.75);
  EXPECT_EQ(scene.camera, framed(cube().points, {orbit_basis(75, -10), 20, 2, 0.75}));
  EXPECT_EQ(scene.backdrop, request.background);
}

TEST(StillScene, TheFloorLiesUnderTheLowestPoint) {
  StillRequest request;
  request.ground = Ground::floor;
  const Scene scene = still_scene(request, cube(), 1);
  const auto& plane = std::get<Plane>(scene.objects[1].shape);
  EXPECT_EQ(plane, (Plane{{0, -1, 0}, {0, 1, 0}}));
}

TEST(StillScene, ShadowsFallOnAPlaneThereUnlessOthersAreAskedFor) {
  const Scene scene = still_scene({}, cube(), 1);
  EXPECT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.shadow_ground, (ShadowGround{{0, -1, 0}, {0, 1, 0}}));
}

// What the picture shows of a white cube in neutral light is 1, and nothing else is there.
TEST(StillScene, AWhiteBodyInNeutralLightIsOneInThePicture) {
  StillRequest request;
  request.studio = Studio::neutral;
  request.background.color = Color{};
  Finish white = matt(1);
  white.ambient = 1;
  for (const IntegratorName integrator : {IntegratorName::path, IntegratorName::whitted}) {
    RenderOptions options;
    options.integrator = integrator;
    options.max_depth = 16;
    const Image image =
        picture(still_scene(request, cube(white), 1, integrator), 32, 32, options).image;
    int ones = 0;
    for (const float light : image.rgb) {
      EXPECT_NEAR(light, light > 0.5F ? 1 : 0, 1e-5);
      ones += light > 0.5F;
    }
    EXPECT_GT(ones, 900);
    EXPECT_LT(ones, 3 * 29 * 29);
  }
}

// ---- the file's cameras -------------------------------------------------------------------------

// A sheet with camera 0 at (0, 0, 5) looking along -z; camera 1, parallel, from the right, twice as
// large.
Model two_cameras() {
  Model model = test::triangle_model();
  model.cameras.resize(2);
  model.cameras[0].name = "front";
  model.cameras[0].yfov = pi / 6;
  model.cameras[1].name = "right";
  model.cameras[1].orthographic = true;
  model.cameras[1].ymag = 3;
  model.nodes.resize(3);
  model.nodes[1].camera = 0;
  model.nodes[1].placement.translation = {0, 0, 5};
  model.nodes[2].camera = 1;
  model.nodes[2].placement.translation = {4, 0, 0};
  model.nodes[2].placement.rotation = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // -z to -x
  model.nodes[2].placement.scale = {2, 2, 2};
  model.scenes.resize(1);
  model.scenes[0].nodes = {0, 1, 2};
  return model;
}

Object placed_model(const std::string& members = "") {
  return read_scene(model_scene(members)).objects[0];
}
std::optional<Camera> camera_of(const CameraChoice& choice, const std::string& members = "") {
  Faults faults;
  const auto camera = still_camera(two_cameras(), placed_model(members), choice, {}, faults);
  EXPECT_TRUE(faults.empty());
  return camera;
}

TEST(StillCamera, IsTheFilesOwn) {
  const auto front = camera_of(0);
  ASSERT_TRUE(front);
  EXPECT_EQ(front->location, (Vec3d{0, 0, 5}));
  EXPECT_LT(length(*front->direction - Vec3d{0, 0, -1}), 1e-15);
  EXPECT_NEAR(front->fov_degrees, 30, 1e-12);
  const auto right = camera_of("right");
  ASSERT_TRUE(right);
  EXPECT_EQ(right->location, (Vec3d{4, 0, 0}));
  EXPECT_LT(length(*right->direction - Vec3d{-1, 0, 0}), 1e-15);
  EXPECT_EQ(right->projection, Projection::orthographic);
  EXPECT_NEAR(*right->height, 12, 1e-12);
}

// Some files tell a parallel camera's height below 0, which glTF asks them not to.
TEST(StillCamera, OfANegativeHeightSeesAsMuch) {
  Model model = two_cameras();
  model.cameras[1].ymag = -3;
  Faults faults;
  const auto camera = still_camera(model, placed_model(), 1, {}, faults);
  ASSERT_TRUE(camera);
  EXPECT_EQ(*camera, *camera_of(1));
}

// The sheet, 4 by 2, is in a box of twice its size at (1, 0, 0): so is the camera before it.
TEST(StillCamera, IsPlacedAsTheModelIs) {
  const auto fitted = camera_of(0, R"("fit":{"min":[1,0,0],"max":[9,9,9],"align":[0,0,0]})");
  ASSERT_TRUE(fitted);
  EXPECT_LT(length(fitted->location - Vec3d{1, 0, 10}), 1e-12);
  const auto turned = camera_of(0, R"("up":"z")");
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->location, (Vec3d{0, 5, 0}));
  EXPECT_LT(length(*turned->direction - Vec3d{0, -1, 0}), 1e-15);
}

TEST(StillCamera, OfAnotherNameOrNotShownIsAFaultThatSaysWhichThereAre) {
  const auto fault_of = [](const Model& model, const CameraChoice& choice) {
    Faults faults;
    const Place all{};
    EXPECT_FALSE(still_camera(model, placed_model(), choice, all.at("camera"), faults));
    EXPECT_EQ(faults.count(), 1U);
    EXPECT_EQ(faults.list().at(0).pointer, "/camera");
    return faults.list().at(0).allowed;
  };
  Model model = two_cameras();
  for (const CameraChoice& choice : {CameraChoice("left"), CameraChoice(2)})
    EXPECT_EQ(fault_of(model, choice),
              "one of the model's cameras, 0, 1, or by its name, front, right");
  model.scenes[0].nodes = {0, 1};
  EXPECT_EQ(fault_of(model, 1), "one of the model's cameras, 0, or by its name, front");
  model.scenes[0].nodes = {0};
  EXPECT_EQ(fault_of(model, 1), "none; the model shows no camera");
}

TEST(StillCamera, TurnsTheStudio) {
  StillRequest request;
  request.camera = "right";
  StillBody body = cube();
  body.camera = camera_of(*request.camera);
  const Scene scene = still_scene(request, body, 1);
  EXPECT_EQ(scene.camera, *body.camera);
  request.camera.reset();
  request.orbit = {90, 0};
  const Scene orbited = still_scene(request, cube(), 1);
  ASSERT_EQ(scene.lights.size(), orbited.lights.size());
  for (std::size_t i = 0; i + 1 < scene.lights.size(); ++i)
    EXPECT_LT(length(*scene.lights[i].place() - *orbited.lights[i].place()), 1e-12);
}

// ---- requests -----------------------------------------------------------------------------------

std::string fault_in(const std::string& json) {
  try {
    read_described<StillRequest>(parse_json(json));
  } catch (const InputError& error) {
    return error.faults().front().pointer;
  }
  return "none";
}

TEST(StillRequestText, IsReadAndChecked) {
  const auto request = read_described<StillRequest>(parse_json(
      R"({"orbit":[-45,90],"zoom":2,"fov":0,"studio":"sun","ground":"floor","background":1})"));
  EXPECT_EQ(request.orbit, (std::array<double, 2>{-45, 90}));
  EXPECT_EQ(request.studio, Studio::sun);
  EXPECT_EQ(request.ground, Ground::floor);
  EXPECT_EQ(request.background, (Backdrop{Color{1, 1, 1}}));
  EXPECT_EQ(fault_in("{}"), "none");
  EXPECT_EQ(fault_in(R"({"orbit":[0,91]})"), "/orbit/1");
  EXPECT_EQ(fault_in(R"({"fov":0.5})"), "/fov");
  EXPECT_EQ(fault_in(R"({"fov":171})"), "/fov");
  EXPECT_EQ(fault_in(R"({"zoom":0})"), "/zoom");
  EXPECT_EQ(fault_in(R"({"camera":0,"zoom":2})"), "/camera");
  EXPECT_EQ(fault_in(R"({"camera":-1})"), "/camera");
  EXPECT_EQ(fault_in(R"({"camera":[]})"), "/camera");
  EXPECT_EQ(fault_in(R"({"turntable":64,"columns":64})"), "none");
  EXPECT_EQ(fault_in(R"({"turntable":65})"), "/turntable");
  EXPECT_EQ(fault_in(R"({"turntable":4,"camera":0})"), "/turntable");
  EXPECT_EQ(fault_in(R"({"columns":4})"), "/columns");
  EXPECT_EQ(fault_in(R"({"turntable":3,"columns":4})"), "/columns");
}

TEST(StillRequestText, IsWrittenAsItIsRead) {
  for (const std::string json : {R"({"camera":3})", R"({"camera":"top","ground":"floor"})",
                                 R"({"background":[1,0,0]})", R"({"studio":"none"})"}) {
    const auto request = read_described<StillRequest>(parse_json(json));
    EXPECT_EQ(parse_json(to_json(write_value(request))), parse_json(json));
  }
  EXPECT_EQ(to_json(write_value(StillRequest{})), "{}");
  const Value schema(whole_schema<StillRequest>());
  EXPECT_NE(to_json(schema).find("\"headlight\""), std::string::npos);
}

}  // namespace
}  // namespace tia
