// What must not change a picture: moving, turning or scaling the whole world with its camera, the
// order in which objects are written, and how the same thing is put.
#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::picture;

constexpr int picture_width = 96, picture_height = 72;

Scene furnished_scene() {
  return read_scene(R"({
    "camera": {"location": [0,3,12], "look_at": [0,1,0], "fov_degrees": 40}, "background": [0.2,0.3,0.4],
    "objects": [
      {"type":"plane","point":[0,-0.1,0],"normal":[0.1,1,0],"material":{"color":0.6}},
      {"type":"box","min":[-1,0,-1],"max":[1,2,1],"material":{"color":[1,0.2,0.2]},
       "transform":[{"rotate_degrees":[0,30,10]},{"translate":[-3,0.4,0]}]},
      {"type":"torus","major_radius":1,"minor_radius":0.4,"material":{"color":[0.2,1,0.3]},
       "transform":[{"rotate_degrees":[70,0,0]},{"translate":[0.5,1.6,1]}]},
      {"type":"csg","operation":"difference","transform":[{"translate":[3,1.2,0]}],"children":[
        {"type":"sphere","center":[0,0,0],"radius":1.2},
        {"type":"cylinder","base":[0,0,-2],"cap":[0.3,0,2],"radius":0.6,
         "material":{"color":[0.1,0.3,1]}}]},
      {"type":"mesh","positions":[0,0,0,1,0,0,0,1,0,0,0,1],
       "indices":[0,2,1,0,1,3,0,3,2,1,2,3],"transform":[{"scale":2},{"translate":[-0.5,0.4,3]}]},
      {"type":"group","repeat":{"count":[5,2,1],"step":[0.7,0.7,0]},
       "transform":[{"translate":[-2,3,-2]}],
       "children":[{"type":"sphere","center":[0,0,0],"radius":0.3}]}],
    "lights": [{"type":"point","position":[-5,8,6],"intensity":0.8},
               {"type":"point","position":[6,5,3],"color":[0.3,0.2,0.1]}]})");
}

// How many pixels differ by more than one 8-bit level in any channel.
int different(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool apart = false;
    for (std::size_t k = i; k < i + 3; ++k)
      apart = apart || !(std::fabs(a.rgb[k] - b.rgb[k]) <= 1 / 255.0F);
    count += apart;
  }
  return count;
}

// The whole world and its camera carried along by a map that keeps angles.
Scene carried(Scene scene, const TransformSteps& by) {
  const Affine map = by.affine();
  for (Object& object : scene.objects.edit())
    for (const TransformSteps::Step& step : by.steps) object.transform.steps.push_back(step);
  for (Light& light : scene.lights) light.move_to(map.point(*light.place()), {});
  scene.camera.location = map.point(scene.camera.location);
  scene.camera.look_at = map.point(*scene.camera.look_at);
  scene.camera.up = map.vector(scene.camera.up);
  return scene;
}

TEST(Invariance, AWorldMovedTurnedOrScaledWithItsCameraLooksTheSame) {
  const Image before = picture(furnished_scene(), picture_width, picture_height).image;
  test::Random random(90);
  for (int i = 0; i < 24; ++i) {
    TransformSteps by;
    if (i % 3 == 0) by.steps.push_back(RotateDegrees{random.point(180)});
    if (i % 3 == 1) by.steps.push_back(Scale{random.chance(0.5) ? 1e3 : 1e-3});
    if (i % 3 == 2) by.steps.push_back(Translate{random.point(100)});
    if (i >= 12) by.steps.push_back(RotateDegrees{random.point(180)});
    const Image after =
        picture(carried(furnished_scene(), by), picture_width, picture_height).image;
    // Only outlines and edges of shadows may fall on the other side of a pixel's centre: there are
    // some 2500 of their pixels, and rounding moves them by 1e-5 of a pixel.
    EXPECT_LE(different(before, after), 3) << i;
  }
}

TEST(Invariance, ThePictureDoesNotDependOnTheOrderOfObjects) {
  const Scene scene = furnished_scene();
  for (const IntegratorName integrator :
       {IntegratorName::thesis, IntegratorName::normal, IntegratorName::depth}) {
    RenderOptions options;
    options.integrator = integrator;
    const auto before = test::bits_of(picture(scene, picture_width, picture_height, options).image);
    Scene shuffled = scene;
    for (std::size_t turn = 1; turn < scene.objects.size(); ++turn) {
      std::vector<Object>& list = shuffled.objects.edit();
      std::rotate(list.begin(), list.begin() + 1, list.end());
      EXPECT_EQ(test::bits_of(picture(shuffled, picture_width, picture_height, options).image),
                before)
          << turn;
    }
  }
}

TEST(Invariance, OneThingInManySpellingsIsOnePicture) {
  // A unit ball as sphere, quadric, algebraic surface, ellipsoid of a scaled ball, and union.
  const char* balls[] = {
      R"({"type":"sphere","center":[0,0,0],"radius":1})",
      R"({"type":"quadric","coefficients":[1,1,1,0,0,0,0,0,0,-1]})",
      R"({"type":"algebraic","terms":[[2,0,0,1],[0,2,0,1],[0,0,2,1],[0,0,0,-1]]})",
      R"({"type":"sphere","center":[0,0,0],"radius":0.5,"transform":[{"scale":[2,1,2]},{"scale":[1,2,1]}]})",
      R"({"type":"csg","operation":"union","children":[{"type":"sphere","center":[0,0,0],"radius":1},
          {"type":"sphere","center":[0.1,0,0],"radius":0.5}]})",
      R"({"type":"csg","operation":"intersection","children":[
          {"type":"sphere","center":[0,0,0],"radius":1},
          {"type":"plane","point":[0,5,0],"normal":[0,1,0]}]})",
  };
  Image first;
  for (const char* ball : balls) {
    Scene scene = furnished_scene();
    scene.objects[1] = read_scene(std::string(R"({"objects":[)") + ball + "]}").objects[0];
    scene.objects[1].transform.steps.push_back(Translate{{-2.5, 1.5, 1}});
    const Image image = picture(scene, picture_width, picture_height).image;
    if (first.rgb.empty()) first = image;
    EXPECT_LE(different(first, image), 2) << ball;
  }
}

}  // namespace
}  // namespace tia
