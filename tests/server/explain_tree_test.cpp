// The tree of /explain, as a client reads it: the terms add up, in float and in their order, to
// the colour of the picture's pixel, for every scene of the gallery.
#include "tests/core/support.h"
#include "tests/server/explain_support.h"
#include "tests/server/picture_support.h"

namespace tia::test {
namespace {

Vec3f color(const Value& value) { return Vec3f(vec(value)); }

Vec3f transmittance(const Value& node) {
  const Value* left = find(*node.as<Value::Object>(), "transmittance");
  return left == nullptr ? Vec3f{1, 1, 1} : color(*left);
}

// Sums up each ray's terms; a mirrored or refracted ray's light is what its way left of it.
void expect_sum(const Value& node, int depth) {
  Vec3f sum{0, 0, 0};
  EXPECT_EQ(number_at(node, "depth"), depth);
  for (const Value& term : *at(node, "terms").as<Value::Array>()) {
    const Vec3f value = color(at(term, "value"));
    sum = sum + value * static_cast<float>(number_at(term, "weight"));
    const Value* child = find(*term.as<Value::Object>(), "node");
    const std::string name = text_at(term, "name");
    ASSERT_EQ(child != nullptr, name == "reflection" || name == "refraction") << name;
    if (child == nullptr) continue;
    EXPECT_EQ(value, color(at(*child, "color")) * transmittance(*child));
    expect_sum(*child, depth + 1);
  }
  EXPECT_EQ(sum, color(at(node, "color"))) << to_json(node);
}

std::string view_query(const std::string& scene, int width, int height) {
  return "scene=" + url_encode(scene) + "&width=" + std::to_string(width) +
         "&height=" + std::to_string(height);
}
std::string pixel(int x, int y) {
  return "&x=" + std::to_string(x) + "&y=" + std::to_string(y);
}
Value explained(const std::string& query) {
  const Response response = explain_host().get("/explain?" + query);
  EXPECT_EQ(response.status, 200) << query << response.body;
  return parse_json(response.body);
}
Pixels<float> drawn(const std::string& query) {
  return decode_pfm(explain_host().get("/render?format=pfm&" + query).body);
}
Vec3f color(const Pixels<float>& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

TEST(ExplainTree, AddsUpToThePixelInEverySceneOfTheGallery) {
  constexpr int width = 160, height = 120, pixels = 100;
  Random random(440);
  for (const auto& [name, scene] : explain_host().gallery().scenes()) {
    SCOPED_TRACE(name);
    const std::string view = view_query(name, width, height) + "&samples=1&threshold=0";
    const Pixels<float> image = drawn(view);
    for (int i = 0; i < pixels && !HasFailure(); ++i) {
      const int x = random.below(width), y = random.below(height);
      const Value answer = explained(view + pixel(x, y));
      expect_sum(at(answer, "tree"), 0);
      EXPECT_EQ(color(at(at(answer, "tree"), "color")), color(image, x, y)) << x << " " << y;
    }
  }
}

TEST(ExplainTree, EachSampleOfAPixelIsTold) {
  const std::string view = view_query("shapes", 80, 60) + "&samples=4&seed=7";
  const Pixels<float> image = drawn(view);
  for (const auto& [x, y] : {std::pair{40, 30}, std::pair{11, 45}, std::pair{66, 29}}) {
    Vec3d sum{};
    for (int sample = 0; sample < 4; ++sample) {
      const Value answer = explained(view + pixel(x, y) + "&sample=" + std::to_string(sample));
      EXPECT_EQ(number_at(answer, "sample"), sample);
      sum = sum + vec(at(at(answer, "tree"), "color"));
    }
    EXPECT_EQ(Vec3f(sum * 0.25), color(image, x, y)) << x << " " << y;
  }
}

// A box that glows, a mirror below it, a lamp above it and one beside: the terms are those of a textbook.
TEST(ExplainTree, TellsWinnersTermsAndLampsByName) {
  const char* const scene = R"({
    "background": [0.1, 0.2, 0.3],
    "objects": [
      {"name": "floor", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
       "material": {"color": [1, 0.5, 0.25], "diffuse": 0.5, "ambient": 0.25, "reflection": 0.5}},
      {"type": "box", "min": [-1, 2, -1], "max": [1, 4, 1],
       "material": {"diffuse": 0, "emission": [0, 0, 0.5]}}],
    "lights": [{"type": "point", "position": [0, 9, 0], "intensity": 2},
               {"type": "point", "position": [4, 3, 0]}]})";
  // Down to the floor at (0, 0, 0), from where the mirror looks up at the box, which stands
  // between the floor and the first lamp.
  const Value answer = answer_to({{"scene", parse_json(scene)},
                                  {"ray", Value::Object{{"origin", array({0, 1, 0})},
                                                        {"direction", array({0, -1, 0})}}}});
  const Value& tree = at(answer, "tree");
  EXPECT_EQ(text_at(tree, "winner"), "floor");
  EXPECT_NEAR(number_at(tree, "t"), 1, 1e-6);
  const auto& terms = *at(tree, "terms").as<Value::Array>();
  const auto named = [&](std::string_view name, int which = 0) -> const Value& {
    for (const Value& term : terms)
      if (text_at(term, "name") == name && which-- == 0) return term;
    throw std::runtime_error("no term " + std::string(name));
  };
  expect_near(vec(at(named("ambient"), "value")), {0.25, 0.125, 0.0625}, 0);
  const Value& blocked = named("diffuse");
  EXPECT_EQ(text_at(blocked, "light"), "/lights/0");
  EXPECT_EQ(number_at(blocked, "visible"), 0);
  EXPECT_EQ(text_at(blocked, "blocker"), "/objects/1");
  EXPECT_EQ(number_at(blocked, "weight"), 0);
  const Value& lit = named("diffuse", 1);
  EXPECT_EQ(text_at(lit, "light"), "/lights/1");
  EXPECT_EQ(number_at(lit, "visible"), 1);
  EXPECT_NEAR(number_at(lit, "distance"), 5, 1e-5);
  EXPECT_NEAR(number_at(lit, "n_dot_l"), 0.6, 1e-6);
  EXPECT_NEAR(number_at(lit, "weight"), 0.6, 1e-6);
  expect_near(vec(at(lit, "value")), {0.5, 0.25, 0.125}, 0);
  const Value& mirrored = named("reflection");
  EXPECT_EQ(number_at(mirrored, "weight"), 0.5);
  EXPECT_EQ(text_at(at(mirrored, "node"), "winner"), "/objects/1");
  expect_sum(tree, 0);
  expect_near(vec(at(tree, "color")), {0.25 + 0.3, 0.125 + 0.15, 0.0625 + 0.075 + 0.25}, 1e-6);
}

}  // namespace
}  // namespace tia::test
