// Scenes with models: as text, what is wrong with them, what is shared, what answers call it.
#include "core/scene/resolve_models.h"

#include <gtest/gtest.h>

#include "core/accel/world/world.h"
#include "core/scene/keys.h"
#include "core/scene/labels.h"
#include "core/scene/model_pieces.h"
#include "tests/core/models/random_model.h"
#include "tests/core/scene/models.h"

namespace tia::test {
namespace {

const std::string every_field =
    R"({"objects":[{"animation":0,"culling":false,)"
    R"("fit":{"align":[0.5,0,0.5],"max":[1,2,1],"min":[-1,0,-1]},)"
    R"("hide":["Glass"],"id":"0123","materials":{"Body":{"color":[1,0,0]},"Feet":"red"},)"
    R"("point_radius":0.01,"scene":0,"smooth":30,)"
    R"("time":0.5,"type":"model","up":"-z","variant":"red"}]})";

TEST(ModelScene, IsReadAndWrittenWithoutTheModel) {
  const std::string text = R"({"materials":{"red":{"color":[1,0,0]}},)" + every_field.substr(1);
  EXPECT_EQ(canonical_text(read_scene(text)), text);
  EXPECT_EQ(canonical_text(read_scene(R"({"objects":[{"type":"model","id":"a","materials":{}}]})")),
            R"({"objects":[{"id":"a","type":"model"}]})");
}

TEST(ModelScene, IsTheSameSceneOnceItIsResolved) {
  const Scene before = read_scene(model_scene());
  const Scene after = resolved(before, triangle_model());
  EXPECT_EQ(before, after);
  EXPECT_EQ(canonical_text(before), canonical_text(after));
  EXPECT_EQ(before.objects.get()[0].shape, after.objects.get()[0].shape);
  EXPECT_FALSE(before == resolved(read_scene(model_scene(R"("up":"z")")), triangle_model()));
}

TEST(ModelScene, ShowsNothingUntilItIsResolved) {
  const Scene scene = read_scene(model_scene());
  EXPECT_EQ(models_in(scene), std::set<std::string>{"it"});
  EXPECT_TRUE(children_of(scene.objects[0])->empty());
  EXPECT_TRUE(bounds_of(scene.objects[0]).empty());
  EXPECT_EQ(compile(scene).objects, 0);
  EXPECT_TRUE(models_in(read_scene(R"({"objects":[{"type":"group","children":[
      {"type":"sphere","center":[0,0,0],"radius":1}]}]})"))
                  .empty());
}

TEST(ModelScene, WithoutModelsIsLeftAsItIs) {
  Scene scene = read_scene(R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1}]})");
  const Scene shares = scene;
  Faults faults;
  resolve_models(
      scene, [](const std::string&) { return nullptr; }, faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(&scene.objects.get(), &shares.objects.get());
}

TEST(ModelScene, ResolvesModelsInGroups) {
  const std::string model = R"({"type":"model","id":"it"})";
  const Scene scene =
      resolved(read_scene(R"({"objects":[{"type":"group","repeat":{"count":[3,1,1],"step":[10,0,0]},
      "transform":[{"translate":[0,0,5]}],"children":[)" +
                          model + "]}]}"),
               triangle_model());
  EXPECT_EQ(bounds_of(scene.objects[0]), (Aabb{{0, 0, 5}, {24, 2, 5}}));
  EXPECT_EQ(compile(scene).objects, 1);
}

// ---- faults -------------------------------------------------------------------------------------

TEST(ModelFaults, OfTheTextSayWhatIsAllowed) {
  expect_scene_refused(R"({"objects":[{"type":"model"}]})",
                       {{FaultKind::missing, "/objects/0/id", "", "a string"}});
  expect_scene_refused(
      model_scene(R"("fit":{"min":[0,0,0],"max":[1,0,1]})"),
      {{FaultKind::out_of_range, "/objects/0/fit/max", "[1,0,1]", "above min in every component"}});
  expect_scene_refused(model_scene(R"("up":"w")"),
                       {{FaultKind::unknown_name, "/objects/0/up", "\"w\"", "-z"}});
  expect_scene_refused(model_scene(R"("shiny":true)"),
                       {{FaultKind::unknown_name, "/objects/0/shiny", "\"shiny\"", ""}});
  expect_scene_refused(model_scene(R"("smooth":200)"),
                       {{FaultKind::out_of_range, "/objects/0/smooth", "200", "0 to 180"}});
  expect_scene_refused(
      model_scene(R"("materials":{"Body":"reed"})"),
      {{FaultKind::unknown_name, "/objects/0/materials/Body", "\"reed\"", "names none"}});
  expect_scene_refused(model_scene(R"("materials":["reed"])"),
                       {{FaultKind::conflict, "/objects/0/materials", "\"1 materials\"", "voxels"},
                        {FaultKind::unknown_name, "/objects/0/materials/0", "\"reed\"", ""}});
  expect_scene_refused(model_scene(R"("materials":7)"),
                       {{FaultKind::wrong_type, "/objects/0/materials", "7", "an array or an"}});
  expect_scene_refused(
      R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,"materials":{"a":{}}}]})",
      {{FaultKind::conflict, "/objects/0/materials", "\"1 materials by name\"", "a model"}});
}

TEST(ModelFaults, AModelIsNoOperand) {
  expect_scene_refused(
      R"({"objects":[{"type":"csg","operation":"union","children":[{"type":"model","id":"it"}]}]})",
      {{FaultKind::out_of_range, "/objects/0/children/0/type", "\"model\"", "in a csg a solid"}});
}

TEST(ModelFaults, UnknownModelsAreToldByTheirPlaces) {
  const std::string unknown = R"({"type":"model","id":"unknown"})";
  expect_faults(model_faults(triangle_model(),
                             R"({"objects":[)" + unknown +
                                 R"(,{"type":"group","children":[{"type":"model","id":"it"},)" +
                                 unknown + "]}]}"),
                {{FaultKind::missing, "/objects/0/id", "\"unknown\"", "kept here"},
                 {FaultKind::missing, "/objects/1/children/1/id", "\"unknown\"", "kept here"}});
}

TEST(ModelFaults, OfWhatTheModelLacksSayWhatItHas) {
  Model model = triangle_model();
  const auto expect = [&](const std::string& members, const std::vector<Expected>& expected) {
    expect_faults(model_faults(model, model_scene(members)), expected);
  };
  expect(R"("scene":1)", {{FaultKind::out_of_range, "/objects/0/scene", "1", "from 0 to 0"}});
  expect(R"("animation":0)",
         {{FaultKind::out_of_range, "/objects/0/animation", "0", "has no animations"}});
  expect(R"("time":2)", {{FaultKind::out_of_range, "/objects/0/time", "0", "has no animations"}});
  expect(R"("variant":"a")",
         {{FaultKind::unknown_name, "/objects/0/variant", "\"a\"", "names no variants"}});
  expect(R"("hide":["root","pant"])", {{FaultKind::unknown_name, "/objects/0/hide/1", "\"pant\"",
                                        "root, sheet, paint", "paint"}});
  expect(R"("materials":{"pain":{}})", {{FaultKind::unknown_name, "/objects/0/materials/pain",
                                         "\"pain\"", "materials, paint", "paint"}});
  model.variants = {"red", "blue"};
  expect(R"("variant":"a","scene":7)",
         {{FaultKind::out_of_range, "/objects/0/scene", "7", "from 0 to 0"},
          {FaultKind::unknown_name, "/objects/0/variant", "\"a\"", "variants, red, blue"}});
}

TEST(ModelFaults, OfPlacesThatObjectsCannotHave) {
  Model model = triangle_model();
  model.nodes[0].placement.scale = {1e-6, 1e-6, 1e-6};
  model.nodes[0].instances.resize(2);
  const std::string tiny = model_scene(R"("transform":[{"scale":1e-6}])");
  expect_faults(model_faults(model, tiny),
                {{FaultKind::out_of_range, "/objects/0", "", "1e-9 to 1e9 on every axis"}});
}

// A model that is named often is made once, and counts each time.
TEST(ModelFaults, OfMoreObjectsThanASceneMayShow) {
  Model model = triangle_model();
  model.nodes[0].instances.resize(5);
  const std::string one = R"({"type":"model","id":"it"})", two = one + "," + one;
  const auto of = [&](const std::string& objects) {
    return model_faults(model, R"({"objects":[)" + objects + "]}", {10, 1000});
  };
  expect_faults(of(two), {});
  expect_faults(of(two + "," + one),
                {{FaultKind::limit, "/objects/2", "", "at most 10 meshes and points"}});
  model.nodes[0].instances.resize(11);
  expect_faults(of(one), {{FaultKind::limit, "/objects/0", "", "at most 10 meshes and points"}});
}

// Points count each.
TEST(ModelFaults, OfMorePointsThanASceneMayShow) {
  Model model = triangle_model();
  model.meshes[0].parts[0].indices.clear();
  model.meshes[0].parts[0].points = true;
  expect_faults(model_faults(model, model_scene(), {3, 3}), {});
  expect_faults(model_faults(model, model_scene(), {2, 3}),
                {{FaultKind::limit, "/objects/0", "", "at most 2 meshes and points"}});
}

// Each node that moves a mesh's vertices one by one has lists of its own; so has each place that
// objects cannot have.
TEST(ModelFaults, OfMoreVerticesThanASceneMayShow) {
  Model model = triangle_model();
  model.nodes.push_back(model.nodes[0]);
  model.scenes[0].nodes.push_back(1);
  const auto of = [&](std::int64_t most) {
    return model_faults(model, model_scene(), {10, most}).size();
  };
  EXPECT_EQ(of(4), 0U);  // three vertices and a triangle, shared
  EXPECT_EQ(of(3), 1U);
  model.nodes[1].placement.scale.z = 0;
  EXPECT_EQ(of(8), 0U);
  EXPECT_EQ(of(7), 1U);
  model.meshes[0].parts[0].targets.resize(1);
  EXPECT_EQ(of(12), 0U);
  EXPECT_EQ(of(11), 1U);
  expect_faults(model_faults(model, model_scene(), {10, 7}),
                {{FaultKind::limit, "/objects/0", "", "and 7 vertices and triangles"}});
}

// ---- memory -------------------------------------------------------------------------------------

TEST(ModelMemory, OfNodesInstancesAndObjectsIsShared) {
  Model model = triangle_model();
  model.nodes.push_back(model.nodes[0]);
  model.nodes[1].instances.resize(3);
  for (std::size_t i = 0; i < 3; ++i) model.nodes[1].instances[i].translation.x = double(i);
  model.scenes[0].nodes.push_back(1);
  const std::string one = R"({"type":"model","id":"it"})";
  const Scene scene = resolved(read_scene(R"({"objects":[)" + one + "," + one + "]}"), model);
  const auto& shown = *children_of(scene.objects[0]);
  EXPECT_EQ(children_of(scene.objects[1]), &shown);
  ASSERT_EQ(shown.size(), 2U);
  const auto& instances = *children_of(shown[1]);
  ASSERT_EQ(instances.size(), 3U);
  for (const Object& each : instances) {
    EXPECT_EQ(lists_of(mesh_in(each)), lists_of(mesh_in(shown[0])));
    EXPECT_EQ(each.name, "root");
  }
  EXPECT_EQ(placed_vertices(instances[2])[0], (Vec3d{2, 0, 0}));
}

TEST(ModelMemory, MeshesThatShareTheirListsAreIndexedOnce) {
  Model model = triangle_model();
  model.nodes[0].instances.resize(5);
  const Scene scene = resolved(read_scene(model_scene()), model);
  int made = 0;
  const Geometry geometry = geometry_of(scene, {}, [&](const Mesh& mesh, const Workers& workers) {
    ++made;
    return indexed(mesh, workers);
  });
  EXPECT_EQ(made, 1);
  EXPECT_EQ(geometry.objects, 5);
}

// ---- answers ------------------------------------------------------------------------------------

TEST(ModelLabels, AreTheNodesNamesOrTheModelsPlace) {
  Model model = triangle_model();
  model.meshes[0].name.clear();
  model.nodes[0].name = std::string(300, 'n');
  model.nodes.emplace_back();
  model.nodes[1].mesh = 0;
  model.nodes[1].instances.resize(2);
  model.scenes[0].nodes.push_back(1);
  const Scene scene =
      resolved(read_scene(R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1},
      {"type":"model","id":"it"},{"type":"disc","name":"last","center":[0,0,0],"normal":[0,0,1],
      "radius":1}]})"),
               model);
  const std::vector<ObjectLabel> labels = object_labels(scene);
  ASSERT_EQ(labels.size(), 5U);
  ASSERT_EQ(compile(scene).objects, 5);
  EXPECT_EQ(labels[0].name, "/objects/0");
  EXPECT_EQ(labels[1].name, excerpt_of(model.nodes[0].name, longest_name));
  for (const std::size_t i : {2U, 3U}) EXPECT_EQ(labels[i].name, "/objects/1");
  EXPECT_EQ(labels[3].type, "mesh");
  EXPECT_EQ(labels[4].name, "last");
  EXPECT_EQ(object_pointers(scene, {1, 3, 4}),
            (std::map<int, std::string>{{1, "/objects/1"}, {3, "/objects/1"}, {4, "/objects/2"}}));
}

// A key's patch reads the scene again.
TEST(ModelScene, AKeyLeavesItToBeResolvedAgain) {
  const Scene scene = resolved(read_scene(R"({"objects":[{"type":"model","id":"it"}],
      "keys":{"u":{"objects":[{"type":"model","id":"it","up":"z"}]}}})"),
                               triangle_model());
  const Scene pressed = press(scene, "u");
  EXPECT_TRUE(children_of(pressed.objects[0])->empty());
  const Aabb box = bounds_of(resolved(pressed, triangle_model()).objects[0]);
  EXPECT_EQ(box, (Aabb{{0, 0, -2}, {4, 0, 0}}));
}

}  // namespace
}  // namespace tia::test
