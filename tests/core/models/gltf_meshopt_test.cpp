// Contract: what meshoptimizer has packed is what stood there unpacked, exactly; filters are the
// specification's formulas; what is packed otherwise than the document says is a fault at its
// place. The packer is libmeshoptimizer's encoder.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>

#include "core/models/meshopt.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

Bytes packed_attributes(const void* from, std::size_t count, std::size_t stride) {
  Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), from, count, stride));
  return bytes;
}
Bytes packed_triangles(const Indices& indices) {
  Bytes bytes(meshopt_encodeIndexBufferBound(indices.size(), 1000));
  bytes.resize(
      meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}
Bytes packed_indices(const Indices& indices) {
  Bytes bytes(meshopt_encodeIndexSequenceBound(indices.size(), 1000));
  bytes.resize(
      meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}

/// What the extension says of a view.
struct Said {
  std::size_t stride = 12, count = 0;
  const char* mode = "ATTRIBUTES";
  std::string more{};
};

/// PackedFile: a document whose second buffer is the fallback of packed views: the views of the
/// bytes are GltfBuilder's, and those of the numbers are written here.
struct PackedFile {
  GltfBuilder builder;
  std::string views{}, accessors{},
      fallback =
          ",\"extensions\":{\"EXT_meshopt_compression\":{"
          "\"fallback\":true}}";
  std::size_t length = 0;
  int count = 0;

  // Returns: the accessor's number.
  int add(const Bytes& packed, const Said& said, int component, const char* type) {
    while (builder.bin.size() % 4 != 0) builder.bin.push_back(0);
    const auto text = [](std::size_t number) { return std::to_string(number); };
    const std::string comma = count > 0 ? "," : "";
    const std::size_t size = said.stride * said.count;
    views +=
        comma + "{\"buffer\":1,\"byteOffset\":" + text(length) + ",\"byteLength\":" + text(size) +
        ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0" +
        ",\"byteOffset\":" + text(builder.bin.size()) + ",\"byteLength\":" + text(packed.size()) +
        ",\"byteStride\":" + text(said.stride) + ",\"count\":" + text(said.count) + ",\"mode\":\"" +
        said.mode + "\"" + said.more + "}}}";
    accessors += comma + "{\"bufferView\":" + std::to_string(count) +
                 ",\"componentType\":" + std::to_string(component) + ",\"type\":\"" + type +
                 "\",\"count\":" + text(said.count) + "}";
    append(builder.bin, packed);
    length += (size + 3) / 4 * 4;
    return count++;
  }
  std::string json() const {
    return "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"EXT_meshopt_compression\"],"
           "\"extensionsRequired\":[\"EXT_meshopt_compression\"]" +
           builder.members + ",\"buffers\":[{\"byteLength\":" + std::to_string(builder.bin.size()) +
           "},{\"byteLength\":" + std::to_string(length) + fallback + "}],\"bufferViews\":[" +
           views + "],\"accessors\":[" + accessors + "]}";
  }
  ReadGltf read(const std::string& text) const {
    return read_glb(
        glb_of({glb_chunk("JSON", to_bytes(text)), glb_chunk({"BIN\0", 4}, builder.bin, '\0')}));
  }
};

std::vector<float> random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> points;
  for (std::size_t i = 0; i < count * 3; ++i)
    points.push_back(static_cast<float>(random.in(-9, 9)));
  return points;
}
Indices random_triangles(std::size_t vertices, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Indices all;
  for (std::size_t i = 0; i < count * 3; ++i)
    all.push_back(static_cast<std::uint32_t>(random.below(static_cast<int>(vertices))));
  return all;
}

PackedFile packed_mesh(const std::vector<float>& points, const Bytes& indices, const Said& said) {
  PackedFile file;
  file.add(packed_attributes(points.data(), points.size() / 3, 12), {.count = points.size() / 3},
           gltf_float, "VEC3");
  file.add(indices, said, said.stride == 2 ? gltf_ushort : gltf_uint, "SCALAR");
  file.builder.set("meshes", one_primitive("\"POSITION\":0", ",\"indices\":1"));
  return file;
}

// The triangles' codec may turn each one; it names its corners in the same order around.
Indices turned(Indices triangles) {
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const auto first = triangles.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(first, std::min_element(first, first + 3), first + 3);
  }
  return triangles;
}

TEST(GltfMeshopt, AllModesGiveWhatWasPacked) {
  const std::vector<float> points = random_points(400, 1);
  const Indices triangles = random_triangles(400, 300, 2);
  for (const std::size_t stride : {std::size_t{2}, std::size_t{4}})
    for (const bool sequence : {false, true}) {
      const Bytes packed = sequence ? packed_indices(triangles) : packed_triangles(triangles);
      const Said said{stride, triangles.size(), sequence ? "INDICES" : "TRIANGLES"};
      const PackedFile file = packed_mesh(points, packed, said);
      const ReadGltf read = file.read(file.json());
      expect_faults(read.faults, {});
      const ModelPart& part = read.model.meshes.at(0).parts.at(0);
      EXPECT_EQ(part.positions, std::vector<double>(points.begin(), points.end()));
      EXPECT_EQ(sequence ? part.indices : turned(part.indices),
                sequence ? triangles : turned(triangles));
    }
}

TEST(GltfMeshopt, AFilterIsAppliedToTheView) {
  std::vector<float> points = random_points(100, 6);
  std::vector<std::uint32_t> packed(points.size());
  meshopt_encodeFilterExp(packed.data(), 100, 12, 15, points.data());
  PackedFile file;
  file.add(packed_attributes(packed.data(), 100, 12),
           {.count = 100, .more = ",\"filter\":\"EXPONENTIAL\""}, gltf_float, "VEC3");
  file.builder.set("meshes", one_primitive("\"POSITION\":0"));
  const ReadGltf read = file.read(file.json());
  expect_faults(read.faults, {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = read.model.meshes.at(0).parts.at(0).positions.at(i);
    ASSERT_NEAR(x, double{points[i]},
                9 * std::pow(2, -13));  // a mantissa of 15 bits, with its sign
  }
}

// ---- faults -------------------------------------------------------------------------------------

TEST(GltfMeshopt, WhatDoesNotFitIsAFaultAtItsPlace) {
  const Indices triangles = random_triangles(40, 30, 7);
  const PackedFile file = packed_mesh(random_points(40, 8), packed_triangles(triangles),
                                      {4, triangles.size(), "TRIANGLES"});
  const std::string first = "/bufferViews/0/extensions/EXT_meshopt_compression",
                    second = "/bufferViews/1/extensions/EXT_meshopt_compression";
  const auto with = [&](std::string_view from, std::string_view to) {
    return file.read(replaced(file.json(), from, to));
  };
  using enum FaultKind;
  const std::string points = "\"byteStride\":12,\"count\":40,\"mode\":\"ATTRIBUTES\"",
                    indices = "\"byteStride\":4,\"count\":90,\"mode\":\"TRIANGLES\"";
  expect_one_fault(with("\"mode\":\"ATTRIBUTES\"", "\"mode\":\"POINTS\""), unknown_name,
                   first + "/mode");
  expect_one_fault(with(points, points + ",\"filter\":\"OCTAHEDRAL\""), conflict,
                   first + "/byteStride");
  expect_one_fault(with(points, points + ",\"filter\":\"QUATERNION\""), conflict,
                   first + "/byteStride");
  expect_one_fault(with("\"byteStride\":12,\"count\":40", "\"byteStride\":6,\"count\":80"),
                   conflict, first + "/byteStride");
  expect_one_fault(with("\"count\":40", "\"count\":41"), conflict, first + "/count");
  expect_one_fault(with("\"count\":40,", ""), missing, first + "/count");
  expect_one_fault(with(indices, indices + ",\"filter\":\"EXPONENTIAL\""), conflict,
                   second + "/filter");
  expect_one_fault(with("\"byteStride\":4,\"count\":90", "\"byteStride\":8,\"count\":45"), conflict,
                   second + "/byteStride");
  EXPECT_EQ(with("\"byteLength\":360", "\"byteLength\":356").faults.at(0).pointer,
            second + "/count");
  expect_one_fault(with("{\"buffer\":0", "{\"buffer\":1"), conflict, first + "/buffer");
  expect_one_fault(with("{\"buffer\":0", "{\"buffer\":2"), out_of_range, first + "/buffer");
  expect_one_fault(with("\"TRIANGLES\"", "\"INDICES\""), malformed, second);
  EXPECT_EQ(with("EXT_meshopt_compression\":{\"buffer\"", "EXT_other\":{\"buffer\"").faults.size(),
            1U);
  EXPECT_EQ(
      with("EXT_meshopt_compression\":{\"buffer\"", "EXT_other\":{\"buffer\"").faults.at(0).pointer,
      "/bufferViews/0/buffer");
}

TEST(GltfMeshopt, ViewsUnpackAHundredfoldAtMostAndAllBytesOnce) {
  const std::vector<float> zeros(3 * 9000);
  const auto file_of = [&](std::size_t count, int times) {
    PackedFile file;
    for (int i = 0; i < times; ++i)
      file.add(packed_attributes(zeros.data(), 9000, 12), {.count = count}, gltf_float, "VEC3");
    file.builder.set("meshes", one_primitive("\"POSITION\":0"));
    return file;
  };
  const PackedFile whole = file_of(9000, 1), bomb = file_of(900'000, 1);
  expect_faults(whole.read(whole.json()).faults, {});
  expect_one_fault(bomb.read(bomb.json()), FaultKind::limit,
                   "/bufferViews/0/extensions/EXT_meshopt_compression/count");
  PackedFile again = whole;  // the same packed bytes in one view after the other
  const std::string view = again.views;
  for (int i = 0; i < 20; ++i) again.views += "," + view;
  const ReadGltf read = again.read(again.json());
  ASSERT_FALSE(read.faults.empty());
  EXPECT_EQ(read.faults[0].kind, FaultKind::limit) << describe(read.faults[0]);
}

TEST(GltfMeshopt, BytesThatAreCutAreFaults) {
  const std::vector<float> points = random_points(30, 9);
  const Bytes bytes = packed_attributes(points.data(), 30, 12);
  std::vector<std::uint8_t> to(30 * 12);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(unpack_meshopt(MeshoptMode::attributes, span_of(bytes).first(size), 30, 12, to));
  EXPECT_TRUE(unpack_meshopt(MeshoptMode::attributes, span_of(bytes), 30, 12, to));
  EXPECT_EQ(to, bytes_of(points));
}

}  // namespace
}  // namespace tia::test::gltf_files
