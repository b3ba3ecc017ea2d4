#include "tests/server/handlers/explain_support.h"

namespace tia::test {

Vec3d vec(const Value& value) {
  const auto& list = *value.as<Value::Array>();
  return {*list.at(0).as<double>(), *list.at(1).as<double>(), *list.at(2).as<double>()};
}
Value array(const Vec3d& v) { return Value::Array{v.x, v.y, v.z}; }

Value answer_to(const Value::Object& asked) {
  const Response response = host().post("/explain", to_json(asked));
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(response.content_type, "application/json");
  Value answer = parse_json(response.body);
  // A null would be a number that is not finite.
  EXPECT_EQ(to_json(at(answer, "hits")).find("null"), std::string::npos);
  return answer;
}
std::vector<ExplainedAt> hits_of(const Value& answer) {
  std::vector<ExplainedAt> hits;
  for (const Value& hit : *at(answer, "hits").as<Value::Array>()) {
    EXPECT_EQ(at(hit, "uv").as<Value::Array>()->size(), 2U);
    hits.push_back({number_at(hit, "t"), text_at(hit, "object"), text_at(hit, "type"),
                    vec(at(hit, "point")), vec(at(hit, "normal")), *at(hit, "front").as<bool>()});
  }
  return hits;
}
std::vector<ExplainedAt> along(const std::string& scene, const Vec3d& from, const Vec3d& way) {
  return hits_of(
      answer_to({{"scene", parse_json(scene)},
                 {"ray", Value::Object{{"origin", array(from)}, {"direction", array(way)}}}}));
}

void expect_near(const Vec3d& is, const Vec3d& expected, double within) {
  EXPECT_NEAR(is.x, expected.x, within);
  EXPECT_NEAR(is.y, expected.y, within);
  EXPECT_NEAR(is.z, expected.z, within);
}
void expect_hit(const ExplainedAt& hit, double t, const char* object, bool front) {
  EXPECT_NEAR(hit.t, t, 1e-9 * t);
  EXPECT_EQ(hit.object, object);
  EXPECT_EQ(hit.front, front);
}

}  // namespace tia::test
