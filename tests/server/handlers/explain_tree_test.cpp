// The tree of /explain, as a client reads it: the terms add up, in float and in their order, to
// the colour of the picture's pixel, for every scene of the gallery.
#include <nlohmann/json.hpp>

#include <stdexcept>

#include "tests/core/support.h"
#include "tests/server/handlers/explain_support.h"
#include "tests/server/picture_support.h"

namespace tia::test {
namespace {

using Json = nlohmann::json;  // trees nest deeper than requests may

Vec3f color(const Json& list) { return {list.at(0), list.at(1), list.at(2)}; }

Vec3f transmittance(const Json& node) {
  return node.contains("transmittance") ? color(node["transmittance"]) : Vec3f{1, 1, 1};
}

// Sums up each ray's terms; a mirrored or refracted ray's light is what its way left of it.
void expect_sum(const Json& node, int depth) {
  Vec3f sum{0, 0, 0};
  EXPECT_EQ(node.at("depth"), depth);
  for (const Json& term : node.at("terms")) {
    const Vec3f value = color(term.at("value"));
    sum = sum + value * term.at("weight").get<float>();
    const std::string name = term.at("name");
    ASSERT_EQ(term.contains("node"), name == "reflection" || name == "refraction") << name;
    if (!term.contains("node")) continue;
    const Json& child = term["node"];
    EXPECT_EQ(value, color(child.at("color")) * transmittance(child));
    expect_sum(child, depth + 1);
  }
  EXPECT_EQ(sum, color(node.at("color"))) << node.dump();
}

std::string view_query(const std::string& scene, int width, int height) {
  return "scene=" + url_encode(scene) + "&width=" + std::to_string(width) +
         "&height=" + std::to_string(height);
}
std::string pixel(int x, int y) { return "&x=" + std::to_string(x) + "&y=" + std::to_string(y); }
Json explained(const std::string& query) {
  const Response response = host().get("/explain?" + query);
  EXPECT_EQ(response.status, 200) << query << response.body;
  return Json::parse(response.body);
}
Pixels<float> drawn(const std::string& query) {
  return decode_pfm(host().get("/render?format=pfm&" + query).body);
}
Vec3f color(const Pixels<float>& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

// Of a fisheye's picture; there is no ray.
bool is_outside_of_disc(int x, int y, int width, int height) {
  const double right = 2 * x + 1 - width, up = 2 * y + 1 - height, radius = std::min(width, height);
  return right * right + up * up > radius * radius;
}

TEST(ExplainTree, AddsUpToThePixelInEverySceneOfTheGallery) {
  const int width = sanitized() ? 40 : 160, height = 3 * width / 4, pixels = rounds(100);
  Random random(440);
  for (const auto& [name, scene] : host().gallery().scenes()) {
    SCOPED_TRACE(name);
    if (name == "anaglyph") continue;  // whose pixels mix two rays; "tree" is the first one's
    // Scenes for path have no tree of rays of their own.
    const std::string view =
        view_query(name, width, height) + "&integrator=whitted&samples=1&threshold=0";
    const Pixels<float> image = drawn(view);
    for (int i = 0; i < pixels && !HasFailure(); ++i) {
      const int x = random.below(width), y = random.below(height);
      if (name == "dome" && is_outside_of_disc(x, y, width, height)) continue;
      const Json tree = explained(view + pixel(x, y)).at("tree");
      expect_sum(tree, 0);
      EXPECT_EQ(color(tree.at("color")), color(image, x, y)) << x << " " << y;
    }
  }
}

TEST(ExplainTree, EachSampleOfAPixelIsTold) {
  const std::string view = view_query("shapes", 80, 60) + "&samples=4&seed=7";
  const Pixels<float> image = drawn(view);
  for (const auto& [x, y] : {std::pair{40, 30}, std::pair{11, 45}, std::pair{66, 29}}) {
    Vec3d sum{};
    for (int sample = 0; sample < 4; ++sample) {
      const Json answer = explained(view + pixel(x, y) + "&sample=" + std::to_string(sample));
      EXPECT_EQ(answer.at("sample"), sample);
      sum = sum + static_cast<Vec3d>(color(answer.at("tree").at("color")));
    }
    EXPECT_EQ(Vec3f(sum * 0.25), color(image, x, y)) << x << " " << y;
  }
}

// A box that glows, a mirror below it, a lamp above it and one beside: the terms are those of a
// textbook.
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
  const Json tree =
      explained("ray.origin=0,1,0&ray.direction=0,-1,0&scene=" + url_encode(scene)).at("tree");
  EXPECT_EQ(tree.at("winner"), "floor");
  EXPECT_NEAR(tree.at("t").get<double>(), 1, 1e-6);
  const auto named = [&](std::string_view name, int which = 0) {
    for (const Json& term : tree.at("terms"))
      if (term.at("name") == name && which-- == 0) return term;
    throw std::runtime_error("no term " + std::string(name));
  };
  EXPECT_EQ(color(named("ambient").at("value")), (Vec3f{0.25, 0.125, 0.0625}));
  const Json blocked = named("diffuse");
  EXPECT_EQ(blocked.at("light"), "/lights/0");
  EXPECT_EQ(blocked.at("visible"), 0);
  EXPECT_EQ(blocked.at("blocker"), "/objects/1");
  EXPECT_EQ(blocked.at("weight"), 0);
  const Json lit = named("diffuse", 1);
  EXPECT_EQ(lit.at("light"), "/lights/1");
  EXPECT_EQ(lit.at("visible"), 1);
  EXPECT_NEAR(lit.at("distance").get<double>(), 5, 1e-5);
  EXPECT_NEAR(lit.at("n_dot_l").get<double>(), 0.6, 1e-6);
  EXPECT_NEAR(lit.at("weight").get<double>(), 0.6, 1e-6);
  EXPECT_EQ(color(lit.at("value")), (Vec3f{0.5, 0.25, 0.125}));
  const Json mirrored = named("reflection");
  EXPECT_EQ(mirrored.at("weight"), 0.5);
  EXPECT_EQ(mirrored.at("node").at("winner"), "/objects/1");
  expect_sum(tree, 0);
  expect_near(static_cast<Vec3d>(color(tree.at("color"))),
              {0.25 + 0.3, 0.125 + 0.15, 0.0625 + 0.075 + 0.25}, 1e-6);
}

// What the floor at the origin is kept from seeing, looking up at a lamp above it.
Json blocker_of(const std::string& more) {
  const std::string scene =
      R"({"objects":[{"name":"floor","type":"plane","point":[0,0,0],"normal":[0,1,0]})" + more +
      "}";
  const Json tree =
      explained("ray.origin=0,0.1,0&ray.direction=0,-1,0&scene=" + url_encode(scene)).at("tree");
  for (const Json& term : tree.at("terms"))
    if (term.contains("blocker")) return term["blocker"];
  return "nobody";
}

TEST(ExplainTree, BlockersAreThoseThatTakeTheLight) {
  const std::string point = R"(],"lights":[{"type":"point","position":[0,5,0]}])";
  const std::string wall =
      R"(,{"name":"wall","type":"disc","center":[0,3,0],"normal":[0,1,0],"radius":1})";
  EXPECT_EQ(blocker_of(point), "nobody");
  EXPECT_EQ(blocker_of(wall + point), "wall");
  // What lets all light through takes none.
  const std::string clear = R"(,{"name":"clear","type":"disc","center":[0,2,0],"normal":[0,1,0],
      "radius":1,"material":{"transmission":1}})";
  EXPECT_EQ(blocker_of(clear + wall + point), "clear");
  EXPECT_EQ(blocker_of(clear + wall + point + R"(,"options":{"transparent_shadows":true})"),
            "wall");
  // Within the lamp's own ball, which does not block it.
  EXPECT_EQ(blocker_of(R"(,{"name":"inner","type":"sphere","center":[0,4,0],"radius":0.3}],
      "lights":[{"type":"sphere","position":[0,5,0],"radius":2}])"),
            "inner");
  // One luminous copy before another.
  EXPECT_EQ(blocker_of(R"(,{"type":"group","repeat":{"count":[1,2,1],"step":[0,3,0]},"children":[
      {"name":"bulb","type":"sphere","center":[0,4,0],"radius":1,"material":{"emission":1}}]}])"),
            "bulb");
  // A lamp whose middle stands on the horizon.
  EXPECT_EQ(blocker_of(R"(,{"name":"post","type":"box","min":[1,-1,-5],"max":[2,9,5]}],
      "lights":[{"type":"sphere","position":[5,0,0],"radius":1,"samples":16}])"),
            "post");
}

// A lamp with an area fades by the distance to its middle, however many of its places shine.
TEST(ExplainTree, FadingDoesNotDependOnSamples) {
  const auto weight = [](const std::string& samples) {
    const std::string scene = R"({"objects":[{"type":"plane","point":[0,0,0],"normal":[0,1,0]}],
      "lights":[{"type":"sphere","position":[0,30,0],"radius":1,"fade_distance":30,"samples":)" +
                              samples + "}]}";
    const Json tree =
        explained("ray.origin=0,1,0&ray.direction=0,-1,0&scene=" + url_encode(scene)).at("tree");
    return tree.at("color").at(0).get<double>();
  };
  EXPECT_NEAR(weight("1"), 1, 1e-6);
  EXPECT_NEAR(weight("64"), 1, 1e-3);  // the cosines are
}

}  // namespace
}  // namespace tia::test
