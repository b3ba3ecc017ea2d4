// Contract: a primitive's triangles are those of its indices, and strips, fans and lists of the
// same triangles are the same.
#include <gtest/gtest.h>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

// One with indices.
template <class T>
GltfBuilder indexed(std::size_t n, int component, const std::vector<T>& indices, int mode = 4) {
  GltfBuilder builder;
  const int positions = builder.vec3(row(n)),
            list = builder.numbers<T>(component, "SCALAR", 1, indices);
  builder.set("meshes", one_primitive(named("POSITION", positions),
                                      member("indices", std::to_string(list)) +
                                          member("mode", std::to_string(mode))));
  return builder;
}

TEST(GltfIndices, StripsAndFansAreLists) {
  const Indices strip{0, 1, 2, 1, 3, 2, 2, 3, 4}, fan{1, 2, 0, 2, 3, 0, 3, 4, 0};
  EXPECT_EQ(part_of(of_vertices(5, ",\"mode\":5")).indices, strip);
  EXPECT_EQ(part_of(of_vertices(5, ",\"mode\":6")).indices, fan);
  EXPECT_EQ(part_of(of_vertices(6)).indices, (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(part_of(indexed<std::uint8_t>(9, gltf_ubyte, {8, 6, 4, 2}, 5)).indices,
            (Indices{8, 6, 4, 6, 2, 4}));
  EXPECT_EQ(part_of(indexed<std::uint32_t>(9, gltf_uint, {8, 6, 4, 2}, 6)).indices,
            (Indices{6, 4, 8, 4, 2, 8}));
}

// Two strips, sewn together by triangles without area.
TEST(GltfIndices, WhatSewsStripsTogetherIsLeftOut) {
  EXPECT_EQ(
      part_of(indexed<std::uint16_t>(8, gltf_ushort, {0, 1, 2, 3, 3, 4, 4, 5, 6, 7}, 5)).indices,
      (Indices{0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6}));
  EXPECT_EQ(part_of(indexed<std::uint8_t>(5, gltf_ubyte, {0, 1, 2, 2, 3}, 6)).indices,
            (Indices{1, 2, 0, 2, 3, 0}));
}

// Every strip winds its triangles as the list in which each second one is turned over.
TEST(GltfIndices, RandomStripsEqualTheirLists) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    const int n = random.whole(3, 40);
    Indices strip, list;
    for (int i = 0; i < n; ++i) strip.push_back(static_cast<std::uint32_t>(random.below(10)));
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      const std::uint32_t a = strip[i], b = strip[i + 1], c = strip[i + 2];
      if (a == b || b == c || c == a) continue;
      const Indices triangle = i % 2 == 0 ? Indices{a, b, c} : Indices{a, c, b};
      list.insert(list.end(), triangle.begin(), triangle.end());
    }
    const Model model = model_of(indexed(10, gltf_uint, strip, 5));
    if (list.empty()) EXPECT_TRUE(model.meshes[0].parts.empty());
    else EXPECT_EQ(model.meshes[0].parts.at(0).indices, list);
  }
}

TEST(GltfIndices, ARestIsNoTriangle) {
  const ReadGltf read = read_built(of_vertices(5));
  expect_faults(read.faults, {});
  EXPECT_EQ(read.model.meshes[0].parts[0].indices, (Indices{0, 1, 2}));
  EXPECT_TRUE(read.warned(primitive));
  for (const std::string mode : {"1", "2", "3"}) {
    const ReadGltf lines = read_built(of_vertices(6, member("mode", mode)));
    expect_faults(lines.faults, {});
    EXPECT_TRUE(lines.model.meshes.at(0).parts.empty());
    EXPECT_TRUE(lines.warned(primitive));
  }
  expect_one_fault(read_built(of_vertices(6, ",\"mode\":7")), FaultKind::out_of_range,
                   primitive + "/mode");
}

TEST(GltfIndices, PointsAreTheirVertices) {
  const ModelPart part = part_of(of_vertices(5, ",\"mode\":0"));
  EXPECT_TRUE(part.points);
  EXPECT_EQ(part.vertices(), 5U);
  EXPECT_TRUE(part.indices.empty());
}

TEST(GltfIndices, IndicesAreVertices) {
  const std::string at = primitive + "/indices";
  const auto refused = [&](const GltfBuilder& builder, FaultKind kind) {
    expect_one_fault(read_built(builder), kind, at);
  };
  refused(indexed<std::uint8_t>(3, gltf_ubyte, {0, 1, 3}), FaultKind::out_of_range);
  refused(indexed<std::uint16_t>(3, gltf_ushort, {0, 1, 65535}), FaultKind::out_of_range);
  refused(indexed<std::uint32_t>(3, gltf_uint, {0, 1, 0xFFFF'FFFF}), FaultKind::out_of_range);
  // The restart value, even where so many vertices are there.
  refused(indexed<std::uint8_t>(300, gltf_ubyte, {0, 1, 255}), FaultKind::out_of_range);
  part_of(indexed<std::uint8_t>(300, gltf_ubyte, {0, 1, 254}));
  part_of(indexed<std::uint16_t>(300, gltf_ushort, {0, 1, 299}));
  refused(indexed<std::int16_t>(3, gltf_short, {0, 1, 2}), FaultKind::wrong_type);
  refused(indexed<float>(3, gltf_float, {0, 1, 2}), FaultKind::wrong_type);
  GltfBuilder strided;
  const int positions = strided.vec3(row(3)),
            list = strided.accessor(
                strided.view(bytes_of<std::uint32_t>({0, 0, 1, 0, 2}), ",\"byteStride\":8"),
                gltf_uint, "SCALAR", 3);
  strided.set("meshes",
              one_primitive(named("POSITION", positions), member("indices", std::to_string(list))));
  refused(strided, FaultKind::conflict);
  expect_one_fault(read_built(of_vertices(3, ",\"indices\":1")), FaultKind::out_of_range, at);
}

// As gltf-validator has it: found by tests/models.
TEST(GltfUses, AViewHoldsVerticesOrIndicesOrOtherThings) {
  const auto read = [](const std::string& indices, const std::string& views) {
    GltfBuilder builder;
    builder.view(bytes_of(row(3)), views);
    builder.accessor(0, gltf_float, "VEC3", 3);
    builder.accessor(0, gltf_uint, "SCALAR", 3);
    builder.view(bytes_of<std::uint32_t>({0, 1, 2}));
    builder.accessor(1, gltf_uint, "SCALAR", 3);
    builder.set("meshes", one_primitive(named("POSITION", 0), ",\"indices\":" + indices));
    return read_built(builder);
  };
  expect_faults(read("2", "").faults, {});
  expect_faults(read("2", ",\"target\":34962").faults, {});
  const std::string indices = primitive + "/indices", place = primitive + "/attributes/POSITION";
  expect_one_fault(read("1", ""), FaultKind::conflict, indices);
  expect_one_fault(read("2", ",\"target\":34963"), FaultKind::conflict, place);
}

TEST(GltfUses, SparseNumbersLieAloneAndCloseTogether) {
  const auto read = [](const std::string& more) {
    GltfBuilder builder;
    builder.view(bytes_of<std::uint32_t>({1}));
    builder.view(bytes_of(row(1)), more);
    builder.accessor(-1, gltf_float, "VEC3", 3,
                     R"(,"sparse":{"count":1,"indices":{"bufferView":0,"componentType":5125},)"
                     R"("values":{"bufferView":1}})");
    builder.set("meshes", one_primitive(named("POSITION", 0)));
    return read_built(builder);
  };
  expect_faults(read("").faults, {});
  const std::string values = "/accessors/0/sparse/values/bufferView";
  expect_one_fault(read(",\"byteStride\":12"), FaultKind::conflict, values);
  expect_one_fault(read(",\"target\":34962"), FaultKind::conflict, values);
}

}  // namespace
}  // namespace tia::test::gltf_files
