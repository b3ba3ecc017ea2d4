// Which objects physics means, and what of them cannot take part.
#include "core/motion/bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/simulate.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

// A ball, one in a group, twins, and what no body can be.
const std::string objects = R"("objects":[
    {"name":"ball","type":"sphere","center":[0,1,0],"radius":1},
    {"name":"twin","type":"sphere","center":[9,0,0],"radius":1},
    {"name":"twin","type":"sphere","center":[12,0,0],"radius":1},
    {"type":"group","transform":[{"translate":[0,5,0]},{"rotate_degrees":[0,0,90]}],"children":[
        {"name":"inner","type":"sphere","center":[0,3,0],"radius":1}]},
    {"type":"group","transform":[{"scale":2}],"children":[
        {"name":"large","type":"sphere","center":[0,20,0],"radius":1}]},
    {"type":"group","repeat":{"count":[2,1,1],"step":[4,0,0]},"children":[
        {"name":"copy","type":"sphere","center":[30,0,0],"radius":1}]},
    {"name":"egg","type":"sphere","center":[-9,0,0],"radius":1,"transform":[{"scale":[1,2,1]}]},
    {"name":"floor","type":"plane","point":[0,-50,0],"normal":[0,1,0]},
    {"name":"ring","type":"torus","major_radius":3,"minor_radius":1},
    {"name":"open","type":"mesh","positions":[0,0,0,1,0,0,0,1,0],"indices":[0,1,2]}])";
std::string scene_of(const std::string& physics, const std::string& tracks = "") {
  return "{" + objects + R"(,"physics":{)" + physics + R"(},"animation":{"duration":1,"tracks":[)" +
         tracks + "]}}";
}
void expect_refused(const std::string& physics, const std::vector<test::Expected>& expected,
                    const std::string& tracks = "") {
  SCOPED_TRACE(physics);
  const Scene scene = read_scene(scene_of(physics, tracks));
  test::expect_faults(test::faults_of([&] { check_physics(scene); }), expected);
}

TEST(Bodies, AreFoundByNameAndByPointerWhereverTheyStand) {
  const Scene scene = read_scene(scene_of(
      R"("bodies":[{"object":"inner","mass":1},{"object":"/objects/2","mass":1},
          {"object":"ball","mass":1}],"fixed":[{"object":"floor"}])",
      R"({"target":"/objects/ball","visible":[[0.25,0.75]]})"));
  Faults faults;
  const SceneBodies found = bodies_of(scene, {}, faults);
  EXPECT_TRUE(faults.empty());
  ASSERT_EQ(found.count(), 4);
  // (0, 3, 0), up by 5, a quarter turn about z.
  const Vec3d middle = found.bodies[0].what.place().point(Vec3d{0, 3, 0});
  EXPECT_NEAR(length(middle - Vec3d{-8, 0, 0}), 0, 1e-12);
  EXPECT_EQ(found.name_of(0), "inner");
  EXPECT_EQ(found.name_of(1), "/objects/2");
  EXPECT_EQ(found.name_of(3), "floor");
  EXPECT_EQ(found.bodies[1].what.object->shape, scene.objects[2].shape);
  EXPECT_EQ(found.bodies[2].enters, 0.25);
  EXPECT_EQ(found.bodies[2].leaves, 0.75);
  EXPECT_EQ(found.bodies[0].enters, 0);
  EXPECT_TRUE(std::isinf(found.bodies[0].leaves));
}

TEST(Bodies, PairsAreProductsAndMeansUnlessSaidOtherwise) {
  const Scene scene = read_scene(scene_of(
      R"("bodies":[{"object":"ball","mass":1,"restitution":0.5,"friction":0.25},
                   {"object":"inner","mass":1,"restitution":0.75,"friction":1}],
         "fixed":[{"object":"floor","restitution":0.5,"friction":4}],
         "pairs":[{"objects":["floor","inner"],"restitution":0.125}])"));
  Faults faults;
  const SceneBodies found = bodies_of(scene, {}, faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(found.restitution(0, 1), 0.375);
  EXPECT_EQ(found.friction(1, 0), 0.5);
  EXPECT_EQ(found.restitution(0, 2), 0.25);
  EXPECT_EQ(found.restitution(1, 2), 0.125);
  EXPECT_EQ(found.friction(2, 1), 2);
}

TEST(Bodies, AllThatCannotTakePartIsToldAtOnce) {
  const std::string at = "/physics/bodies/";
  expect_refused(
      R"("bodies":[{"object":"bal","mass":1},{"object":"twin","mass":1},{"object":"ball","mass":1},
          {"object":"/objects/0","mass":1},{"object":"large","mass":1},{"object":"copy","mass":1},
          {"object":"egg","mass":1},{"object":"ring","mass":1}],
         "fixed":[{"object":"ball"},{"object":"/objects/99"}],
         "pairs":[{"objects":["ball","floor"]}])",
      {{FaultKind::unknown_name, at + "0/object", "\"bal\"", "one of ball", "ball"},
       {FaultKind::conflict, at + "1/object", "\"twin\"", "one object alone"},
       {FaultKind::conflict, at + "3/object", "\"/objects/0\"", "no other row"},
       {FaultKind::conflict, at + "4/object", "\"large\"", "neither scale nor skew"},
       {FaultKind::conflict, at + "5/object", "\"copy\"", "outside of groups that repeat"},
       {FaultKind::conflict, "/physics/fixed/0/object", "\"ball\"", "no other row"},
       {FaultKind::unknown_name, "/physics/fixed/1/object", "\"/objects/99\"", "JSON Pointer"},
       {FaultKind::conflict, "/physics/pairs/0/objects/1", "\"floor\"", "bodies or fixed"},
       {FaultKind::conflict, at + "6/object", "\"egg\"", "a sphere, scaled alike"},
       {FaultKind::conflict, at + "7/object", "\"ring\"", "a sphere, scaled alike"}});
  expect_refused(
      R"("bodies":[{"object":"ball","mass":1}],"fixed":[{"object":"ring"}])",
      {{FaultKind::conflict, "/physics/fixed/0/object", "\"ring\"", "by exact a plane"}});
  expect_refused(R"("duration":5000,"bodies":[{"object":"ball","mass":1}])",
                 {{FaultKind::limit, "/physics/duration", "5000", "100000 frames"}});
}

TEST(Bodies, NothingElseMovesThem) {
  const std::string physics = R"("bodies":[{"object":"inner","mass":1},{"object":"ball","mass":1}],
                                 "fixed":[{"object":"floor"}])";
  const auto moved = [&](const std::string& target, const std::string& row,
                         const std::string& name) {
    expect_refused(
        physics, {{FaultKind::conflict, "/physics/" + row + "/object", "\"" + name + "\"", target}},
        R"({"target":")" + target + R"(","formula":"t+1"})");
  };
  moved("/objects/ball/radius", "bodies/1", "ball");
  moved("/objects/0/center", "bodies/1", "ball");
  moved("/objects/3/transform/1/rotate_degrees", "bodies/0", "inner");
  moved("/objects/3/children/inner/transform", "bodies/0", "inner");
  moved("/objects/floor/point", "fixed/0", "floor");
  expect_refused(physics, {},
                 R"({"target":"/objects/ball/material/color","formula":"t"},
                    {"target":"/objects/1/center","formula":["t","t","t"]})");
}

TEST(Bodies, AreThereInOneInterval) {
  const std::string physics =
      R"("bodies":[{"object":"ball","mass":1}],"fixed":[{"object":"floor"}])";
  expect_refused(physics,
                 {{FaultKind::conflict, "/physics/bodies/0/object", "\"ball\"", "one interval"}},
                 R"({"target":"/objects/ball","visible":[[0,1],[2,3]]})");
  expect_refused(physics,
                 {{FaultKind::conflict, "/physics/fixed/0/object", "\"floor\"", "always there"}},
                 R"({"target":"/objects/floor","visible":[[0,1]]})");
}

TEST(Bodies, OfOpenShapesHaveNoMassByDensity) {
  expect_refused(
      R"("solver":"rigid","bodies":[{"object":"open","density":2}])",
      {{FaultKind::conflict, "/physics/bodies/0/density", "2", "a mesh that is closed"}});
}

}  // namespace
}  // namespace tia
