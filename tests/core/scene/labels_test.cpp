// What answers call objects, against the numbers that the world gives them.
#include "core/scene/labels.h"

#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

/// Grows random trees of objects. Each leaf is met by the line x = 10 k, y = 0 alone, k its number.
class Tree {
 public:
  explicit Tree(std::uint64_t seed) : random_(seed) {}
  int leaves() const { return leaves_; }

  Value::Array objects(int depth) {
    Value::Array list;
    const int count = 1 + random_.below(4);
    for (int i = 0; i < count; ++i) list.push_back(object(depth));
    return list;
  }

 private:
  static Value at_x(double x, double y, double z) { return Value::Array{x, y, z}; }

  Value object(int depth) {
    if (depth > 0 && random_.chance(0.4)) {
      Value::Object group{{"type", "group"}, {"children", objects(depth - 1)}};
      if (random_.chance(0.5))
        group.emplace_back("repeat", Value::Object{{"count", Value::Array{1, 1, 2}},
                                                   {"step", Value::Array{0, 0, -20}}});
      return group;
    }
    const double x = 10.0 * leaves_++;
    Value::Object leaf = shape(x);
    if (random_.chance(0.5)) leaf.emplace_back("name", "leaf " + std::to_string(leaves_ - 1));
    return leaf;
  }
  Value::Object shape(double x) {
    const Value::Object ball{{"type", "sphere"}, {"center", at_x(x, 0, 0)}, {"radius", 1}};
    const Value::Object box{
        {"type", "box"}, {"min", at_x(x - 1, -1, -1)}, {"max", at_x(x + 1, 1, 1)}};
    switch (random_.below(4)) {
      case 0: return ball;
      case 1: return box;
      case 2:
        return {
            {"type", "csg"}, {"operation", "intersection"}, {"children", Value::Array{ball, box}}};
      default:
        return {{"type", "mesh"},
                {"positions", Value::Array{x - 1, -1, 0, x + 1, -1, 0, x, 2, 0}},
                {"indices", Value::Array{0, 1, 2}}};
    }
  }

  Random random_;
  int leaves_ = 0;
};

// The object that a JSON Pointer of /objects/i/children/j leads to.
const Object& found(const Scene& scene, const std::string& pointer) {
  const std::vector<Object>* list = &scene.objects.get();
  const Object* object = nullptr;
  std::istringstream words(pointer.substr(1));
  for (std::string word; std::getline(words, word, '/');) {
    if (word == "objects" || word == "children") continue;
    object = &list->at(std::stoul(word));
    list = children_of(*object);
  }
  return *object;
}

TEST(ObjectLabels, AreInTheOrderOfTheWorldsObjects) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Tree tree(seed);
    const Scene scene = read_scene(to_json(Value::Object{{"objects", tree.objects(3)}}));
    const World world = compile(scene);
    const std::vector<ObjectLabel> labels = object_labels(scene);
    ASSERT_EQ(static_cast<int>(labels.size()), world.objects);
    ASSERT_EQ(world.objects, tree.leaves());
    for (int k = 0; k < tree.leaves(); ++k) {
      const auto hits = all_hits(world, {{10.0 * k, 0.1, 50}, {0, 0, -1}});
      ASSERT_FALSE(hits.empty());
      for (const Meeting& hit : hits) {
        const int object = world.primitive(hit.primitive).object;
        EXPECT_EQ(object, k);  // the order in which the leaves grew
        const ObjectLabel& label = labels[static_cast<std::size_t>(object)];
        if (label.name.starts_with("/")) {
          EXPECT_EQ(found(scene, label.name).name, "");
          EXPECT_NEAR(bounds_of(found(scene, label.name)).center().x, 10.0 * k, 1e-9);
        } else {
          EXPECT_EQ(label.name, "leaf " + std::to_string(k));
        }
      }
    }
  }
}

TEST(ObjectLabels, GiveTheTypeAsTheSceneWritesIt) {
  const Scene scene = read_scene(R"({"objects":[
      {"type":"torus","name":"ring","major_radius":2,"minor_radius":1},
      {"type":"group","name":"hall","children":[
        {"type":"csg","operation":"union","children":[
          {"type":"sphere","name":"inner","center":[0,0,0],"radius":1}]},
        {"type":"disc","center":[0,0,0],"normal":[0,0,1],"radius":1}]}],
      "lights":[{"type":"point","position":[0,0,0]},
                {"type":"sphere","position":[0,0,0],"radius":1}],
      "key_light":{"type":"sphere","radius":1}})");
  const std::vector<ObjectLabel> labels = object_labels(scene);
  const std::vector<std::pair<std::string, std::string_view>> expected{
      {"ring", "torus"},
      {"/objects/1/children/0", "csg"},
      {"/objects/1/children/1", "disc"},
      {"/lights/1", "sphere"}};
  ASSERT_EQ(labels.size(), expected.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i].name, expected[i].first);
    EXPECT_EQ(labels[i].type, expected[i].second);
  }
}

TEST(ObjectLabels, AKeyLightHasOneOnceItHasAPlace) {
  const Scene dark = read_scene(R"({"lights":[{"type":"sphere","position":[1,0,0],"radius":1}],
      "key_light":{"type":"sphere","radius":1}})");
  EXPECT_EQ(object_labels(dark).size(), 1U);
  const std::vector<ObjectLabel> lit = object_labels(with_light(dark, {0, 9, 0}));
  ASSERT_EQ(lit.size(), 2U);
  EXPECT_EQ(lit[1].name, "/key_light");
  EXPECT_EQ(compile(with_light(dark, {0, 9, 0})).objects, 2);
}

}  // namespace
}  // namespace tia::test
