// Contract: nodes are trees, of any shape that fits the limits, and each is placed as it says.
#include <gtest/gtest.h>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

GltfBuilder of_nodes(const std::string& nodes) {
  GltfBuilder builder = one_triangle();
  builder.members = replaced(builder.members, ",\"scenes\":[{\"nodes\":[0]}]", "");
  builder.members = replaced(builder.members, "[{\"mesh\":0}]", nodes);
  return builder;
}
ReadGltf read_nodes(const std::string& nodes, const ModelLimits& limits = {}) {
  return read_built(of_nodes(nodes), limits);
}
ModelNode node_of(const std::string& node) {
  const Model model = model_of(of_nodes("[" + node + "]"));
  return model.nodes.empty() ? ModelNode{} : model.nodes[0];
}

std::string list_text(const std::vector<ModelIndex>& numbers) {
  std::string text;
  for (const ModelIndex number : numbers)
    text += (text.empty() ? "" : ",") + std::to_string(number);
  return "[" + text + "]";
}
std::string nodes_text(const std::vector<std::vector<ModelIndex>>& children) {
  std::string text;
  for (const auto& list : children)
    text += (text.empty() ? "{" : ",{") +
            (list.empty() ? std::string() : "\"children\":" + list_text(list)) + "}";
  return "[" + text + "]";
}

/// Forest: random trees over shuffled numbers.
struct Forest {
  std::vector<std::vector<ModelIndex>> children;
  std::vector<ModelIndex> roots, order;  // each parent before its children
};
Forest random_forest(std::size_t size, Random& random) {
  Forest forest;
  forest.children.resize(size);
  for (std::size_t i = 0; i < size; ++i) forest.order.push_back(static_cast<ModelIndex>(i));
  for (std::size_t i = size; i > 1; --i)
    std::swap(forest.order[i - 1],
              forest.order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  for (std::size_t i = 0; i < size; ++i) {
    if (i == 0 || random.chance(0.2)) forest.roots.push_back(forest.order[i]);
    else
      forest.children[forest.order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]]
          .push_back(forest.order[i]);
  }
  std::sort(forest.roots.begin(), forest.roots.end());
  return forest;
}

TEST(GltfNodes, AnyForestIsTaken) {
  Random random(11);
  for (int round = 0; round < 40; ++round) {
    const Forest forest = random_forest(static_cast<std::size_t>(random.whole(1, 60)), random);
    const Model model = model_of(of_nodes(nodes_text(forest.children)));
    ASSERT_EQ(model.nodes.size(), forest.children.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
      EXPECT_EQ(model.nodes[i].children, forest.children[i]);
    ASSERT_EQ(model.scenes.size(), 1U);  // without scenes: of all roots
    EXPECT_EQ(model.scenes[0].nodes, forest.roots);
    EXPECT_EQ(model.scene, 0U);
  }
}

TEST(GltfNodes, ASecondParentOrACircleIsRefused) {
  Random random(12);
  for (int round = 0; round < 40; ++round) {
    const auto size = static_cast<std::size_t>(random.whole(2, 60));
    Forest forest = random_forest(size, random);
    // Another edge, to any node: a root's makes a circle or a deeper tree, another's a second
    // parent.
    const auto a = static_cast<ModelIndex>(random.below(static_cast<int>(size))),
               b = static_cast<ModelIndex>(random.below(static_cast<int>(size)));
    const bool to_root = std::binary_search(forest.roots.begin(), forest.roots.end(), b);
    std::vector<bool> below(size);
    below[b] = true;
    for (const ModelIndex node : forest.order)
      for (const ModelIndex child : forest.children[node])
        if (below[node]) below[child] = true;
    forest.children[a].push_back(b);
    const ReadGltf read = read_nodes(nodes_text(forest.children));
    EXPECT_EQ(read.faults.empty(), to_root && !below[a]) << nodes_text(forest.children);
    for (const Fault& fault : read.faults) EXPECT_EQ(fault.kind, FaultKind::conflict);
  }
}

TEST(GltfNodes, FaultsAreAtTheirPlaces) {
  const auto conflict = FaultKind::conflict, beyond = FaultKind::out_of_range;
  expect_one_fault(read_nodes(R"([{"children":[2]},{"children":[2]},{}])"), conflict,
                   "/nodes/1/children/0");
  expect_one_fault(read_nodes(R"([{"children":[0]}])"), conflict, "/nodes/0");
  expect_one_fault(read_nodes(R"([{"children":[1,1]},{}])"), conflict, "/nodes/0/children/1");
  expect_one_fault(read_nodes(R"([{"children":[1]}])"), beyond, "/nodes/0/children/0");
  expect_one_fault(read_nodes(R"([{"children":[-1]}])"), beyond, "/nodes/0/children/0");
  expect_one_fault(read_nodes(R"([{"children":[]}])"), beyond, "/nodes/0/children");
  expect_one_fault(read_nodes(R"([{},5])"), FaultKind::wrong_type, "/nodes/1");
  // Those of the circle, not what hangs there.
  const ReadGltf circle = read_nodes(
      R"([{},{"children":[2]},{"children":[3]},{"children":[1,4]},{"children":[5]},{}])");
  ASSERT_EQ(circle.faults.size(), 3U);
  EXPECT_EQ(circle.faults[0].pointer, "/nodes/1");
  EXPECT_EQ(circle.faults[1].pointer, "/nodes/2");
  EXPECT_EQ(circle.faults[2].pointer, "/nodes/3");
}

std::string nested(std::size_t n) {
  std::string text = "[";
  for (std::size_t i = 1; i < n; ++i) text += "{\"children\":[" + std::to_string(i) + "]},";
  return text + "{}]";
}

TEST(GltfNodes, DepthAndNumberHaveLimits) {
  expect_faults(read_nodes(nested(256)).faults, {});
  expect_one_fault(read_nodes(nested(257)), FaultKind::limit, "/nodes/256");
  ModelLimits limits;
  limits.nodes = 3;
  expect_faults(read_nodes(nested(3), limits).faults, {});
  expect_one_fault(read_nodes(nested(4), limits), FaultKind::limit, "/nodes");
}

TEST(GltfNodes, ManyInEachOtherCostLittle) {
  constexpr std::size_t count = 100'000;
  const std::string deep = nested(count), circle = replaced(deep, "{}]", "{\"children\":[0]}]");
  expect_one_fault(read_nodes(deep), FaultKind::limit, "/nodes");
  ModelLimits limits;
  limits.nodes = limits.depth = count;
  limits.depth = count - 1;
  expect_one_fault(read_nodes(deep, limits), FaultKind::limit, "/nodes/99999");
  const ReadGltf turned = read_nodes(circle, limits);
  ASSERT_EQ(turned.faults.size(), Faults::most);
  EXPECT_EQ(turned.faults[19].pointer, "/nodes/19");
}

TEST(GltfNodes, ArePlacedAsTheySay) {
  const ModelNode plain = node_of("{\"name\":\"a\"}");
  EXPECT_EQ(plain.name, "a");
  EXPECT_EQ(plain.placement, Placement{});
  EXPECT_FALSE(plain.matrix);
  const ModelNode placed =
      node_of(R"({"translation":[1,2,3],"rotation":[0,0.6,0,-0.8],"scale":[4,-5,6]})");
  EXPECT_EQ(placed.placement.translation, (Vec3d{1, 2, 3}));
  EXPECT_EQ(placed.placement.rotation, (std::array<double, 4>{0, 0.6, 0, -0.8}));
  EXPECT_EQ(placed.placement.scale, (Vec3d{4, -5, 6}));
  const ModelNode matrix = node_of(R"({"matrix":[1,2,3,0,4,5,6,0,7,8,10,0,11,12,13,1]})");
  EXPECT_EQ(matrix.matrix,
            (std::array<double, 16>{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 11, 12, 13, 1}));
}

TEST(GltfNodes, WhatPlacesNothingIsRefused) {
  const auto refused = [](const std::string& node, FaultKind kind, const std::string& member) {
    expect_one_fault(read_nodes("[" + node + "]"), kind, "/nodes/0/" + member);
  };
  const auto beyond = FaultKind::out_of_range, type = FaultKind::wrong_type;
  refused(R"({"rotation":[0,0,0,0]})", beyond, "rotation");
  refused(R"({"rotation":[0,0,1]})", type, "rotation");
  refused(R"({"translation":[0,0,1e10]})", beyond, "translation/2");
  refused(R"({"scale":[0,null,1]})", type, "scale/1");
  refused(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]})", type, "matrix");
  refused(R"({"matrix":[1,0,0,0.1,0,1,0,0,0,0,1,0,0,0,0,1]})", beyond, "matrix");
  refused(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]})", beyond, "matrix");
  refused(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]})", FaultKind::conflict,
          "matrix");
  for (const auto& [node, member] :
       {std::pair{R"({"rotation":[0,0,0,2]})", "rotation"},
        {R"({"scale":[1,0,1]})", "scale"},
        {R"({"matrix":[0,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})", "matrix"}}) {
    const ReadGltf read = read_nodes("[" + std::string(node) + "]");
    expect_faults(read.faults, {});
    EXPECT_TRUE(read.warned("/nodes/0/" + std::string(member)));
  }
}

TEST(GltfNodes, HoldWhatIsThere) {
  EXPECT_EQ(node_of("{\"mesh\":0}").mesh, MaybeIndex(0));
  const auto refused = [](const std::string& node, FaultKind kind, const std::string& member) {
    expect_one_fault(read_nodes("[" + node + "]"), kind, "/nodes/0/" + member);
  };
  const auto beyond = FaultKind::out_of_range, conflict = FaultKind::conflict;
  refused("{\"mesh\":1}", beyond, "mesh");
  refused("{\"camera\":0}", beyond, "camera");
  refused("{\"mesh\":0,\"skin\":0}", beyond, "skin");
  refused("{\"weights\":[1]}", conflict, "weights");
  refused("{\"mesh\":0,\"weights\":[1]}", conflict, "weights");
  const std::string light = R"({"extensions":{"KHR_lights_punctual":{"light":0}}})";
  refused(light, beyond, "extensions/KHR_lights_punctual/light");
  refused(R"({"extensions":{"KHR_lights_punctual":{}}})", FaultKind::missing,
          "extensions/KHR_lights_punctual/light");
  GltfBuilder lit = of_nodes("[" + light + ",{\"camera\":0}]");
  lit.set("extensionsUsed", "[\"KHR_lights_punctual\"]");
  lit.set("extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"point"}]}})");
  lit.set("cameras",
          R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1,"aspectRatio":1}}])");
  EXPECT_EQ(model_of(lit).nodes[0].light, MaybeIndex(0));
  EXPECT_EQ(model_of(lit).nodes[1].camera, MaybeIndex(0));
}

// As gltf-validator has it: found by tests/models.
TEST(GltfNodes, WhatStandsBesideAMatrixIsLookedAtToo) {
  const ReadGltf read =
      read_nodes(R"([{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"translation":[1,2]}])");
  ASSERT_EQ(read.faults.size(), 2U);
  EXPECT_EQ(read.faults[0].pointer, "/nodes/0/translation");
  EXPECT_EQ(read.faults[1].pointer, "/nodes/0/matrix");
}

TEST(GltfNodes, ScenesHaveRoots) {
  const auto with = [](const std::string& scenes) {
    GltfBuilder builder = of_nodes(R"([{"children":[1]},{},{}])");
    builder.members += scenes;
    return read_built(builder);
  };
  const ReadGltf read = with(R"(,"scenes":[{"nodes":[0],"name":"a"},{"nodes":[2,0]},{}])");
  expect_faults(read.faults, {});
  ASSERT_EQ(read.model.scenes.size(), 3U);
  EXPECT_EQ(read.model.scene, 0U);
  EXPECT_EQ(read.model.scenes[0].name, "a");
  EXPECT_EQ(read.model.scenes[1].nodes, (std::vector<ModelIndex>{2, 0}));
  EXPECT_TRUE(read.model.scenes[2].nodes.empty());
  EXPECT_EQ(with(R"(,"scene":1,"scenes":[{},{"nodes":[2]}])").model.scene, 1U);
  const auto refused = [&](const std::string& scenes, FaultKind kind, const std::string& at) {
    expect_one_fault(with("," + scenes), kind, at);
  };
  refused(R"("scenes":[{"nodes":[0,1]}])", FaultKind::conflict, "/scenes/0/nodes/1");
  refused(R"("scenes":[{"nodes":[0,0]}])", FaultKind::conflict, "/scenes/0/nodes/1");
  refused(R"("scenes":[{"nodes":[3]}])", FaultKind::out_of_range, "/scenes/0/nodes/0");
  refused(R"("scene":1,"scenes":[{}])", FaultKind::out_of_range, "/scene");
  refused(R"("scene":0)", FaultKind::out_of_range, "/scene");
}

// Two instances: a half turn about z and one that is as long as it likes.
ReadGltf read_instanced(const std::string& attributes, const ModelLimits& limits = {}) {
  GltfBuilder builder =
      of_nodes(R"([{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" +
               attributes + "}}}}]");
  builder.set("extensionsRequired", "[\"EXT_mesh_gpu_instancing\"]");
  builder.set("extensionsUsed", "[\"EXT_mesh_gpu_instancing\"]");
  builder.vec3({1, 2, 3, 4, 5, 6});
  builder.numbers<std::int8_t>(gltf_byte, "VEC4", 4, {0, 0, 127, 0, 0, 127, 0, 127},
                               ",\"normalized\":true");
  builder.vec3({1, 1, 1, 2, 3, 4});
  builder.vec3({1, 2, 3});
  builder.floats("VEC4", 4, {0, 0, 0, 1, 0, 0, 0, 0});
  return read_built(builder, limits);
}

TEST(GltfNodes, InstancesStandWhereTheirListsSay) {
  const ReadGltf read = read_instanced(R"("TRANSLATION":2,"ROTATION":3,"SCALE":4)");
  expect_faults(read.faults, {});
  EXPECT_EQ(read.model.nodes[0].instances,
            (std::vector<Placement>{{{1, 2, 3}, {0, 0, 1, 0}, {1, 1, 1}},
                                    {{4, 5, 6}, {0, 1, 0, 1}, {2, 3, 4}}}));
  const ReadGltf moved = read_instanced(R"("TRANSLATION":2)");
  expect_faults(moved.faults, {});
  EXPECT_EQ(moved.model.nodes[0].instances,
            (std::vector<Placement>{{{1, 2, 3}, {0, 0, 0, 1}, {1, 1, 1}},
                                    {{4, 5, 6}, {0, 0, 0, 1}, {1, 1, 1}}}));
  const std::string at = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes";
  expect_one_fault(read_instanced(R"("TRANSLATION":2,"SCALE":5)"), FaultKind::conflict,
                   at + "/SCALE");
  expect_one_fault(read_instanced(R"("ROTATION":2)"), FaultKind::wrong_type, at + "/ROTATION");
  expect_one_fault(read_instanced(R"("ROTATION":6)"), FaultKind::out_of_range, at + "/ROTATION");
  expect_one_fault(read_instanced(R"("TRANSLATION":99)"), FaultKind::out_of_range,
                   at + "/TRANSLATION");
  ModelLimits limits;
  limits.instances = 1;
  expect_one_fault(read_instanced(R"("TRANSLATION":2)", limits), FaultKind::limit, at);
}

}  // namespace
}  // namespace tia::test::gltf_files
