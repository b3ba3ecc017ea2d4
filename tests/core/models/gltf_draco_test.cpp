// Contract: what Draco has packed is what stood there unpacked, within its steps; what is packed
// otherwise than the document says is a fault at its place. The packer is libdraco's encoder.
#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/models/draco.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

constexpr int no_quantization = 0;

/// Sheet: a grid of vertices, bent, with all that can be packed.
struct Sheet {
  std::vector<float> positions, normals, uvs;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> indices;
  std::size_t vertices() const { return positions.size() / 3; }
};
Sheet random_sheet(std::uint32_t side, std::uint64_t seed) {
  Random random(seed);
  Sheet sheet;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const Vec3d n = random.direction();
      for (const double each : {double(x), random.in(-1, 1), double(y)})
        sheet.positions.push_back(static_cast<float>(each));
      for (const double each : {n.x, n.y, n.z}) sheet.normals.push_back(static_cast<float>(each));
      for (const double each : {x / 8.0, y / 8.0}) sheet.uvs.push_back(static_cast<float>(each));
      for (int i = 0; i < 4; ++i) {
        sheet.colors.push_back(static_cast<std::uint8_t>(random.below(256)));
        sheet.joints.push_back(static_cast<std::uint16_t>(random.below(300)));
      }
      const std::uint32_t at = y * side + x;
      if (x + 1 < side && y + 1 < side)
        for (const std::uint32_t each : {at, at + 1, at + side, at + 1, at + side + 1, at + side})
          sheet.indices.push_back(each);
    }
  return sheet;
}

template <class T>
int add_packed(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data,
               int size, const std::vector<T>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(size), data, false,
                 static_cast<std::int64_t>(sizeof(T)) * size, 0);
  const auto count = static_cast<std::uint32_t>(values.size() / static_cast<std::size_t>(size));
  const int id = mesh.AddAttribute(attribute, true, count);
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                          values.data() + i * static_cast<std::size_t>(size));
  return id;
}

// Vertices stay in their order where the method is sequential. Bits of 0: floats as they are.
Bytes packed_sheet(const Sheet& sheet, int bits = no_quantization,
                   int method = draco::MESH_SEQUENTIAL_ENCODING) {
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(sheet.vertices()));
  using draco::GeometryAttribute;
  add_packed(mesh, GeometryAttribute::POSITION, draco::DT_FLOAT32, 3, sheet.positions);
  add_packed(mesh, GeometryAttribute::NORMAL, draco::DT_FLOAT32, 3, sheet.normals);
  add_packed(mesh, GeometryAttribute::TEX_COORD, draco::DT_FLOAT32, 2, sheet.uvs);
  add_packed(mesh, GeometryAttribute::COLOR, draco::DT_UINT8, 4, sheet.colors);
  add_packed(mesh, GeometryAttribute::GENERIC, draco::DT_UINT16, 4, sheet.joints);
  for (std::size_t i = 0; i < sheet.indices.size(); i += 3)
    mesh.AddFace({draco::PointIndex(sheet.indices[i]), draco::PointIndex(sheet.indices[i + 1]),
                  draco::PointIndex(sheet.indices[i + 2])});
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method);
  if (bits != no_quantization)
    for (int i = 0; i < 3; ++i) encoder.SetAttributeQuantization(i, bits);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

constexpr const char* packed_names = "\"POSITION\":0,\"NORMAL\":1,\"TEXCOORD_0\":2,\"COLOR_0\":3";

/// The same sheet as a document, packed where there are packed bytes.
struct SheetFile {
  std::string ids = packed_names, mode{};
  std::size_t indices_more = 0, vertices_more = 0;

  GltfBuilder of(const Sheet& sheet, const Bytes& packed) const {
    GltfBuilder b;
    const bool is = !packed.empty();
    const int view = is ? b.view(packed) : -1;
    const auto add = [&](int type, const char* shape, std::size_t size, const auto& values,
                         const std::string& own = "") {
      return is ? b.accessor(-1, type, shape, values.size() / size + vertices_more, own)
                : b.numbers(type, shape, size, values, own);
    };
    std::string names = named("POSITION", add(gltf_float, "VEC3", 3, sheet.positions));
    names += "," + named("NORMAL", add(gltf_float, "VEC3", 3, sheet.normals));
    names += "," + named("TEXCOORD_0", add(gltf_float, "VEC2", 2, sheet.uvs));
    names +=
        "," + named("COLOR_0", add(gltf_ubyte, "VEC4", 4, sheet.colors, ",\"normalized\":true"));
    const int indices =
        is ? b.accessor(-1, gltf_uint, "SCALAR", sheet.indices.size() + indices_more)
           : b.numbers(gltf_uint, "SCALAR", 1, sheet.indices);
    std::string rest = member("indices", std::to_string(indices)) + mode;
    if (is)
      rest += ",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":" +
              std::to_string(view) + ",\"attributes\":{" + ids + "}}}";
    b.set("extensionsUsed", "[\"KHR_draco_mesh_compression\"]");
    b.set("extensionsRequired", "[\"KHR_draco_mesh_compression\"]");
    b.set("meshes", one_primitive(names, rest));
    return b;
  }
};
const std::string extension = primitive + "/extensions/KHR_draco_mesh_compression";

TEST(GltfDraco, WithoutQuantizationIsTheSameModel) {
  const Sheet sheet = random_sheet(9, 1);
  const ModelPart packed = part_of(SheetFile().of(sheet, packed_sheet(sheet)));
  EXPECT_EQ(packed, part_of(SheetFile().of(sheet, {})));
  EXPECT_EQ(packed.vertices(), 81U);
  EXPECT_EQ(packed.triangles(), 128U);
}

// Edgebreaker gives vertices and triangles in an order of its own: which triangle it is tell its
// positions, which are all different.
TEST(GltfDraco, EdgebreakerHasTheSameTriangles) {
  const auto triangles = [](const ModelPart& part) {
    std::map<std::array<double, 9>, int> all;
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
      std::array<std::array<double, 3>, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          corners[c][k] = part.positions[part.indices[i + c] * 3 + k];
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      std::array<double, 9> flat{};
      for (std::size_t k = 0; k < 9; ++k) flat[k] = corners[k / 3][k % 3];
      ++all[flat];
    }
    return all;
  };
  const Sheet sheet = random_sheet(9, 2);
  const Bytes bytes = packed_sheet(sheet, 0, draco::MESH_EDGEBREAKER_ENCODING);
  EXPECT_EQ(triangles(part_of(SheetFile().of(sheet, bytes))),
            triangles(part_of(SheetFile().of(sheet, {}))));
}

// A step of b bits is the largest extent / (2^b - 1); what is rounded is half a step away at most.
// A normal is on a square of 2^b - 2 steps across, from -1 to 1: two numbers are half a step e away
// at most and the third 2 e, all together sqrt(6) e, and on the sphere sqrt(3) times that.
TEST(GltfDraco, QuantizedIsWithinHalfAStep) {
  const Sheet sheet = random_sheet(9, 3);
  for (const int bits : {8, 11, 16}) {
    const ModelPart part = part_of(SheetFile().of(sheet, packed_sheet(sheet, bits)));
    EXPECT_EQ(part.indices, sheet.indices);
    const double steps = std::pow(2, bits) - 1;
    double most_away = 0;
    for (std::size_t i = 0; i < sheet.positions.size(); ++i)
      most_away = std::max(most_away, std::fabs(part.positions.at(i) - double{sheet.positions[i]}));
    EXPECT_LE(most_away, 0.5001 * 8 / steps + 1e-6);
    EXPECT_GT(most_away, 0.3 * 8 / steps);
    for (std::size_t i = 0; i < sheet.uvs.size(); ++i)
      ASSERT_NEAR(part.uvs[0].at(i), double{sheet.uvs[i]}, 0.5001 / steps + 1e-6);
    for (std::size_t i = 0; i < sheet.normals.size(); ++i)
      ASSERT_NEAR(double{part.normals.at(i)}, double{sheet.normals[i]},
                  std::sqrt(18) / (steps - 1) + 1e-6);
  }
}

// On the processors that our bits are the library's, too: it may be compiled to round otherwise.
TEST(GltfDraco, FloatsAreTheLibrarysToItsLastDigits) {
  const Sheet sheet = random_sheet(9, 4);
  const Bytes bytes = packed_sheet(sheet, 10);
  std::string why;
  const auto own = DracoMesh::unpack(span_of(bytes), why);
  ASSERT_TRUE(own) << why;
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto theirs = draco::Decoder().DecodeMeshFromBuffer(&buffer).value();
  for (std::uint32_t id = 0; id < 3; ++id) {
    const auto values = own->values<float>(id);
    const draco::PointAttribute& attribute = *theirs->GetAttributeByUniqueId(id);
    const std::size_t size = attribute.num_components();
    ASSERT_TRUE(values && own->numbers(id) == size);
    for (std::uint32_t i = 0; i < sheet.vertices(); ++i) {
      std::array<float, 3> known{};
      attribute.ConvertValue<float>(attribute.mapped_index(draco::PointIndex(i)), known.data());
      for (std::size_t k = 0; k < size; ++k)
        ASSERT_NEAR((*values)[i * size + k], known[k], 4e-7 * (1 + std::fabs(known[k])));
    }
  }
  EXPECT_EQ(own->numbers(9), 0U);
  EXPECT_FALSE(own->values<std::uint16_t>(0));  // what floats were
}

TEST(GltfDraco, IntegersBecomeTheAccessorsWhereTheyFit) {
  const Sheet sheet = random_sheet(5, 5);
  const Bytes bytes = packed_sheet(sheet);
  std::string why;
  const auto mesh = DracoMesh::unpack(span_of(bytes), why);
  ASSERT_TRUE(mesh) << why;
  const std::vector<std::uint32_t> joints(sheet.joints.begin(), sheet.joints.end());
  EXPECT_EQ(mesh->values<std::uint16_t>(4), sheet.joints);
  EXPECT_EQ(mesh->values<std::uint32_t>(4), joints);
  EXPECT_TRUE(mesh->values<std::int16_t>(4));
  EXPECT_FALSE(mesh->values<std::uint8_t>(4));  // 256 and above
  EXPECT_FALSE(mesh->values<std::int8_t>(3));
}

TEST(GltfDraco, WhatDoesNotFitIsAFaultAtItsPlace) {
  const Sheet sheet = random_sheet(5, 6);
  const Bytes bytes = packed_sheet(sheet);
  const auto read = [&](const SheetFile& file) { return read_built(file.of(sheet, bytes)); };
  using enum FaultKind;
  expect_one_fault(read({.ids = "\"POSITION\":7"}), out_of_range,
                   extension + "/attributes/POSITION");
  expect_one_fault(read({.ids = "\"POSITION\":2"}), conflict, extension + "/attributes/POSITION");
  expect_one_fault(read({.ids = "\"POSITION\":-1"}), out_of_range,
                   extension + "/attributes/POSITION");
  expect_one_fault(read({.ids = "\"POSITION\":0,\"TANGENT\":1"}), missing,
                   primitive + "/attributes/TANGENT");
  expect_one_fault(read({.indices_more = 3}), conflict, "/accessors/4/count");
  EXPECT_EQ(read({.vertices_more = 1}).faults.size(), 4U);
  EXPECT_EQ(read({.vertices_more = 1}).faults.at(0).pointer, "/accessors/0/count");
  expect_one_fault(read({.mode = ",\"mode\":6"}), conflict, primitive + "/mode");
  expect_faults(read({.mode = ",\"mode\":5"}).faults, {});
  EXPECT_EQ(read({.mode = ",\"mode\":5"}).model.meshes[0].parts.at(0).indices, sheet.indices);
  // The document with another text in its JSON.
  const auto with = [&](std::string_view from, std::string_view to, const std::string& mode = "") {
    const GltfBuilder b = SheetFile{.mode = mode}.of(sheet, bytes);
    return read_glb(glb_of({glb_chunk("JSON", to_bytes(replaced(b.json(), from, to))),
                            glb_chunk({"BIN\0", 4}, b.bin, '\0')}));
  };
  expect_one_fault(with("\"indices\":4,", ""), missing, primitive + "/indices");
  expect_one_fault(with("\"indices\":4", "\"indices\":5"), out_of_range, primitive + "/indices");
  expect_one_fault(with("\"bufferView\":0", "\"bufferView\":1"), out_of_range,
                   extension + "/bufferView");
  // A strip may have fewer triangles than it says, never more: here are 32.
  expect_one_fault(with("\"count\":96", "\"count\":33", ",\"mode\":5"), conflict,
                   "/accessors/4/count");
}

TEST(GltfDraco, BytesThatAreCutOrNoMeshAreFaults) {
  const Sheet sheet = random_sheet(3, 8);
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const Bytes bytes = packed_sheet(sheet, 10, method);
    std::size_t refused = 0;
    for (std::size_t size = 1; size < bytes.size(); ++size) {
      const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
      const ReadGltf read = read_built(SheetFile().of(sheet, cut));
      refused += read.faults.empty() ? 0 : 1;
    }
    EXPECT_EQ(refused, bytes.size() - 1);
  }
  expect_one_fault(read_built(SheetFile().of(sheet, Bytes(40, 'x'))), FaultKind::malformed,
                   extension + "/bufferView");
}

}  // namespace
}  // namespace tia::test::gltf_files
