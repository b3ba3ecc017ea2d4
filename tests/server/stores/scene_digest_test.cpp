// The digest of a scene's objects: two are the same if what rays can meet is, and only then.
#include "server/stores/scene_digest.h"

#include <cstring>

#include "core/film/png.h"
#include "core/scene/read_scene.h"
#include "server/stores/objects_parts.h"
#include "tests/core/film/files.h"
#include "tests/core/schema/corpus.h"
#include "tests/server/stores/geometry_support.h"

namespace tia::test {
namespace {

Digest digest_of(const Scene& scene) { return digest_of_objects(scene).all.digest; }

bool meets_the_same(const Scene& a, const Scene& b) {
  return a.objects == b.objects && a.materials == b.materials && a.ambient_light == b.ambient_light;
}

std::optional<Scene> scene_of(const Value& document) {
  try {
    return read_described<Scene>(document);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Returns: whether rays meet something else in the changed scene.
bool expect_told_apart(const Scene& scene, const Scene& changed) {
  const bool same = meets_the_same(scene, changed);
  EXPECT_EQ(digest_of(scene) == digest_of(changed), same) << canonical_text(scene) << '\n'
                                                          << canonical_text(changed);
  return !same;
}

TEST(SceneDigest, IsThatOfWhatRaysMeetInScenesByChance) {
  const JsonSchema schema(parse_json(scene_schema()));
  Corpus corpus(schema, 62);
  int apart = 0, alike = 0;
  for (int i = 0; i < 4000; ++i) {
    const Value document = corpus.document();
    const auto scene = scene_of(document);
    if (!scene) continue;
    for (int k = 0; k < 8; ++k)
      if (const auto changed = scene_of(corpus.changed(document)))
        ++(expect_told_apart(*scene, *changed) ? apart : alike);
  }
  EXPECT_GT(apart, 300);
  EXPECT_GT(alike, 300);
}

// ---- every number and every word -------------------------------------------------------------

constexpr const char* rare = R"({"objects": [
    {"type": "sphere", "center": [1, 2, 3], "radius": 2, "transform": [{"matrix":
      [[1, 0.5, 0.25, 3], [0, 2, 0.125, 4], [0, 0, 3, 5], [0, 0, 0, 1]]}]},
    {"type": "algebraic", "terms": [[2, 0, 0, 1], [0, 3, 0, 2], [0, 0, 0, -1]]},
    {"type": "capsule", "base": [1, 2, 3], "cap": [4, 5, 6], "radius": 2},
    {"type": "voxels", "size": [2, 3, 4], "occupied": [[3, 1], [2, 0], [4, 2]], "cell": [1, 2, 3],
      "materials": [{"color": 0.5}, {"color": 0.25}]},
    {"type": "voxels", "size": [4, 3, 4], "occupied": [[1, 2, 3], [3, 2, 1]]},
    {"type": "triangle", "a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0], "transform":
      [{"translate": [1, 2, 3]}, {"rotate_degrees": [1, 2, 3]}, {"scale": [1, 2, 3]},
       {"rotate_quaternion": [1, 2, 3, 4]}]},
    {"type": "mesh", "positions": [0, 0, 0, 1, 0, 0, 0, 1, 0], "indices": [0, 1, 2],
      "normals": [0, 0, 1, 0, 0.5, 1, 0, 0.25, 1], "uvs": [0, 0, 1, 0, 0, 1],
      "colors": [0, 0.5, 0.25, 1, 0.125, 0.5, 0.25, 1, 0, 0.5, 0.75, 0.5]},
    {"type": "model", "id": "a", "scene": 1, "up": "z", "fit": {"min": [0, 0, 0],
      "max": [1, 2, 3]}, "time": 2, "animation": 3, "variant": "b", "hide": ["c", "d"],
      "point_radius": 2, "materials": {"e": {"color": 0.5}}}]})";

void collect_leaves(Value& value, std::vector<Value*>& leaves) {
  if (auto* list = value.as<Value::Array>())
    for (Value& each : *list) collect_leaves(each, leaves);
  else if (auto* object = value.as<Value::Object>())
    for (auto& [name, member] : *object) collect_leaves(member, leaves);
  else leaves.push_back(&value);
}

// What may stand there instead.
std::vector<Value> others(const Value& leaf) {
  if (const auto* number = leaf.as<double>())
    return {*number + 0.0625, *number + 1, *number - 1, *number / 2};
  if (const auto* truth = leaf.as<bool>()) return {!*truth};
  if (const auto* text = leaf.as<std::string>()) return {*text + "x"};
  return {};
}

TEST(SceneDigest, ChangesWithEachNumberAndWord) {
  const auto changes = static_cast<std::size_t>(rounds(300, 5));
  std::vector<Scene> scenes{read_scene(rare)};
  for (const auto& [name, scene] : host().gallery().scenes()) scenes.push_back(*scene);
  Random random(63);
  for (const Scene& scene : scenes) {
    Value document = write_value(scene);
    std::vector<Value*> leaves;
    collect_leaves(document, leaves);
    int apart = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (leaves.size() > changes && !random.chance(double(changes) / double(leaves.size())))
        continue;
      const Value was = *leaves[i];
      for (const Value& other : others(was)) {
        *leaves[i] = other;
        const auto changed = scene_of(document);
        if (changed) apart += expect_told_apart(scene, *changed);
        if (changed) break;
      }
      *leaves[i] = was;
    }
    EXPECT_GT(apart, 4) << scene.title;
  }
}

TEST(SceneDigest, ChangesWithAPicture) {
  const auto shown = [](std::uint8_t code) {
    Image8 image(2, 2);
    image.rgb.front() = code;
    return read_scene(R"({"materials":{"m":{"texture":{"type":"image","data":")" +
                      base64(encode_png(image)) + R"("}}}})");
  };
  EXPECT_TRUE(expect_told_apart(shown(1), shown(2)));
  EXPECT_FALSE(expect_told_apart(shown(1), shown(1)));
}

// ---- where one list ends and the next begins --------------------------------------------------

// Six small integers are three doubles, tiny ones: whether they stand among the positions or among
// the indices, the mesh's bytes are the same.
TEST(SceneDigest, TellsWhichListANumberIsIn) {
  const auto one_mesh = [](const Mesh& mesh) {
    Scene scene;
    scene.objects.emplace_back().shape = mesh;
    return scene;
  };
  Mesh many;
  many.positions.values = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  many.indices.values = {0, 1, 2, 0, 1, 2, 0, 1, 2};
  Mesh few = many;
  few.indices.values.edit().resize(3);
  static_assert(sizeof(many.positions.values[0]) == 2 * sizeof(many.indices.values[0]));
  few.positions.values.edit().resize(12);
  std::memcpy(&few.positions.values[9], many.indices.values.get().data(),
              6 * sizeof(std::uint32_t));
  EXPECT_TRUE(expect_told_apart(one_mesh(many), one_mesh(few)));
}

// Lists that are not in JSON count, too.
TEST(SceneDigest, TellsWhatOnlyMeshesOfModelsHave) {
  Mesh plain;
  plain.positions.values = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  plain.indices.values = {0, 1, 2};
  Mesh with_uvs = plain, with_tangents = plain;
  with_uvs.more_uvs.values.edit().assign(12, 1.0);
  with_tangents.tangents.values.edit().assign(12, 1.0);
  EXPECT_NE(server::digest_of(plain), server::digest_of(with_uvs));
  EXPECT_NE(server::digest_of(plain), server::digest_of(with_tangents));
  EXPECT_NE(server::digest_of(with_uvs), server::digest_of(with_tangents));
}

TEST(SceneDigest, TellsOneStepOfATransformFromAnother) {
  const auto moved = [](const std::string& step) {
    return read_scene(
        R"({"objects":[{"type":"sphere","radius":1,"center":[0,0,0],"transform":[{")" + step +
        R"(":[1,2,3]}]}]})");
  };
  const Scene scenes[] = {moved("translate"), moved("rotate_degrees"), moved("scale")};
  EXPECT_TRUE(expect_told_apart(scenes[0], scenes[1]));
  EXPECT_TRUE(expect_told_apart(scenes[1], scenes[2]));
  EXPECT_TRUE(expect_told_apart(scenes[2], scenes[0]));
}

// 600 balls stand in three parts: what is named of the parts that changed is what is named of all.
TEST(SceneDigest, OfAFewMovedObjectsIsThatOfTheWholeScene) {
  Random random(7);
  Scene scene;
  for (int i = 0; i < 600; ++i)
    scene.objects.push_back(object_of(Sphere{{random.in(-1, 1), 0, 0}, 1}));
  scene.objects[3].shape = bowl(2);
  ObjectsParts parts;
  std::vector<std::size_t> moved;
  for (int round = 0; round < 20; ++round) {
    const ObjectsName whole = digest_of_objects(scene).all;
    const Digested by_parts = digest_by_parts(scene, moved, parts);
    EXPECT_EQ(by_parts.digest, whole.digest);
    EXPECT_EQ(by_parts.bytes, whole.bytes);
    moved = {3, static_cast<std::size_t>(random.whole(4, 400)), 599};
    for (const std::size_t each : moved)
      scene.objects[each].transform.steps = {Translate{{random.in(-1, 1), 0, 0}}};
  }
}

}  // namespace
}  // namespace tia::test
