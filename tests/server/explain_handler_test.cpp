// /explain: every crossing of a pixel's ray or of a free one, against closed forms.
#include <cmath>

#include "core/core.h"
#include "core/math/deterministic.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

Host& host() {
  static Host shared;
  return shared;
}

struct ExplainedAt {
  double t;
  std::string object, type;
  Vec3d point, normal;
  bool front;
};

Vec3d vec(const Value& value) {
  const auto& list = *value.as<Value::Array>();
  return {*list.at(0).as<double>(), *list.at(1).as<double>(), *list.at(2).as<double>()};
}
Value array(const Vec3d& v) { return Value::Array{v.x, v.y, v.z}; }

Value answer_to(const Value::Object& asked) {
  const Response response = host().post("/explain", to_json(asked));
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(response.content_type, "application/json");
  EXPECT_EQ(response.body.find("null"), std::string::npos);  // a number that is not finite
  return parse_json(response.body);
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

// ---- free rays ---------------------------------------------------------------------------------

// Through the centre of a sphere at distance d: t = d - r from outside, d + r from inside.
TEST(Explain, ASphereIsMetAtItsDistanceLessItsRadiusAndPlus) {
  const auto hits = along(R"({"objects":[
      {"type":"sphere","name":"ball","center":[0,0,-20],"radius":4}]})",
                          {0, 0, 0}, {0, 0, -3});
  ASSERT_EQ(hits.size(), 2U);
  expect_hit(hits[0], 16, "ball", true);
  expect_hit(hits[1], 24, "ball", false);
  expect_near(hits[0].point, {0, 0, -16}, 1e-9);
  expect_near(hits[0].normal, {0, 0, 1}, 1e-12);
  expect_near(hits[1].normal, {0, 0, -1}, 1e-12);  // outwards on the far side, too
  EXPECT_EQ(hits[0].type, "sphere");
}

TEST(Explain, FromInsideASphereOnlyTheWayOutIsMet) {
  const auto hits =
      along(R"({"objects":[{"type":"sphere","center":[1,2,3],"radius":5}]})", {1, 2, 3}, {0, 2, 0});
  ASSERT_EQ(hits.size(), 1U);
  expect_hit(hits[0], 5, "/objects/0", false);
  expect_near(hits[0].point, {1, 7, 3}, 1e-9);
}

TEST(Explain, SpheresInARowAreMetInOrderHoweverTheSceneListsThem) {
  const auto hits = along(R"({"objects":[
      {"type":"sphere","name":"far","center":[0,0,-30],"radius":1},
      {"type":"sphere","name":"near","center":[0,0,-10],"radius":1},
      {"type":"sphere","name":"middle","center":[0,0,-20],"radius":1}]})",
                          {0, 0, 0}, {0, 0, -1});
  ASSERT_EQ(hits.size(), 6U);
  const char* const names[] = {"near", "near", "middle", "middle", "far", "far"};
  const double t[] = {9, 11, 19, 21, 29, 31};
  for (std::size_t i = 0; i < 6; ++i) expect_hit(hits[i], t[i], names[i], i % 2 == 0);
}

TEST(Explain, WhatIsBehindOrBesideIsNotMet) {
  EXPECT_TRUE(along(R"({"objects":[{"type":"sphere","center":[0,0,9],"radius":1},
                                   {"type":"sphere","center":[5,0,-9],"radius":1}]})",
                    {0, 0, 0}, {0, 0, -1})
                  .empty());
}

// In the sphere's own space the ray is (o - c)/s + t d/s: |.|^2 = 1 is a quadratic in t.
TEST(Explain, AStretchedSphereIsMetWhereTheQuadraticSays) {
  const Vec3d scale{2, 0.5, 3}, center{1, -1, -20}, from{0.3, 0.2, 4};
  const Vec3d way = normalize(Vec3d{0.02, -0.045, -1});
  const auto hits = along(R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,
      "transform":[{"scale":[2,0.5,3]},{"translate":[1,-1,-20]}]}]})",
                          from, way * 17.0);
  const auto over = [](const Vec3d& v, const Vec3d& s) {
    return Vec3d{v.x / s.x, v.y / s.y, v.z / s.z};
  };
  const Vec3d o = over(from - center, scale), d = over(way, scale);
  const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
  const double root = std::sqrt(b * b - a * c);
  ASSERT_EQ(hits.size(), 2U);
  expect_hit(hits[0], (-b - root) / a, "/objects/0", true);
  expect_hit(hits[1], (-b + root) / a, "/objects/0", false);
  for (const ExplainedAt& hit : hits) {
    expect_near(hit.point, from + way * hit.t, 1e-9 * 20);
    const Vec3d on = over(hit.point - center, scale);
    EXPECT_NEAR(dot(on, on), 1, 1e-9);
    expect_near(hit.normal, normalize(over(on, scale)), 1e-9);  // the gradient of |p/s|^2
  }
}

// A cube from -1 to 1 without the ball of radius 1/2 in its middle.
TEST(Explain, ASolidIsMetAtItsOwnFacesAndAtThoseOfItsHoles) {
  const auto hits = along(R"({"objects":[{"type":"csg","name":"part","operation":"difference",
      "children":[{"type":"box","min":[-1,-1,-1],"max":[1,1,1]},
                  {"type":"sphere","center":[0,0,0],"radius":0.5}]}]})",
                          {0, 0, 10}, {0, 0, -1});
  ASSERT_EQ(hits.size(), 4U);
  const double t[] = {9, 9.5, 10.5, 11};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(hits[i].t, t[i], 1e-9);
    EXPECT_EQ(hits[i].object, "part");
    EXPECT_EQ(hits[i].type, "csg");
  }
  EXPECT_TRUE(hits[0].front);
  EXPECT_FALSE(hits[3].front);
}

TEST(Explain, AMeshIsMetOnceWhereItsTrianglesShareAnEdge) {
  const std::string square = R"({"objects":[{"type":"mesh","name":"square",
      "positions":[-1,-1,-5, 1,-1,-5, 1,1,-5, -1,1,-5],"indices":[0,1,2, 0,2,3]}]})";
  for (const Vec3d& to : {Vec3d{0, 0, -1}, Vec3d{0.1, -0.1, -1}}) {
    const auto hits = along(square, {0, 0, 0}, to);
    ASSERT_EQ(hits.size(), 1U);
    expect_hit(hits[0], 5 * length(to), "square", true);
    EXPECT_EQ(hits[0].type, "mesh");
    expect_near(hits[0].normal, {0, 0, 1}, 1e-12);
  }
}

TEST(Explain, EveryCopyOfARepeatedGroupIsMet) {
  const auto hits = along(R"({"objects":[{"type":"group","name":"row",
      "repeat":{"count":[5,1,1],"step":[3,0,0]},
      "children":[{"type":"sphere","center":[0,0,0],"radius":1},
                  {"type":"sphere","name":"above","center":[0,9,0],"radius":1}]}]})",
                          {-10, 0, 0}, {1, 0, 0});
  ASSERT_EQ(hits.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i)
    expect_hit(hits[i], 9 + 3.0 * static_cast<double>(i / 2) + (i % 2 == 0 ? 0 : 2),
               "/objects/0/children/0", i % 2 == 0);
}

TEST(Explain, LuminousBallsAreMetAsTheLightsTheyAre) {
  const auto hits = along(R"({"lights":[{"type":"point","position":[0,0,-3]},
      {"type":"sphere","position":[0,0,-6],"radius":1}],
      "key_light":{"type":"sphere","position":[0,0,-12],"radius":2}})",
                          {0, 0, 0}, {0, 0, -1});
  ASSERT_EQ(hits.size(), 4U);
  expect_hit(hits[0], 5, "/lights/1", true);
  expect_hit(hits[2], 10, "/key_light", true);
  EXPECT_EQ(hits[0].type, "sphere");
}

TEST(Explain, AFreeRayHasADirectionOfLengthOneAndNoPixel) {
  const Value answer = answer_to(
      {{"ray", Value::Object{{"origin", array({1, 2, 3})}, {"direction", array({0, -3, 4})}}}});
  expect_near(vec(at(at(answer, "ray"), "origin")), {1, 2, 3}, 0);
  expect_near(vec(at(at(answer, "ray"), "direction")), {0, -0.6, 0.8}, 1e-15);
  EXPECT_EQ(find(*answer.as<Value::Object>(), "pixel"), nullptr);
  EXPECT_EQ(find(*answer.as<Value::Object>(), "sample"), nullptr);
}

// 3000 copies in a row are crossed 6000 times, 6000 of them more often than an answer may say.
TEST(Explain, ARayThatCrossesTooMuchIsRefused) {
  const auto row = [](const std::string& count) {
    return to_json(Value::Object{
        {"scene", parse_json(R"({"objects":[{"type":"group","repeat":{"count":[)" + count +
                             R"(,1,1],"step":[3,0,0]},"children":[
                             {"type":"sphere","center":[0,0,0],"radius":1}]}]})")},
        {"ray", Value::Object{{"origin", array({-10, 0, 0})}, {"direction", array({1, 0, 0})}}}});
  };
  EXPECT_EQ(host().post("/explain", row("3000")).status, 200);
  const Response response = host().post("/explain", row("6000"));
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  EXPECT_THAT(only_error(response).allowed, testing::HasSubstr("10000"));
}

// ---- pixels ------------------------------------------------------------------------------------

// The thesis: xx = (2x+1-W)/W tan(fov/2) W/H, yy = (H-2y-1)/H tan(fov/2), direction (xx, yy, -1).
TEST(Explain, APixelsRayIsTheThesis) {
  const double tangent = tan_of(12.5 * pi / 180);
  for (const auto& [x, y] :
       std::vector<std::pair<int, int>>{{0, 0}, {639, 479}, {320, 240}, {17, 401}}) {
    const Value answer = answer_to({{"x", x}, {"y", y}});
    EXPECT_EQ(at(answer, "pixel"), Value(Value::Array{x, y}));
    EXPECT_EQ(number_at(answer, "sample"), 0);
    const double xx = (2.0 * x + 1 - 640) / 640 * tangent * 640 / 480;
    const double yy = (480 - 2.0 * y - 1) / 480 * tangent;
    expect_near(vec(at(at(answer, "ray"), "origin")), {0, 0, 0}, 0);
    expect_near(vec(at(at(answer, "ray"), "direction")), normalize(Vec3d{xx, yy, -1}), 1e-15);
  }
}

TEST(Explain, ThePixelInTheMiddleMeetsTheThesisBall) {
  const auto hits = hits_of(answer_to({{"x", 320}, {"y", 240}}));
  ASSERT_GE(hits.size(), 2U);
  EXPECT_EQ(hits[0].object, "ball");
  EXPECT_NEAR(hits[0].t, 16, 1e-4);  // half a pixel off the axis
  EXPECT_TRUE(hits[0].front);
}

TEST(Explain, SeesTheSceneAfterItsKeyAndThroughTheRequestsCamera) {
  const auto lamp =
      hits_of(answer_to({{"x", 50},
                         {"y", 50},
                         {"width", 101},
                         {"height", 101},
                         {"light", array({0, 0, -50})},
                         {"camera", Value::Object{{"location", array({0, 0, -60})}}}}));
  ASSERT_GE(lamp.size(), 1U);  // it looks from behind at the lamp of radius 3, 10 away
  EXPECT_EQ(lamp[0].object, "/key_light");
  EXPECT_NEAR(lamp[0].t, 7, 1e-9);
}

TEST(Explain, GetAndPostSayTheSame) {
  const std::string by_get =
      host().get("/explain?ray.origin=0,0,0&ray.direction=0,0.1,-1&key=a").body;
  EXPECT_EQ(host()
                .post("/explain", R"({"key":"a","ray":{"origin":[0,0,0],"direction":[0,0.1,-1]}})")
                .body,
            by_get);
  EXPECT_EQ(
      host()
          .get("/explain?key=a&ray=" + url_encode(R"({"origin":[0,0,0],"direction":[0,0.1,-1]})"))
          .body,
      by_get);
  EXPECT_EQ(host().get("/explain?x=7&y=9").body, host().post("/explain", R"({"x":7,"y":9})").body);
  EXPECT_EQ(host().head("/explain?x=7&y=9").status, 200);
}

// ---- faults ------------------------------------------------------------------------------------

struct Fault {
  const char* query;
  const char* type;
  const char* pointer;
  const char* allowed;
};
TEST(Explain, FaultsAreNamedAlikeWhereverTheyAre) {
  const Fault faults[] = {
      {"x=640&y=0", "out-of-range", "/x", "an integer from 0 to 639"},
      {"x=0&y=480", "out-of-range", "/y", "an integer from 0 to 479"},
      {"x=20&y=0&width=20&height=20", "out-of-range", "/x", "from 0 to 19"},
      {"x=-1&y=0", "out-of-range", "/x", "from 0"},
      {"x=0.5&y=0", "wrong-type", "/x", "an integer"},
      {"x=3", "missing", "/y", "from 0 to 479"},
      {"y=3", "missing", "/x", "ray"},
      {"x=3&ray.origin=0,0,0&ray.direction=0,0,-1", "conflict", "/x", "or ray"},
      {"ray.origin=0,0,0&ray.direction=0,0,0", "out-of-range", "/ray/direction", "some length"},
      {"ray.origin=0,0,0&ray.direction=1e-200,0,0", "out-of-range", "/ray/direction",
       "some length"},
      {"ray.origin=0,0,0", "missing", "/ray/direction", "3 numbers"},
      {"ray.origin=0,0&ray.direction=0,0,1", "wrong-type", "/ray/origin", "3 numbers"},
      {"ray.origin=0,0,2e9&ray.direction=0,0,1", "out-of-range", "/ray/origin/2", "1000000000"},
      {"ray.orign=0,0,0&ray.origin=0,0,0&ray.direction=0,0,1", "unknown-name", "/ray/orign",
       "origin"},
      {"ray=up", "wrong-type", "/ray", "an object"},
      {"x=1&y=1&samples=4", "unknown-name", "/samples", "scene, key, light"},
      {"x=1&y=1&scene.title=a", "unknown-name", "/scene.title", "scene"},
      {"x=1&y=1&scene=thesi", "unknown-name", "/scene", "thesis"},
      {"x=1&y=1&width=5000&height=5000", "limit", "/width", "TIA_MAX_PIXELS"},
      {"ray.origin=0,0,0&ray.origin=1,0,0", "malformed", "/ray/origin", "once"},
      {"ray=up&ray.origin=1,0,0", "malformed", "/ray", "once"},
      {"ray.origin=0,0,0&ray=up", "malformed", "/ray", "once"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.query);
    const Response response = host().get(std::string("/explain?").append(fault.query));
    EXPECT_EQ(problem_of(response).type, std::string("/problems/").append(fault.type));
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, fault.pointer);
    EXPECT_THAT(error.allowed, testing::HasSubstr(fault.allowed));
  }
}

TEST(Explain, WithoutPixelAndRayBothCoordinatesAreMissing) {
  const Problem problem = problem_of(host().get("/explain"));
  EXPECT_EQ(problem.type, "/problems/missing");
  ASSERT_EQ(problem.errors.size(), 2U);
  EXPECT_EQ(problem.errors[0].pointer, "/x");
  EXPECT_EQ(problem.errors[1].pointer, "/y");
}

}  // namespace
}  // namespace tia::test
