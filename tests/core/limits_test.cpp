// What an input may hold at most, in the contract's own numbers: each limit is met and passed by
// one, and nothing here is computed from the constant that it pins. Those that only a huge input
// would meet are named as they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "core/accel/world/all_hits.h"
#include "core/film/decode.h"
#include "core/formulas/parse.h"
#include "core/input/errors.h"
#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "core/lights/sky_picture.h"
#include "core/lights/sphere_light.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "core/shapes/algebraic/algebraic_term.h"
#include "core/shapes/mesh/mesh.h"
#include "core/shapes/voxels/voxel_list.h"
#include "tests/core/film/files.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

// ---- texts ----------------------------------------------------------------------------------

// What parsing says against a text, at most the start of it; "" where it is read.
std::string said_of(const std::string& text) {
  try {
    parse_json(text);
  } catch (const InputError& error) {
    return error.faults().front().allowed;
  }
  return "";
}

TEST(LimitNumbers, AJsonTextHas32Levels) {
  EXPECT_EQ(said_of(times(32, "[") + times(32, "]")), "");
  EXPECT_EQ(said_of(times(33, "[") + times(33, "]")), "at most 32 levels of arrays and objects");
}

TEST(LimitNumbers, AJsonTextHas100000ValuesBesidesNumbersInArrays) {
  EXPECT_EQ(said_of("[" + times(99'998, "[],") + "0,1,2,[]]"), "");  // the array itself is one
  EXPECT_THAT(said_of("[" + times(99'999, "[],") + "0,1,2,[]]"),
              testing::StartsWith("at most 100000 JSON values"));
}

// ---- what is wrong --------------------------------------------------------------------------

TEST(LimitNumbers, TwentyFaultsAreKept) {
  Faults faults;
  for (int i = 0; i < 19; ++i) faults.add({});
  EXPECT_FALSE(faults.full());
  faults.add({});
  EXPECT_TRUE(faults.full());
  faults.add({});
  EXPECT_EQ(faults.list().size(), 20U);
  EXPECT_EQ(faults.count(), 21U);
}

TEST(LimitNumbers, AFaultEchoes120Bytes) {
  EXPECT_EQ(excerpt(std::string(120, 'x')), Value(std::string(120, 'x')));
  EXPECT_EQ(excerpt(std::string(121, 'x')), Value(std::string(100, 'x') + "… (21 bytes more)"));
}

TEST(LimitNumbers, AListOfNamesNames64Of64BytesEach) {
  EXPECT_EQ(listed(std::vector<std::string_view>(64, "a")), times(63, "a, ") + "a");
  EXPECT_EQ(listed(std::vector<std::string_view>(65, "a")), times(63, "a, ") + "a and 1 more");
  const std::string name(65, 'n');
  EXPECT_EQ(listed({std::string_view(name).substr(1)}), std::string(64, 'n'));
  EXPECT_EQ(listed({name}), std::string(45, 'n') + "… (20 bytes more)");
}

TEST(LimitNumbers, APointerHas512BytesAndWhatIsAllowed1024) {
  const auto kept = [](std::size_t pointer, std::size_t allowed) {
    const std::string place = "/" + std::string(pointer - 1, 'p'), words(allowed, 'w');
    const Fault fault = InputError({FaultKind::limit, place, {}, words}).faults().front();
    return std::pair(fault.pointer == place, fault.allowed == words);
  };
  EXPECT_EQ(kept(512, 1024), std::pair(true, true));
  EXPECT_EQ(kept(513, 1025), std::pair(false, false));
}

// ---- what comes in bulk ---------------------------------------------------------------------

TEST(LimitNumbers, AnInputHas16777216PixelsAnd33554432Cells) {
  Faults fit, unfit;
  EXPECT_TRUE(fit.take(Bulk::pixels, 16'777'216));
  EXPECT_FALSE(fit.take(Bulk::pixels, 1));
  EXPECT_FALSE(unfit.take(Bulk::pixels, 16'777'217));
  EXPECT_TRUE(fit.take(Bulk::cells, 33'554'432));
  EXPECT_FALSE(fit.take(Bulk::cells, 1));
  EXPECT_FALSE(unfit.take(Bulk::cells, 33'554'433));
}

// Whether a picture's header lets it pass.
bool is_taken(const test::Bytes& file) {
  return std::holds_alternative<PictureSize>(measure_picture(file));
}

TEST(LimitNumbers, APictureHas1048576Bytes) {
  test::Bytes file = test::png({1, 1, 8, test::grey}, "\x40");
  file.resize(1'048'576);
  EXPECT_TRUE(is_taken(file));
  file.push_back(0);
  EXPECT_FALSE(is_taken(file));
}

TEST(LimitNumbers, APictureHas4194304Pixels) {
  EXPECT_TRUE(is_taken(test::png({4'194'304, 1, 8, test::grey}, "x")));
  EXPECT_FALSE(is_taken(test::png({4'194'305, 1, 8, test::grey}, "x")));
}

TEST(LimitNumbers, ASkyHas8388608BytesAndPixels) {
  test::Bytes file = test::png({2, 1, 8, test::grey}, "\x40");
  const auto is_sky = [&] { return std::holds_alternative<PictureSize>(measure_sky(file)); };
  file.resize(8'388'608);
  EXPECT_TRUE(is_sky());
  file.push_back(0);
  EXPECT_FALSE(is_sky());
  EXPECT_FALSE(beyond(PictureSize{8'388'608, 1}, sky_picture_limits));
  EXPECT_TRUE(beyond(PictureSize{8'388'609, 1}, sky_picture_limits));
}

TEST(LimitNumbers, AJpegHas64ScansASequentialOne8) {
  const auto takes = [](test::Bytes file, int scans, int has) {
    for (; has < scans; ++has) file.insert(file.end(), {0xFF, 0xDA});
    return is_taken(file);
  };
  const test::Bytes sequential = test::flat_jpeg({100});
  const test::Bytes progressive = test::flat_jpeg({100}, test::JpegKind::progressive);
  EXPECT_TRUE(takes(progressive, 64, 2));
  EXPECT_FALSE(takes(progressive, 65, 2));
  EXPECT_TRUE(takes(sequential, 8, 1));
  EXPECT_FALSE(takes(sequential, 9, 1));
}

// ---- formulas -------------------------------------------------------------------------------

// The kind of what is wrong with a formula of x and y, or nothing.
std::optional<FaultKind> fault_in(const std::string& formula) {
  ProgramBuilder builder;
  Faults faults;
  read_formula(formula, {{"x", "y"}, {}}, {}, builder, faults);
  if (faults.empty()) return std::nullopt;
  return faults.list().front().kind;
}

TEST(LimitNumbers, AFormulaHas4096Bytes) {
  EXPECT_EQ(fault_in("x" + std::string(4095, ' ')), std::nullopt);
  EXPECT_EQ(fault_in("x" + std::string(4096, ' ')), FaultKind::limit);
}

TEST(LimitNumbers, AFormulaHas100ThingsOpenAtOnce) {
  EXPECT_EQ(fault_in(times(100, "(") + "x" + times(100, ")")), std::nullopt);
  EXPECT_EQ(fault_in(times(101, "(") + "x" + times(101, ")")), FaultKind::limit);
}

// A variable, a sum and abs cost 1 each, the others 10: 1 + 4 * 990 + 3 of these, and 1 + n more.
TEST(LimitNumbers, AFormulaCosts4000Additions) {
  const auto nested = [](const std::string& function, std::size_t n) {
    return times(n, function + "(") + "x" + times(n, ")");
  };
  const std::string costly = nested("exp", 99) + "+" + nested("log", 99) + "+" + nested("sin", 99) +
                             "+" + nested("cos", 99);
  EXPECT_EQ(fault_in(costly + "+" + nested("abs", 35)), std::nullopt);
  EXPECT_EQ(fault_in(costly + "+" + nested("abs", 36)), FaultKind::limit);
}

// ---- scenes ---------------------------------------------------------------------------------

bool is_scene(const std::string& text) {
  try {
    read_scene(text);
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().size(), 1U) << error.what();
    return false;
  }
}

TEST(LimitNumbers, AThingIsRepeated16777216Times) {
  const auto repeated = [](const std::string& count) {
    return is_scene(
        R"({"objects":[{"type":"group","repeat":{"count":)" + count +
        R"(,"step":[1,1,1]},"children":[{"type":"sphere","center":[0,0,0],"radius":1}]}]})");
  };
  EXPECT_TRUE(repeated("[16777216,1,1]"));
  EXPECT_FALSE(repeated("[16777217,1,1]"));
  EXPECT_TRUE(repeated("[4096,4096,1]"));
  EXPECT_FALSE(repeated("[4096,4096,2]"));
}

TEST(LimitNumbers, ASceneHas65536NumberedMaterials) {
  const auto wearing = [](std::size_t materials) {
    return is_scene(R"({"objects":[{"type":"voxels","size":[1,1,1],"occupied":[[0,0,0,1]],)"
                    R"("materials":[{})" +
                    times(materials - 1, ",{}") + "]}]}");
  };
  EXPECT_TRUE(wearing(65'536));
  EXPECT_FALSE(wearing(65'537));
}

TEST(LimitNumbers, ASceneHas4096LuminousBalls) {
  const auto glowing = [](const std::string& balls) {
    return is_scene(R"({"objects":[{"type":"group","repeat":{"count":[)" + balls +
                    R"(,1,1],"step":[9,0,0]},"material":{"emission":[1,1,1]},)"
                    R"("children":[{"type":"sphere","center":[0,0,0],"radius":1}]}]})");
  };
  EXPECT_TRUE(glowing("4096"));
  EXPECT_FALSE(glowing("4097"));
}

// A luminous mesh of so many triangles, and a luminous ball.
World luminous_world(std::size_t triangles, bool ball) {
  Finish glow;
  glow.emission = {1, 1, 1};
  Mesh mesh;
  mesh.positions.values = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < triangles; ++i)
    mesh.indices.values.insert(mesh.indices.values.end(), {0, 1, 2});
  Scene scene;
  scene.objects = {test::object(mesh, glow)};
  if (ball) scene.objects.push_back(test::object(Sphere{{0, 0, 9}, 1}, glow));
  return compile(scene);
}
// How many areas path asks for light, and how many luminous objects it asks for none.
std::pair<std::size_t, std::size_t> asked(const World& world) {
  return {world.of_objects->areas.size(), world.of_objects->unasked.count};
}
TEST(LimitNumbers, PathAsks32768Areas) {
  EXPECT_EQ(asked(luminous_world(32'768, false)), std::pair(std::size_t{32'768}, std::size_t{0}));
  EXPECT_EQ(asked(luminous_world(32'768, true)), std::pair(std::size_t{32'768}, std::size_t{1}));
  EXPECT_EQ(asked(luminous_world(32'769, false)), std::pair(std::size_t{0}, std::size_t{1}));
  EXPECT_EQ(asked(luminous_world(32'769, true)), std::pair(std::size_t{1}, std::size_t{1}));
}

// Whether a scene's keys are too many to be tried, or merge with too much.
bool is_beyond(const Scene& scene) {
  try {
    check_keys(scene, {});
    return false;
  } catch (const InputError& error) {
    return error.faults().front().kind == FaultKind::limit;
  }
}

TEST(LimitNumbers, AScenesKeysHave100Patches) {
  Scene scene;
  for (int i = 0; i < 100; ++i)
    scene.keys[std::to_string(i)] = Value(Value::Object{{"title", "new"}});
  EXPECT_FALSE(is_beyond(scene));
  scene.keys["another"] = scene.keys["0"];
  EXPECT_TRUE(is_beyond(scene));
}

// A patch of materials merges with these, and leaves objects that wear them.
TEST(LimitNumbers, AScenesKeysMergeWith16777216Bytes) {
  const auto merging = [](std::size_t name) {
    Scene scene;
    scene.materials[std::string(name, 'n')] = {};
    scene.keys["a"] = Value(Value::Object{{"materials", Value::Object{}}});
    return scene;
  };
  const Scene least = merging(0);
  const std::size_t rest = to_json(Value::Object{{"materials", write_value(least.materials)},
                                                 {"objects", write_value(least.objects)}})
                               .size();
  EXPECT_FALSE(is_beyond(merging(16'777'216 - rest)));
  EXPECT_TRUE(is_beyond(merging(16'777'217 - rest)));
}

// ---- what only a huge input would meet ------------------------------------------------------

TEST(LimitNumbers, OfLargeScenes) {
  EXPECT_EQ(Mesh::most_triangles, 16'777'216U);
  EXPECT_EQ(most_cells, 16'777'216);
  EXPECT_EQ(most_cell_material, 255);
  EXPECT_EQ(most_algebraic_degree, 64);
  EXPECT_EQ(most_light_samples, 4096);
  EXPECT_EQ(most_hits, 10'000U);
}

}  // namespace
}  // namespace tia
