// What a ray meets, by /explain, against closed forms.
#include <cmath>

#include "tests/server/handlers/explain_support.h"

namespace tia::test {
namespace {

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
    // In, out into the hole, in, out: the normal points out of the solid, into its hole too.
    EXPECT_EQ(hits[i].front, i % 2 == 0);
    expect_near(hits[i].normal, {0, 0, i % 2 == 0 ? 1.0 : -1.0}, 1e-9);
  }
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

// Where `root` of each hit says the root was: from <= t <= to.
std::vector<Value> roots_of(const std::string& objects, const Vec3d& from, const Vec3d& way) {
  const Value answer =
      answer_to({{"scene", parse_json(R"({"objects":[)" + objects + "]}")},
                 {"ray", Value::Object{{"origin", array(from)}, {"direction", array(way)}}}});
  std::vector<Value> roots;
  for (const Value& hit : *at(answer, "hits").as<Value::Array>()) {
    const Value* root = find(*hit.as<Value::Object>(), "root");
    if (root == nullptr) continue;
    const auto& bracket = *at(*root, "bracket").as<Value::Array>();
    EXPECT_EQ(bracket.size(), 2U);
    EXPECT_LE(*bracket.at(0).as<double>(), number_at(hit, "t"));
    EXPECT_GE(*bracket.at(1).as<double>(), number_at(hit, "t"));
    roots.push_back(*root);
  }
  return roots;
}
double end_of(const Value& root, std::size_t i) {
  return *at(root, "bracket").as<Value::Array>()->at(i).as<double>();
}

// (y + 2) (y + 3) (y + 6) along y = -t in half of the scene's units: its stationary points, where
// 3 y^2 + 22 y + 36 = 0, part the roots at t = 4, 6 and 12.
TEST(Explain, ARootOfAFormulaIsShownBetweenTheStationaryPointsAroundIt) {
  const std::string cubic =
      R"({"type":"algebraic","transform":[{"scale":2}],"terms":[[0,3,0,1],[0,2,0,11],[0,1,0,36],
          [0,0,0,36]],"bounds":{"min":[-9,-9,-9],"max":[9,9,9]}})";
  const auto roots = roots_of(cubic, {0, 0, 0}, {0, -1, 0});
  ASSERT_EQ(roots.size(), 3U);
  const double middle = 22.0 / 3, apart = std::sqrt(22.0 * 22 - 12 * 36) / 3;
  const double ends[] = {-18, middle - apart, middle + apart, 18};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(end_of(roots[i], 0), ends[i], 1e-9);
    EXPECT_NEAR(end_of(roots[i], 1), ends[i + 1], 1e-9);
    EXPECT_EQ(text_at(roots[i], "how"), "the polynomial is monotone between stationary points");
    EXPECT_EQ(number_at(roots[i], "degree"), 3);
  }
}

// Through the middle of a ring the quartic ((x - 4)^2 - 1) ((x + 4)^2 - 1) is stationary at 0 and
// where x^2 = 4^2 + 1; on its plane of symmetry y = 1 it only touches.
TEST(Explain, ARootOfATorusIsShownWithItsBracketOrWhereItTouches) {
  const std::string torus = R"({"type":"torus","major_radius":4,"minor_radius":1})";
  const auto roots = roots_of(torus, {-10, 0, 0}, {1, 0, 0});
  ASSERT_EQ(roots.size(), 4U);
  const double turn = std::sqrt(17.0);
  EXPECT_NEAR(end_of(roots[0], 1), 10 - turn, 1e-9);
  EXPECT_NEAR(end_of(roots[1], 0), 10 - turn, 1e-9);
  EXPECT_NEAR(end_of(roots[1], 1), 10, 1e-9);
  EXPECT_NEAR(end_of(roots[3], 0), 10 + turn, 1e-9);
  const auto touching = roots_of(torus, {-10, 1, 0}, {1, 0, 0});
  ASSERT_EQ(touching.size(), 4U);
  for (const Value& root : touching) {
    EXPECT_EQ(end_of(root, 0), end_of(root, 1));
    EXPECT_EQ(text_at(root, "how"), "a stationary point where the polynomial is 0 to rounding");
  }
}

TEST(Explain, ARootInClosedFormIsItsOwnBracket) {
  const auto roots = roots_of(R"({"type":"quadric","coefficients":[1,1,1,0,0,0,0,0,0,-1]})",
                              {0, 0, 5}, {0, 0, -1});
  ASSERT_EQ(roots.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(end_of(roots[i], 0), i == 0 ? 4 : 6, 1e-12);
    EXPECT_EQ(end_of(roots[i], 0), end_of(roots[i], 1));
    EXPECT_EQ(text_at(roots[i], "how"), "closed form: a quadratic's root");
  }
}

// A ring less a box: the ring's two boundaries that are left have their roots, the box's has none.
TEST(Explain, ARootWithinASolidIsShownToo) {
  EXPECT_EQ(roots_of(R"({"type":"csg","operation":"difference","children":[
      {"type":"torus","major_radius":3,"minor_radius":1},
      {"type":"box","min":[-9,-9,-9],"max":[-3,9,9]}]})",
                     {-10, 0, 0}, {1, 0, 0})
                .size(),
            3U);
  EXPECT_TRUE(
      roots_of(R"({"type":"sphere","center":[0,0,0],"radius":1})", {0, 0, 5}, {0, 0, -1}).empty());
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

// 1000 balls that the ray passes by, whose boxes it goes through, 10 000 times over.
TEST(Explain, ARayThatIsTriedOnTooMuchIsRefused) {
  Value::Array balls;
  for (int i = 0; i < 1000; ++i)
    balls.push_back(Value::Object{
        {"type", "sphere"}, {"center", array({0, 10 + i * 1e-6, 10})}, {"radius", 12}});
  const auto answer = [&](int copies) {
    const Value::Object repeat{{"count", Value::Array{copies, 1, 1}},
                               {"step", array({0.001, 0, 0})}};
    const Value::Object group{{"type", "group"}, {"repeat", repeat}, {"children", balls}};
    const Value::Object scene{{"objects", Value::Array{group}}};
    const Value::Object ray{{"origin", array({-50, 0, 0})}, {"direction", array({1, 0, 0})}};
    return host().post("/explain", to_json(Value::Object{{"scene", scene}, {"ray", ray}}));
  };
  EXPECT_EQ(answer(100).status, 200);
  const Response response = answer(10'000);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
}

}  // namespace
}  // namespace tia::test
