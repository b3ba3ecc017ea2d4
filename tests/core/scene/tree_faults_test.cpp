// What is wrong with objects in objects, all of it at once and each at its own place.
#include <gtest/gtest.h>

#include <ctime>

#include "core/scene/read_scene.h"
#include "tests/core/faults.h"

namespace tia {
namespace {

using test::Expected;

void expect(const std::string& objects, const std::vector<Expected>& expected) {
  test::expect_faults(test::faults_of([&] { read_scene(R"({"objects":[)" + objects + "]}"); }),
                      expected);
}

const std::string ball_json = R"({"type":"sphere","center":[0,0,0],"radius":1})";
const std::string disc_json = R"({"type":"disc","center":[0,0,0],"normal":[0,1,0],"radius":1})";
const std::string plane_json = R"({"type":"plane","point":[0,0,0],"normal":[0,1,0]})";

TEST(TreeFaults, AnOpenShapeInACsgIsNamedWhateverElseIsWrong) {
  expect(
      R"({"type":"csg","operation":"union","children":[
             {"type":"disc","center":[0,0,0],"normal":[0,1,0],"radius":-1},)" +
          ball_json + "," + disc_json + "]}",
      {{FaultKind::out_of_range, "/objects/0/children/0/radius", "-1", "a number above 0"},
       {FaultKind::out_of_range, "/objects/0/children/0/type", "\"disc\"", "in a csg a solid ("},
       {FaultKind::out_of_range, "/objects/0/children/2/type", "\"disc\"", "sphere, plane, box"}});
}

TEST(TreeFaults, AnOpenShapeInAGroupOfACsgIsNamedItself) {
  expect(R"({"type":"csg","operation":"difference","children":[)" + ball_json +
             R"(,{"type":"group","children":[)" + ball_json + "," + disc_json + "]}]}",
         {{FaultKind::out_of_range, "/objects/0/children/1/children/1/type", "\"disc\"", "solid"}});
}

TEST(TreeFaults, ACsgsGroupIsNotRepeated) {
  expect(R"({"type":"csg","operation":"union","children":[)" + ball_json +
             R"(,{"type":"group","repeat":{"count":[2,1,1],"step":[3,0,0]},"children":[)" +
             ball_json + "]}]}",
         {{FaultKind::conflict, "/objects/0/children/1/repeat",
           R"({"count":[2,1,1],"step":[3,0,0]})", "a group without repeat"}});
}

TEST(TreeFaults, ARepeatedPlaneAndTooManyCopiesOfItAreTwo) {
  expect(R"({"type":"group","repeat":{"count":[1000,1000,1000],"step":[1,1,1]},"children":[)" +
             plane_json + "]}",
         {{FaultKind::limit, "/objects/0/repeat/count", "[1000,1000,1000]", "16777216 copies"},
          {FaultKind::conflict, "/objects/0/repeat", R"({"count":[1000,1000,1000],"step":[1,1,1]})",
           "/objects/0/children/0 has none"}});
}

TEST(TreeFaults, GroupsInGroupsMultiply) {
  const auto group = [](const std::string& child) {
    return R"({"type":"group","repeat":{"count":[5000,1,1],"step":[1,0,0]},"children":[)" + child +
           "]}";
  };
  expect(group(group(ball_json)),
         {{FaultKind::limit, "/objects/0/children/0/repeat/count", "[5000,1,1]", "make 5000"}});
}

TEST(TreeFaults, TransformsInTransformsMultiply) {
  const std::string tiny = R"("transform":[{"scale":1e-6}])";
  expect(R"({"type":"group",)" + tiny +
             R"(,"children":[{"type":"sphere","center":[0,0,0],"radius":1,)" + tiny + "}]}",
         {{FaultKind::out_of_range, "/objects/0/children/0/transform", R"([{"scale":0.000001}])",
           "with the transforms around it"}});
}

TEST(TreeFaults, EachCopyOfALuminousBallIsALightOfAtMost4096) {
  const auto glowing = [](int count) {
    return R"({"type":"group","repeat":{"count":[)" + std::to_string(count) +
           R"(,1,1],"step":[3,0,0]},"material":{"emission":1},"children":[)" + ball_json + "]}";
  };
  expect(glowing(4096), {});
  expect(glowing(4097), {{FaultKind::limit, "/objects/0/children/0", "", "4096 luminous balls"}});
}

// What holds it asks for its box; so does all around that. The leaf's is costly.
TEST(TreeFaults, OfNestedGroupsTheLeavesAreMeasuredOnce) {
  std::string terms;
  for (int i = 0; i <= 40; i += 2)
    for (int j = 0; i + j <= 40; j += 2)
      terms += "[" + std::to_string(i) + "," + std::to_string(j) + "," +
               std::to_string(40 - i - j) + ",1],";
  const auto seconds = [&](int depth) {
    std::string object = R"({"type":"algebraic","terms":[)" + terms + "[0,0,0,-1]]}";
    for (int k = 0; k < depth; ++k)
      object = R"({"type":"group","repeat":{"count":[2,1,1],"step":[9,0,0]},"children":[)" +
               object + "]}";
    const std::clock_t start = std::clock();
    EXPECT_THROW(read_scene(R"({"objects":[)" + object + "]}"), InputError);  // none is found
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  seconds(1);
  EXPECT_LT(seconds(12), 3 * seconds(1) + 0.02);
}

}  // namespace
}  // namespace tia
