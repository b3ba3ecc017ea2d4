// Explanations tell the copies of repeated groups apart.
#include <gtest/gtest.h>

#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia {
namespace {

const Value& told(const Value& object, std::string_view name) {
  for (const auto& [key, value] : std::get<Value::Object>(object.is))
    if (key == name) return value;
  static const Value nothing;
  return nothing;
}
std::string text_of(const Value& object, std::string_view name) {
  return to_json(told(object, name));
}

Explanation explanation_along(const Scene& scene, const Vec3d& origin, const Vec3d& way) {
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  return explain(scene, compile(scene), Ray<double>{origin, normalize(way)}, options);
}

// Things at x = 100 i + 10 j: the outer group repeats i, the inner one j.
Scene grid_of(const std::string& fields) {
  return read_scene(R"({"objects":[
    {"type":"group","repeat":{"count":[2,1,1],"step":[100,0,0]},"children":[
      {"type":"group","repeat":{"count":[3,1,2],"step":[10,0,-10]},"children":[{)" +
                    fields + R"(}]}]},
    {"type":"plane","point":[0,-5,0],"normal":[0,1,0]}],
    "lights":[{"type":"point","position":[120,9,0]}]})");
}

TEST(ExplainedCopies, HitWinnerAndBlockerTellWhichOneOfEachGroup) {
  for (const char* fields : {R"("type":"sphere","center":[0,0,0],"radius":1)",
                             R"("type":"box","min":[-1,-1,-1],"max":[1,1,1])"}) {
    const Scene scene = grid_of(fields);
    const Explanation all = explanation_along(scene, {120.1, 0.2, 20}, {0, 0, -1});
    const Value answer(value_of(all));
    const auto& hits = std::get<Value::Array>(told(answer, "hits").is);
    ASSERT_EQ(hits.size(), 4U);
    EXPECT_EQ(text_of(hits[0], "copy"), "[[1,0,0],[2,0,0]]");
    EXPECT_EQ(text_of(hits[3], "copy"), "[[1,0,0],[2,0,1]]");
    EXPECT_EQ(text_of(hits[0], "id"), text_of(hits[3], "id"));
    EXPECT_EQ(text_of(told(answer, "tree"), "winner_copy"), "[[1,0,0],[2,0,0]]");
    EXPECT_LE(to_json(answer).size(), all.most_bytes);
  }
  const Scene scene = grid_of(R"("type":"sphere","center":[0,0,0],"radius":1)");
  const Value answer(value_of(explanation_along(scene, {120.1, -2, 0}, {0, -1, 0})));
  const Value& tree = told(answer, "tree");
  EXPECT_EQ(text_of(tree, "winner"), R"("/objects/1")");
  EXPECT_EQ(text_of(tree, "winner_copy"), "null") << "of what is there once nothing is told";
  const auto& terms = std::get<Value::Array>(told(tree, "terms").is);
  EXPECT_EQ(text_of(terms.back(), "blocker"), R"("/objects/0/children/0/children/0")");
  EXPECT_EQ(text_of(terms.back(), "blocker_copy"), "[[1,0,0],[2,0,0]]");
}

TEST(ExplainedCopies, LightsTellWhichOneTheyAre) {
  const Scene scene = read_scene(R"({"objects":[
    {"type":"group","repeat":{"count":[1,2,1],"step":[0,3,0]},"children":[
      {"type":"sphere","radius":1,"center":[0,5,0],"material":{"emission":1}}]},
    {"type":"plane","point":[0,0,0],"normal":[0,1,0]}]})");
  const Value answer(value_of(explanation_along(scene, {3, 1, 0}, {0, -1, 0})));
  std::string copies;
  for (const Value& term : std::get<Value::Array>(told(told(answer, "tree"), "terms").is))
    if (text_of(term, "name") == R"("diffuse")") copies += text_of(term, "light_copy");
  EXPECT_EQ(copies, "[[0,0,0]][[0,1,0]]");
}

}  // namespace
}  // namespace tia
