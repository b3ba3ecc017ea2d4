// Contract: what a primitive's attributes, morph targets and materials say is what its part has.
#include <gtest/gtest.h>

#include <limits>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

// One with another attribute, of whatever accessor `add` makes.
template <class Add>
GltfBuilder with_attribute(std::size_t n, std::string_view name, Add add,
                           const std::string& more = "") {
  GltfBuilder builder;
  const int positions = builder.vec3(row(n)), other = add(builder);
  builder.set("meshes",
              one_primitive(named("POSITION", positions) + "," + named(name, other), more));
  return builder;
}
TEST(GltfMeshes, AttributesAreTakenAsTheyAre) {
  const ModelPart normals = part_of(with_attribute(3, "NORMAL", [](GltfBuilder& b) {
    return b.vec3({0, 0, 1, 0, 0, 2, 0.5, 0, 0});
  }));
  EXPECT_EQ(normals.normals, (std::vector<float>{0, 0, 1, 0, 0, 2, 0.5, 0, 0}));
  const ModelPart uvs = part_of(with_attribute(3, "TEXCOORD_0", [](GltfBuilder& b) {
    return b.numbers<std::uint16_t>(gltf_ushort, "VEC2", 2, {0, 65535, 13107, 0, 1, 2},
                                    ",\"normalized\":true");
  }));
  EXPECT_EQ(uvs.uvs[0], (std::vector<double>{0, 1, 0.2, 0, 1 / 65535.0, 2 / 65535.0}));
  EXPECT_TRUE(uvs.uvs[1].empty());
  const ModelPart second = part_of(with_attribute(3, "TEXCOORD_1", [](GltfBuilder& b) {
    return b.floats("VEC2", 2, {0, -1, 2, 3, 4, 5});
  }));
  EXPECT_EQ(second.uvs[1], (std::vector<double>{0, -1, 2, 3, 4, 5}));
}

TEST(GltfMeshes, ColoursHaveFourNumbersWithinNoughtAndOne) {
  const ModelPart three = part_of(with_attribute(3, "COLOR_0", [](GltfBuilder& b) {
    return b.vec3({0, 0.5, 1, 2, -1, 0.25, 0, 0, 0});
  }));
  EXPECT_EQ(three.colors, (std::vector<float>{0, 0.5, 1, 1, 1, 0, 0.25, 1, 0, 0, 0, 1}));
  const ModelPart four = part_of(with_attribute(3, "COLOR_0", [](GltfBuilder& b) {
    return b.numbers<std::uint8_t>(gltf_ubyte, "VEC4", 4,
                                   {0, 255, 51, 255, 0, 0, 0, 0, 255, 255, 255, 102},
                                   ",\"normalized\":true");
  }));
  EXPECT_EQ(four.colors, (std::vector<float>{0, 1, 0.2F, 1, 0, 0, 0, 0, 1, 1, 1, 0.4F}));
}

TEST(GltfMeshes, NormalsWithoutALengthAreNone) {
  GltfBuilder builder;
  const int positions = builder.vec3(row(3)), normals = builder.vec3({0, 0, 1, 0, 0, 0, 0, 0, 1}),
            tangents = builder.floats("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1}),
            moved = builder.vec3(row(3));
  const std::string all = named("POSITION", positions) + "," + named("NORMAL", normals) + "," +
                          named("TANGENT", tangents);
  builder.set("meshes", one_primitive(all, ",\"targets\":[{" + named("POSITION", moved) + "," +
                                               named("NORMAL", moved) + "," +
                                               named("TANGENT", moved) + "}]"));
  const ReadGltf read = read_built(builder);
  expect_faults(read.faults, {});
  const ModelPart& part = read.model.meshes[0].parts.at(0);
  EXPECT_TRUE(part.normals.empty() && part.tangents.empty());
  EXPECT_TRUE(part.targets.at(0).normals.empty() && part.targets[0].tangents.empty());
  EXPECT_EQ(part.targets[0].positions, row(3));
  EXPECT_TRUE(read.warned(primitive + "/attributes/NORMAL"));
  EXPECT_TRUE(read.warned(primitive + "/attributes/TANGENT"));
}

TEST(GltfMeshes, TangentsHaveASide) {
  const auto with = [](float w) {
    GltfBuilder builder;
    const int positions = builder.vec3(row(3)), normals = builder.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1}),
              tangents = builder.floats("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, w, 1, 0, 0, 1});
    builder.set("meshes",
                one_primitive(named("POSITION", positions) + "," + named("NORMAL", normals) + "," +
                              named("TANGENT", tangents)));
    return read_built(builder);
  };
  EXPECT_EQ(with(-1).model.meshes[0].parts[0].tangents,
            (std::vector<float>{1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1}));
  expect_faults(with(0).faults, {});
  EXPECT_TRUE(with(0).model.meshes[0].parts[0].tangents.empty());
  EXPECT_TRUE(with(0).warned(primitive + "/attributes/TANGENT"));
}

TEST(GltfMeshes, EightJointsStandTogether) {
  const auto skinned = [](bool second) {
    GltfBuilder builder;
    const int positions = builder.vec3(row(1)),
              joints = builder.numbers<std::uint8_t>(gltf_ubyte, "VEC4", 4, {1, 2, 3, 4}),
              weights = builder.floats("VEC4", 4, {0.1F, 0.2F, 0.3F, 0.4F}),
              more = builder.numbers<std::uint16_t>(gltf_ushort, "VEC4", 4, {5, 6, 7, 500}),
              rest = builder.numbers<std::uint8_t>(gltf_ubyte, "VEC4", 4, {255, 0, 51, 0},
                                                   ",\"normalized\":true");
    std::string all = named("POSITION", positions) + "," + named("JOINTS_0", joints) + "," +
                      named("WEIGHTS_0", weights);
    if (second) all += "," + named("JOINTS_1", more) + "," + named("WEIGHTS_1", rest);
    builder.set("meshes", one_primitive(all, ",\"mode\":0"));
    return builder;
  };
  const ModelPart four = part_of(skinned(false)), eight = part_of(skinned(true));
  EXPECT_EQ(four.joints, (Indices{1, 2, 3, 4}));
  EXPECT_EQ(four.weights, (std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F}));
  EXPECT_EQ(eight.joints, (Indices{1, 2, 3, 4, 5, 6, 7, 500}));
  EXPECT_EQ(eight.weights, (std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F, 1, 0, 0.2F, 0}));
  for (const auto& [second, name] :
       {std::pair{false, "JOINTS_0"}, {false, "WEIGHTS_0"}, {true, "JOINTS_1"}}) {
    GltfBuilder builder = skinned(second);
    builder.members = replaced(builder.members, name, "_X");
    expect_one_fault(read_built(builder), FaultKind::conflict, primitive + "/attributes");
  }
}

TEST(GltfMeshes, AttributesOfOtherKindsAreRefused) {
  const auto refused = [](std::string_view name, FaultKind kind, auto add) {
    expect_one_fault(read_built(with_attribute(3, name, add)), kind,
                     primitive + "/attributes/" + std::string(name));
  };
  const auto type = FaultKind::wrong_type;
  const auto three = [](GltfBuilder& b) { return b.vec3(row(3)); };
  const auto four = [](GltfBuilder& b) { return b.floats("VEC4", 4, std::vector<float>(12)); };
  refused("NORMAL", type, four);
  refused("TANGENT", type, three);
  refused("TEXCOORD_0", type, three);
  refused("COLOR_0", type,
          [](GltfBuilder& b) { return b.floats("VEC2", 2, std::vector<float>(6)); });
}

TEST(GltfMeshes, AllAttributesHaveAsManyElements) {
  for (const std::string name : {"NORMAL", "_MINE", "TEXCOORD_7"}) {
    const GltfBuilder builder = with_attribute(3, name, [](GltfBuilder& b) {
      return b.vec3({0, 0, 1, 0, 0, 1});
    });
    expect_one_fault(read_built(builder), FaultKind::conflict, primitive + "/attributes/" + name);
  }
  const GltfBuilder more = with_attribute(
      3, "TEXCOORD_7", [](GltfBuilder& b) { return b.floats("VEC2", 2, std::vector<float>(6)); });
  expect_faults(read_built(more).faults, {});
  EXPECT_TRUE(read_built(more).warned(primitive + "/attributes/TEXCOORD_7"));
}

TEST(GltfMeshes, AttributesLieAtFours) {
  const GltfBuilder builder = with_attribute(3, "COLOR_0", [](GltfBuilder& b) {
    return b.numbers<std::uint8_t>(gltf_ubyte, "VEC3", 3, Bytes(9), ",\"normalized\":true");
  });
  expect_one_fault(read_built(builder), FaultKind::out_of_range, primitive + "/attributes/COLOR_0");
}

TEST(GltfMeshes, PositionsAreFiniteAndNotTooFar) {
  for (const float wrong : {1.1e9F, -2e9F, std::numeric_limits<float>::quiet_NaN()}) {
    GltfBuilder builder;
    builder.set("meshes",
                one_primitive(named("POSITION", builder.vec3({0, 0, 0, 1, 0, wrong, 0, 1, 0}))));
    expect_one_fault(read_built(builder), FaultKind::out_of_range, "/accessors/0");
  }
}

TEST(GltfMeshes, QuantizedOnlyWhereItIsSaid) {
  const auto quantized = [](const std::string& used) {
    GltfBuilder builder;
    const Bytes bytes = bytes_of<std::int16_t>({0, 0, 0, 0, 32767, -32768, 1, 0, 5, 6, 7, 0});
    const int positions =
        builder.accessor(builder.view(bytes, ",\"byteStride\":8"), gltf_short, "VEC3", 3);
    const int normals = builder.accessor(
        builder.view({0, 0, 127, 0, 0, 129, 0, 0, 128, 0, 0, 0}, ",\"byteStride\":4"), gltf_byte,
        "VEC3", 3, ",\"normalized\":true");
    builder.set("meshes",
                one_primitive(named("POSITION", positions) + "," + named("NORMAL", normals)));
    if (!used.empty()) builder.set("extensionsUsed", used);
    return builder;
  };
  const ModelPart part = part_of(quantized("[\"KHR_mesh_quantization\"]"));
  EXPECT_EQ(part.positions, (std::vector<double>{0, 0, 0, 32767, -32768, 1, 5, 6, 7}));
  EXPECT_EQ(part.normals, (std::vector<float>{0, 0, 1, 0, -1, 0, -1, 0, 0}));
  expect_faults(read_built(quantized("")).faults,
                {{FaultKind::wrong_type, primitive + "/attributes/POSITION",
                  "\"accessor 0: VEC3 of SHORT\"", "VEC3 of FLOAT"},
                 {FaultKind::wrong_type, primitive + "/attributes/NORMAL",
                  "\"accessor 1: VEC3 of BYTE normalized\"", "VEC3 of FLOAT"}});
}

TEST(GltfMeshes, MorphTargetsFitTheirMesh) {
  const auto morphed = [](const std::string& targets, const std::string& weights) {
    GltfBuilder builder;
    const int positions = builder.vec3(row(3));
    builder.vec3({1, 2, 3, 4, 5, 6, 7, 8, 9});
    builder.vec3({1, 2, 3});
    builder.set("meshes", "[{\"primitives\":[{\"attributes\":{" + named("POSITION", positions) +
                              "},\"targets\":" + targets + "}]" + weights + "}]");
    return read_built(builder);
  };
  const std::string two = R"([{"POSITION":1},{}])";
  const ReadGltf read = morphed(two, ",\"weights\":[0.25,-2]");
  expect_faults(read.faults, {});
  EXPECT_EQ(read.model.meshes[0].weights, (std::vector<double>{0.25, -2}));
  const ModelPart& part = read.model.meshes[0].parts.at(0);
  ASSERT_EQ(part.targets.size(), 2U);
  EXPECT_EQ(part.targets[0].positions, (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_TRUE(part.targets[1].positions.empty());
  EXPECT_EQ(morphed(two, "").model.meshes[0].weights, (std::vector<double>{0, 0}));
  expect_one_fault(morphed(two, ",\"weights\":[1]"), FaultKind::conflict, "/meshes/0/weights");
  expect_one_fault(morphed(R"([{"POSITION":2}])", ""), FaultKind::conflict,
                   primitive + "/targets/0/POSITION");
  expect_one_fault(morphed(R"([{"NORMAL":1}])", ""), FaultKind::conflict,
                   primitive + "/targets/0/NORMAL");
  expect_one_fault(morphed("[]", ""), FaultKind::out_of_range, primitive + "/targets");
}

TEST(GltfMeshes, AllPartsHaveAsManyTargets) {
  GltfBuilder builder;
  const std::string attributes =
      "{\"attributes\":{" + named("POSITION", builder.vec3(row(3))) + "}";
  builder.set("meshes", "[{\"primitives\":[" + attributes + "}," + attributes +
                            ",\"targets\":[{\"POSITION\":0}]}]}]");
  expect_one_fault(read_built(builder), FaultKind::conflict, "/meshes/0/primitives/1/targets");
}

TEST(GltfMeshes, WithoutAMaterialOneIsAddedOnce) {
  GltfBuilder builder;
  const std::string attributes =
      "{\"attributes\":{" + named("POSITION", builder.vec3(row(3))) + "}";
  builder.set("materials", "[{},{}]");
  builder.set("meshes", "[{\"primitives\":[" + attributes + "}," + attributes +
                            ",\"material\":1}," + attributes + "}]}]");
  const Model model = model_of(builder);
  ASSERT_EQ(model.materials.size(), 3U);
  const std::vector<ModelPart>& parts = model.meshes[0].parts;
  EXPECT_EQ(parts[0].material, MaybeIndex(2));
  EXPECT_EQ(parts[1].material, MaybeIndex(1));
  EXPECT_EQ(parts[2].material, MaybeIndex(2));
  EXPECT_EQ(model.materials[2].base_color, (Color{1, 1, 1}));
  EXPECT_EQ(model.materials[2].metallic, 1);
  EXPECT_EQ(model.materials[2].roughness, 1);
  EXPECT_FALSE(model.materials[2].double_sided);
  expect_one_fault(read_built(of_vertices(3, ",\"material\":0")), FaultKind::out_of_range,
                   primitive + "/material");
}

TEST(GltfMeshes, VariantsWearTheirMaterials) {
  const auto with = [](const std::string& mappings) {
    GltfBuilder builder = of_vertices(
        3, ",\"extensions\":{\"KHR_materials_variants\":{\"mappings\":" + mappings + "}}");
    builder.set("materials", "[{},{}]");
    builder.set("extensionsUsed", "[\"KHR_materials_variants\"]");
    builder.set("extensions", R"({"KHR_materials_variants":{"variants":)"
                              R"([{"name":"a"},{"name":"b"},{"name":"c"}]}})");
    return read_built(builder);
  };
  const ReadGltf read = with(R"([{"material":1,"variants":[2,0]},{"material":0,"variants":[1]}])");
  expect_faults(read.faults, {});
  EXPECT_EQ(read.model.meshes[0].parts.at(0).variants,
            (std::vector<VariantMaterial>{{2, 1}, {0, 1}, {1, 0}}));
  const std::string at = primitive + "/extensions/KHR_materials_variants/mappings";
  expect_one_fault(with(R"([{"material":1,"variants":[3]}])"), FaultKind::out_of_range,
                   at + "/0/variants/0");
  expect_one_fault(with(R"([{"material":2,"variants":[0]}])"), FaultKind::out_of_range,
                   at + "/0/material");
  expect_one_fault(with(R"([{"material":1,"variants":[0]},{"material":0,"variants":[0]}])"),
                   FaultKind::conflict, at);
}

TEST(GltfMeshes, TheirSumsHaveLimits) {
  GltfBuilder builder;
  const std::string attributes =
      "{\"attributes\":{" + named("POSITION", builder.vec3(row(6))) + "}}";
  builder.set("meshes",
              "[{\"primitives\":[" + attributes + "]},{\"primitives\":[" + attributes + "]}]");
  ModelLimits limits;
  limits.triangles = 4;
  limits.vertices = 12;
  expect_faults(read_built(builder, limits).faults, {});
  limits.triangles = 3;
  expect_one_fault(read_built(builder, limits), FaultKind::limit, "/meshes/1/primitives/0");
  limits.triangles = 4;
  limits.vertices = 11;
  expect_one_fault(read_built(builder, limits), FaultKind::limit, "/meshes/1/primitives/0");
}

// A few bytes that ask for much: targets that share an accessor of zeros.
TEST(GltfMeshes, WhatCostsNoBytesHasALimit) {
  GltfBuilder builder;
  builder.accessor(-1, gltf_float, "VEC3", 20'000'000);
  std::string targets = "{\"POSITION\":0}";
  for (int i = 0; i < 1000; ++i) targets += ",{\"POSITION\":0}";
  builder.set("meshes", one_primitive("\"POSITION\":0", ",\"targets\":[" + targets + "]"));
  expect_one_fault(read_built(builder), FaultKind::limit, primitive);
}

}  // namespace
}  // namespace tia::test::gltf_files
