// cameras, lights and variants of glTF.
#include <gmock/gmock.h>

#include "core/models/gltf/gltf_parts.h"
#include "tests/core/models/gltf_part.h"

namespace tia {
namespace {

using test::PartRead;
using testing::ElementsAre;
using testing::IsEmpty;

PartRead views_of(const std::string& json) { return test::read_part(gltf::read_views, json); }
PartRead cameras_of(const std::string& cameras) {
  return views_of(R"({"cameras": [)" + cameras + "]}");
}
PartRead lights_of(const std::string& lights) {
  return views_of(R"({"extensions": {"KHR_lights_punctual": {"lights": [)" + lights + "]}}}");
}

TEST(GltfViews, ADocumentMayHaveNone) {
  const PartRead read = views_of("{}");
  EXPECT_EQ(read.model, Model{});
  EXPECT_THAT(read.fault_lines(), IsEmpty());
}

TEST(GltfViews, CamerasAreRead) {
  const PartRead read = cameras_of(R"({"name": "eye", "type": "perspective", "perspective":
      {"yfov": 0.75, "aspectRatio": 1.5, "znear": 0.01, "zfar": 100}},
      {"type": "perspective", "perspective": {"yfov": 3.14, "znear": 1}},
      {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": -3, "znear": 0, "zfar": 1}})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.cameras, ElementsAre(ModelCamera{"eye", false, 0.75, 1.5, 1, 1},
                                              ModelCamera{"", false, 3.14, std::nullopt, 1, 1},
                                              ModelCamera{"", true, 0, std::nullopt, 2, -3}));
}

TEST(GltfViews, WrongCamerasAreFaults) {
  EXPECT_THAT(cameras_of(R"({}, {"type": "fisheye"}, {"type": "perspective"},
      {"type": "perspective", "orthographic": {"xmag": 1, "ymag": 1}}, {"type": 1},
      {"type": "perspective", "perspective": {}},
      {"type": "perspective", "perspective": {"yfov": 0, "aspectRatio": 0, "znear": -1}},
      {"type": "perspective", "perspective": {"yfov": 3.141592653589793}},
      {"type": "orthographic", "orthographic": {"xmag": 0}}, [])")
                  .fault_lines(),
              ElementsAre("missing /cameras/0/type", "unknown_name /cameras/1/type",
                          "missing /cameras/2/perspective", "missing /cameras/3/perspective",
                          "wrong_type /cameras/4/type", "missing /cameras/5/perspective/yfov",
                          "out_of_range /cameras/6/perspective/yfov",
                          "out_of_range /cameras/6/perspective/aspectRatio",
                          "out_of_range /cameras/6/perspective/znear",
                          "out_of_range /cameras/7/perspective/yfov",
                          "out_of_range /cameras/8/orthographic/xmag",
                          "missing /cameras/8/orthographic/ymag", "wrong_type /cameras/9"));
}

TEST(GltfViews, LightsAreRead) {
  const PartRead read = lights_of(R"({"type": "point"},
      {"name": "sun", "type": "directional", "color": [1, 0.5, 0], "intensity": 3, "range": 10},
      {"type": "spot"}, {"type": "spot", "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}},
      {"type": "point", "spot": {"innerConeAngle": 9}})");
  constexpr double eighth = 0.7853981633974483;
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.lights,
              ElementsAre(ModelLight{"", ModelLightKind::point, {1, 1, 1}, 1, 0, eighth},
                          ModelLight{"sun", ModelLightKind::directional, {1, 0.5, 0}, 3, 0, eighth},
                          ModelLight{"", ModelLightKind::spot, {1, 1, 1}, 1, 0, eighth},
                          ModelLight{"", ModelLightKind::spot, {1, 1, 1}, 1, 0.25, 0.5},
                          ModelLight{"", ModelLightKind::point, {1, 1, 1}, 1, 0, eighth}));
}

// 1.5707963705062866 is the number of 32 bits next to pi / 2, from above.
TEST(GltfViews, ARightAngleOf32BitsIsARightAngle) {
  const PartRead read =
      lights_of(R"({"type": "spot", "spot": {"outerConeAngle": 1.5707963705062866}})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_EQ(read.model.lights.at(0).outer_angle, 1.5707963267948966);
}

TEST(GltfViews, WrongLightsAreFaults) {
  const std::string at = "/extensions/KHR_lights_punctual/lights/";
  EXPECT_THAT(lights_of(R"({}, {"type": "area"}, {"type": "point", "color": [1, 2, 1]},
      {"type": "point", "intensity": -1},
      {"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.5}},
      {"type": "spot", "spot": {"innerConeAngle": 0.8}},
      {"type": "spot", "spot": {"outerConeAngle": 1.6}},
      {"type": "spot", "spot": {"outerConeAngle": 0}},
      {"type": "spot", "spot": {"innerConeAngle": -0.1}})")
                  .fault_lines(),
              ElementsAre("missing " + at + "0/type", "unknown_name " + at + "1/type",
                          "out_of_range " + at + "2/color/1", "out_of_range " + at + "3/intensity",
                          "conflict " + at + "4/spot/innerConeAngle",
                          "conflict " + at + "5/spot/innerConeAngle",
                          "out_of_range " + at + "6/spot/outerConeAngle",
                          "out_of_range " + at + "7/spot/outerConeAngle",
                          "out_of_range " + at + "8/spot/innerConeAngle"));
}

TEST(GltfViews, VariantsAreTheirNames) {
  const PartRead read = views_of(R"({"extensions": {"KHR_materials_variants": {"variants": [
      {"name": "red"}, {"name": "blue"}]}}})");
  EXPECT_THAT(read.model.variants, ElementsAre("red", "blue"));
  EXPECT_THAT(views_of(R"({"extensions": {"KHR_materials_variants": {"variants": [{}, 1]}}})")
                  .fault_lines(),
              ElementsAre("missing /extensions/KHR_materials_variants/variants/0/name",
                          "wrong_type /extensions/KHR_materials_variants/variants/1"));
}

}  // namespace
}  // namespace tia
