// Contract: an accessor's numbers are those that were written, however they lie in the bytes, and
// what lies beyond its view is refused before anything is read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_elements.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

using tia::gltf::Accessor;

/// Opened: a document whose accessors tests read by their numbers.
class Opened {
 public:
  explicit Opened(const GltfBuilder& builder, const ModelLimits& limits = {})
      : Opened(builder.json(), builder.bin, limits) {}
  Opened(const std::string& json, const Bytes& bin, const ModelLimits& limits = {})
      : bin_(bin),
        limits_(limits),
        json_(parse_json(json)),
        root_(&json_, Place{}, faults),
        bytes_(root_, {files_, ModelBytes(bin_), limits_}, model_),
        source_{root_, bytes_, files_, limits_, faults} {}

  /// All its numbers, none where it cannot be read.
  template <class Number>
  std::vector<Number> read(std::size_t accessor) {
    const Accessor& found = bytes_.accessors().at(accessor);
    if (!found.good) return {};
    return tia::gltf::read_elements<Number>(source_, found, found.count)
        .value_or(std::vector<Number>());
  }
  const Accessor& accessor(std::size_t i) const { return bytes_.accessors().at(i); }

  Faults faults;

 private:
  Bytes bin_;
  ModelFiles files_;
  ModelLimits limits_;
  Model model_;
  Value json_;
  tia::gltf::GltfObject root_;
  tia::gltf::GltfBytes bytes_;
  tia::gltf::GltfSource source_;
};

ReadGltf opened_faults(Opened& opened) { return {{}, opened.faults.list()}; }

/// Written: integers or floats as they lie in a file, and what they mean.
struct Written {
  int component;
  bool normalized;
  int bits;  // of an integer; 0 of floats
  bool is_signed;
};
const std::vector<Written> all_written{
    {gltf_byte, false, 8, true},     {gltf_byte, true, 8, true},     {gltf_ubyte, false, 8, false},
    {gltf_ubyte, true, 8, false},    {gltf_short, false, 16, true},  {gltf_short, true, 16, true},
    {gltf_ushort, false, 16, false}, {gltf_ushort, true, 16, false}, {gltf_uint, false, 32, false},
    {gltf_float, false, 0, false}};

std::size_t size_of(const Written& w) {
  return w.bits == 0 ? 4 : static_cast<std::size_t>(w.bits) / 8;
}
// Little-endian, byte by byte.
void put(Bytes& to, std::int64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    to.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * i)));
}
double put_random(Bytes& to, const Written& w, Random& random) {
  if (w.bits == 0) {
    const auto number = static_cast<float>(random.in(-1000, 1000));
    append(to, bytes_of<float>({number}));
    return number;
  }
  const double least = w.is_signed ? -std::ldexp(1.0, w.bits - 1) : 0,
               most = std::ldexp(1.0, w.is_signed ? w.bits - 1 : w.bits) - 1;
  const double choice = random.unit();
  const double number = choice < 0.1   ? least
                        : choice < 0.2 ? most
                                       : std::floor(random.in(least, most + 1));
  put(to, static_cast<std::int64_t>(number), size_of(w));
  if (!w.normalized) return number;
  return std::max(number / most, -1.0);  // a quotient rounded once
}

constexpr std::array<std::pair<const char*, std::size_t>, 4> vectors{
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};

/// Drawn: a document of one accessor, and the numbers that it means.
struct Drawn {
  GltfBuilder builder;
  std::vector<double> expected;
};

// An element: its numbers and what they mean.
void put_elements(Bytes& to, double* expected, std::size_t size, const Written& w, Random& random) {
  for (std::size_t k = 0; k < size; ++k) expected[k] = put_random(to, w, random);
}

// Some of the elements anew: `sparse`.
std::string put_sparse(Drawn& drawn, std::size_t size, const Written& w, Random& random) {
  std::vector<std::uint16_t> indices;
  Bytes values;
  const std::size_t count = drawn.expected.size() / size;
  for (std::size_t i = 0; i < count; ++i) {
    if (!random.chance(0.5) && i + 1 < count) continue;
    indices.push_back(static_cast<std::uint16_t>(i));
    put_elements(values, drawn.expected.data() + i * size, size, w, random);
  }
  const int index_view = drawn.builder.view(bytes_of(indices)),
            value_view = drawn.builder.view(values);
  return member("sparse", "{\"count\":" + std::to_string(indices.size()) +
                              ",\"indices\":{\"componentType\":5123,\"bufferView\":" +
                              std::to_string(index_view) +
                              "},\"values\":{\"bufferView\":" + std::to_string(value_view) + "}}");
}

// An accessor with or without an offset, a stride, a view, sparse elements.
Drawn drawn_accessor(const Written& w, std::string_view type, std::size_t size, Random& random) {
  const bool sparse = random.chance(0.5), strided = random.chance(0.5),
             viewless = sparse && random.chance(0.3);
  const auto some = [&](int n) { return static_cast<std::size_t>(random.below(n)); };
  const std::size_t count = 1 + some(9), element = size * size_of(w),
                    stride = strided ? (element + 3) / 4 * 4 + 4 * some(3) : element,
                    offset = size_of(w) * some(4);
  Drawn drawn;
  drawn.expected.resize(count * size);
  std::string more = w.normalized ? ",\"normalized\":true" : "";
  int view = -1;
  if (!viewless) {
    Bytes bytes;
    for (std::size_t i = 0; i < count; ++i) {
      bytes.resize(offset + i * stride, 0xAA);
      put_elements(bytes, drawn.expected.data() + i * size, size, w, random);
    }
    bytes.resize(std::max(bytes.size(), stride));
    view = drawn.builder.view(
        bytes, strided ? member("byteStride", std::to_string(stride)) : std::string());
    more += member("byteOffset", std::to_string(offset));
  }
  if (sparse) more += put_sparse(drawn, size, w, random);
  drawn.builder.accessor(view, w.component, type, count, more);
  return drawn;
}

// Component type x normalised x stride x offset x sparse, against what was written.
TEST(GltfAccessors, GiveWhatWasWritten) {
  Random random(7);
  for (const Written& w : all_written)
    for (const auto& [type, size] : vectors)
      for (int round = 0; round < 16; ++round) {
        const Drawn drawn = drawn_accessor(w, type, size, random);
        SCOPED_TRACE(drawn.builder.json());
        Opened opened(drawn.builder);
        EXPECT_EQ(opened.read<double>(0), drawn.expected);
        std::vector<float> narrow;
        for (const double number : drawn.expected) narrow.push_back(static_cast<float>(number));
        EXPECT_EQ(opened.read<float>(0), narrow);
        expect_faults(opened.faults.list(), {});
        if (w.is_signed || w.normalized || w.bits == 0) continue;
        EXPECT_EQ(opened.read<std::uint32_t>(0),
                  std::vector<std::uint32_t>(drawn.expected.begin(), drawn.expected.end()));
      }
}

TEST(GltfAccessors, ColumnsOfMatricesBeginAtFours) {
  // Columns 1 2 | 3 4 and 5 6 | 7 8; the padding of the last column need not be there.
  GltfBuilder builder;
  builder.accessor(builder.view({1, 2, 90, 91, 3, 4, 92, 93, 5, 6, 94, 95, 7, 8}), gltf_ubyte,
                   "MAT2", 2);
  builder.accessor(builder.view({1, 2, 3, 90, 4, 5, 6, 91, 7, 8, 9}), gltf_ubyte, "MAT3", 1);
  builder.numbers<std::uint16_t>(gltf_ushort, "MAT3", 12, {1, 2, 3, 90, 4, 5, 6, 91, 7, 8, 9, 92});
  builder.numbers<std::uint16_t>(gltf_ushort, "MAT2", 4, {1, 2, 3, 4});
  builder.numbers<float>(gltf_float, "MAT3", 9, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  Opened opened(builder);
  const std::vector<double> nine{1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(opened.read<double>(0), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(opened.read<double>(1), nine);
  EXPECT_EQ(opened.read<double>(2), nine);
  EXPECT_EQ(opened.read<double>(3), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(opened.read<double>(4), nine);
  expect_faults(opened.faults.list(), {});
  GltfBuilder short_one;
  short_one.accessor(short_one.view({1, 2, 3, 90, 4, 5, 6, 91, 7, 8}), gltf_ubyte, "MAT3", 1);
  Opened refused(short_one);
  expect_one_fault(opened_faults(refused), FaultKind::out_of_range, "/accessors/0");
}

/// A change of a good document's text, and where it is refused.
struct Refused {
  std::string from, to;
  FaultKind kind;
  std::string pointer;
};
void expect_refused(const GltfBuilder& builder, const std::vector<Refused>& rows) {
  for (const Refused& row : rows) {
    const std::string json = replaced(builder.json(), row.from, row.to);
    SCOPED_TRACE(json);
    Opened opened(json, builder.bin);
    expect_one_fault(opened_faults(opened), row.kind, row.pointer);
  }
}

TEST(GltfAccessors, ViewsLieInTheirBuffers) {
  GltfBuilder builder;
  builder.view(Bytes(24), ",\"byteStride\":12");
  const std::string offset = "\"byteOffset\":0", length = "\"byteLength\":24,\"byteStride\":12",
                    view = "/bufferViews/0";
  const auto long_as = [](const std::string& n) { return "\"byteLength\":" + n; };
  const auto at = [](const std::string& n) { return "\"byteOffset\":" + n; };
  const auto stride = [](const std::string& n) { return "\"byteLength\":24,\"byteStride\":" + n; };
  const auto beyond = FaultKind::out_of_range;
  std::vector<Refused> rows{{offset, at("-1"), beyond, view + "/byteOffset"},
                            {offset, at("0.5"), beyond, view + "/byteOffset"},
                            {offset, at("\"0\""), FaultKind::wrong_type, view + "/byteOffset"},
                            {offset, at("4"), beyond, view + "/byteLength"},
                            {offset, at("24"), beyond, view + "/byteOffset"},
                            {offset, at("9007199254740992"), beyond, view + "/byteOffset"},
                            {offset, at("18446744073709551592"), beyond, view + "/byteOffset"},
                            {offset, at("1.8446744073709552e19"), beyond, view + "/byteOffset"},
                            {length, long_as("25"), beyond, view + "/byteLength"},
                            {length, long_as("0"), beyond, view + "/byteLength"},
                            {length, long_as("1e15"), beyond, view + "/byteLength"},
                            {length, stride("0"), beyond, view + "/byteStride"},
                            {length, stride("6"), beyond, view + "/byteStride"},
                            {length, stride("256"), beyond, view + "/byteStride"},
                            {length, stride("28"), beyond, view + "/byteStride"},
                            {length, stride("4,\"target\":34963"), beyond, view + "/byteStride"},
                            {"\"buffer\":0", "\"buffer\":1", beyond, view + "/buffer"},
                            {"\"buffer\":0,", "", FaultKind::missing, view + "/buffer"}};
  expect_refused(builder, rows);
}

TEST(GltfAccessors, ElementsLieInTheirViews) {
  GltfBuilder builder;
  builder.accessor(builder.view(Bytes(40), ",\"byteStride\":16"), gltf_float, "VEC2", 3,
                   ",\"byteOffset\":0");
  Opened good(builder);
  EXPECT_EQ(good.read<float>(0), std::vector<float>(6));
  const std::string count = "\"count\":3", offset = "\"count\":3,\"byteOffset\":0",
                    here = "/accessors/0";
  const auto of = [](const std::string& n) { return "\"count\":" + n; };
  const auto from = [](const std::string& n) { return "\"count\":3,\"byteOffset\":" + n; };
  const auto beyond = FaultKind::out_of_range;
  expect_refused(
      builder,
      {{count, of("4"), beyond, here},
       {count, of("4000000000"), beyond, here},
       {count, of("1e15"), beyond, here},
       {count, of("9007199254740992"), beyond, here},
       {count, of("1152921504606846977"), beyond, here + "/count"},  // times 16 it wraps to 16
       {count, of("0"), beyond, here + "/count"},
       {count, of("2.5"), beyond, here + "/count"},
       {offset, from("4"), beyond, here},
       {offset, from("2"), beyond, here + "/byteOffset"},
       {offset, from("44"), beyond, here + "/byteOffset"},
       {offset, from("9007199254740988"), beyond, here + "/byteOffset"},
       {offset, from("18446744073709551600"), beyond, here + "/byteOffset"},
       {"\"bufferView\":0", "\"bufferView\":1", beyond, here + "/bufferView"},
       {"\"bufferView\":0,", "", FaultKind::conflict, here + "/byteOffset"},
       {"\"byteOffset\":0,\"byteLength\":40", "\"byteOffset\":2,\"byteLength\":38", beyond, here},
       {"5126", "5124", beyond, here + "/componentType"},
       {"5126", "\"FLOAT\"", FaultKind::wrong_type, here + "/componentType"},
       {"VEC2", "VEC5", beyond, here + "/type"},
       {"VEC2", "MAT3", beyond, here},  // the stride is too small
       {count, "\"normalized\":true,\"count\":3", FaultKind::conflict, here + "/normalized"},
       {",\"count\":3", "", FaultKind::missing, here + "/count"}});
}

TEST(GltfAccessors, WithoutBytesThereAreZerosUpToALimit) {
  GltfBuilder builder;
  builder.accessor(-1, gltf_float, "VEC3", 1000);
  ModelLimits limits;
  limits.vertices = 1000;
  Opened opened(builder, limits);
  EXPECT_EQ(opened.read<float>(0), std::vector<float>(3000));
  limits.vertices = 999;
  Opened refused(builder, limits);
  expect_one_fault(opened_faults(refused), FaultKind::limit, "/accessors/0/count");
}

TEST(GltfAccessors, SparseListsAreRefusedWhereTheyAreWrong) {
  GltfBuilder builder;
  builder.view(bytes_of<std::uint32_t>({1, 3}));
  builder.view(bytes_of<float>({5, 6}));
  builder.accessor(-1, gltf_float, "SCALAR", 4,
                   R"(,"sparse":{"count":2,"indices":{"bufferView":0,"componentType":5125},)"
                   R"("values":{"bufferView":1}})");
  Opened good(builder);
  EXPECT_EQ(good.read<float>(0), (std::vector<float>{0, 5, 0, 6}));
  const auto beyond = FaultKind::out_of_range;
  const std::string sparse = "/accessors/0/sparse", indices = R"("indices":{"bufferView":0,)";
  expect_refused(
      builder, {{"\"sparse\":{\"count\":2", "\"sparse\":{\"count\":0", beyond, sparse + "/count"},
                {"\"sparse\":{\"count\":2", "\"sparse\":{\"count\":5", beyond, sparse + "/count"},
                {indices, indices + "\"byteOffset\":4,", beyond, sparse + "/indices"},
                {indices, indices + "\"byteOffset\":2,", beyond, sparse + "/indices/byteOffset"},
                {indices, indices + "\"byteOffset\":1e15,", beyond, sparse + "/indices/byteOffset"},
                {indices, R"("indices":{"bufferView":2,)", beyond, sparse + "/indices/bufferView"},
                {indices, R"("indices":{)", FaultKind::missing, sparse + "/indices/bufferView"},
                {"5125", "5126", beyond, sparse + "/indices/componentType"},
                {R"(,"values":{"bufferView":1})", "", FaultKind::missing, sparse + "/values"},
                {R"("values":{"bufferView":1})", R"("values":{"bufferView":1,"byteOffset":8})",
                 beyond, sparse + "/values"}});
  const std::vector<std::vector<std::uint32_t>> wrong{
      {3, 3}, {3, 1}, {1, 4}, {0xFFFF'FFFF, 1}, {0, 0xFFFF'FFFF}};
  for (const auto& list : wrong) {
    Bytes bin = builder.bin;
    const Bytes bytes = bytes_of(list);
    std::copy(bytes.begin(), bytes.end(), bin.begin());
    Opened opened(builder.json(), bin);
    opened.read<float>(0);
    expect_one_fault(opened_faults(opened), beyond, sparse);
  }
}

TEST(GltfAccessors, OnlyFiniteNumbersAreTaken) {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    GltfBuilder builder;
    builder.vec3({1, 2, 3, 4, 5, wrong, 7, wrong, 9});
    Opened opened(builder);
    EXPECT_TRUE(opened.read<double>(0).empty());
    expect_faults(opened.faults.list(), {{FaultKind::out_of_range, "/accessors/0",
                                          wrong != wrong ? "\"NaN\""
                                          : wrong > 0    ? "\"Infinity\""
                                                         : "\"-Infinity\"",
                                          "component 2 of element 1"}});
  }
  GltfBuilder builder;
  builder.vec3({std::numeric_limits<float>::max(), -std::numeric_limits<float>::max(), 1e-45F});
  Opened opened(builder);
  EXPECT_EQ(opened.read<float>(0).size(), 3U);
}

}  // namespace
}  // namespace tia::test::gltf_files
