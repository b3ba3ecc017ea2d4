#include <limits>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/models/webp_files.h"
#include "tests/server/load/hostile_files.h"

namespace tia::test {
namespace {

using gltf_files::bytes_of;
using gltf_files::glb_chunk;
using gltf_files::glb_of;
using gltf_files::GltfBuilder;
using gltf_files::one_triangle;
using gltf_files::replaced;

std::string glb_text(const std::string& json, const Bytes& bin) {
  return to_text(glb_of({glb_chunk("JSON", to_bytes(json)), glb_chunk({"BIN\0", 4}, bin, '\0')}));
}

// The document of one triangle: its views have 36 and 6 bytes, its accessors three elements each.
constexpr const char *view_offset = R"("byteOffset":36)", *view_length = R"("byteLength":6)",
                     *long_view_length = R"("byteLength":36)", *vec3_count = R"("VEC3","count":3)",
                     *node_list = R"("nodes":[{"mesh":0}])", *position_of_0 = R"("POSITION":0)";
const std::string sparse_words =
    R"(,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},)"
    R"("values":{"bufferView":0}})";

/// ChangedWord: a text of the document, and what stands in its place.
struct ChangedWord {
  std::string law, from, to;
};
const ChangedWord changed_words[] = {
    {"AnOffsetThatWrapsAround", view_offset, R"("byteOffset":18446744073709551580)"},
    {"AnOffsetOfTheLargestNumber", view_offset, R"("byteOffset":9223372036854775807)"},
    {"ALengthThatWrapsAround", view_length, R"("byteLength":18446744073709551615)"},
    {"ALengthOf4G", long_view_length, R"("byteLength":4294967295)"},
    {"ACountOf4G", vec3_count, R"("VEC3","count":4294967295)"},
    {"ACountThatWrapsAroundTimesItsSize", vec3_count, R"("VEC3","count":1537228672809129302)"},
    {"ACountOf2To64", vec3_count, R"("VEC3","count":18446744073709551616)"},
    {"ACountBeyondNumbers", vec3_count, R"("VEC3","count":1e400)"},
    {"ANegativeCount", vec3_count, R"("VEC3","count":-3)"},
    {"ACountOfAHalf", vec3_count, R"("VEC3","count":2.5)"},
    {"ZerosWithoutAViewOf4G", R"("bufferView":0,"componentType":5126,"type":"VEC3","count":3)",
     R"("componentType":5126,"type":"VEC3","count":4294967295)"},
    {"AnOffsetInItsViewThatWrapsAround", vec3_count,
     R"("VEC3","count":3,"byteOffset":18446744073709551604)"},
    {"AStrideOf4G", long_view_length, R"("byteLength":36,"byteStride":4294967292)"},
    {"AStrideBeyondTheView", long_view_length, R"("byteLength":36,"byteStride":252)"},
    {"ABufferThatIsNotThere", R"("buffer":0,"byteOffset":36)",
     R"("buffer":4294967295,"byteOffset":36)"},
    {"AViewThatIsNotThere", R"("bufferView":1)", R"("bufferView":18446744073709551615)"},
    {"AMeshThatIsNotThere", node_list, R"("nodes":[{"mesh":4294967295}])"},
    {"ANodeThatIsItsOwnChild", node_list, R"("nodes":[{"mesh":0,"children":[0]}])"},
    {"NodesInACircle", node_list, R"("nodes":[{"mesh":0,"children":[1]},{"children":[0]}])"},
    {"ANodeOfTwoParents", node_list, R"("nodes":[{"children":[2]},{"children":[2]},{"mesh":0}])"},
    {"SparseCountOf4G", vec3_count,
     R"("VEC3","count":3)" + replaced(sparse_words, "2", "4294967295")},
    {"SparseThatWrapsAround", vec3_count,
     R"("VEC3","count":3)" + replaced(sparse_words, R"("bufferView":1)",
                                      R"("bufferView":1,"byteOffset":18446744073709551614)")},
    {"AnAttributeThatIsNotThere", position_of_0, R"("POSITION":4294967295)"},
    {"JointsWithoutASkin", node_list, R"("nodes":[{"mesh":0,"skin":4294967295}])"},
    {"AFileOfThisMachine", R"("buffers":[{)", R"("buffers":[{"uri":"/etc/passwd",)"},
    {"AFileAboveItsFolder", R"("buffers":[{)", R"("buffers":[{"uri":"../../etc/passwd",)"},
    {"AnAddress", R"("buffers":[{)", R"("buffers":[{"uri":"http://127.0.0.1/",)"},
    {"ABufferThatIsNoBase64", R"("buffers":[{)",
     R"("buffers":[{"uri":"data:application/octet-stream;base64,*",)"},
    {"NoNumber", node_list, R"("nodes":[{"mesh":0,"translation":[NaN,0,0]}])"},
    {"ANumberBeyondNumbers", node_list, R"("nodes":[{"mesh":0,"scale":[1e999,1,1]}])"},
    {"TheSameKeyTwice", node_list, R"("nodes":[{"mesh":0}],"nodes":[{"mesh":0}])"},
    {"TextureOf4G", node_list, R"("textures":[{"source":4294967295}],"nodes":[{"mesh":0}])"},
    {"InstancesOf4G", node_list,
     R"("extensionsUsed":["EXT_mesh_gpu_instancing"],"nodes":[{"mesh":0,"extensions":
        {"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":4294967295}}}}])"},
    {"AnArrayInAnArrayAMillionTimes", node_list, R"("extras":)" + std::string(1'000'000, '[')}};

std::string chain_of_nodes(int nodes_in_each_other) {
  std::string list = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < nodes_in_each_other; ++i)
    list += ",{\"children\":[" + std::to_string(i) + "]}";
  return list + "]";
}

void add_words_and_trees(HostileFiles& all) {
  const GltfBuilder triangle = one_triangle();
  const std::string json = triangle.json();
  for (const ChangedWord& each : changed_words)
    all.push_back({each.law, glb_text(replaced(json, each.from, each.to), triangle.bin)});
  all.push_back({"NodesInEachOther100000Times",
                 glb_text(replaced(json, node_list, chain_of_nodes(100'000)), triangle.bin)});
  std::string values = "\"extras\":[{}";
  for (int i = 0; i < 1'100'000; ++i) values += ",{}";
  all.push_back({"MoreThanAMillionValues",
                 glb_text(replaced(json, node_list, values + "]," + node_list), triangle.bin)});
}

void add_numbers(HostileFiles& all) {
  const GltfBuilder triangle = one_triangle();
  for (const float x :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38F}) {
    Bytes bin = triangle.bin;
    std::memcpy(&bin[12], &x, sizeof x);
    all.push_back({"APositionOf" + std::to_string(x), glb_text(triangle.json(), bin)});
  }
  Bytes far = triangle.bin;
  far[36] = far[37] = 255;
  all.push_back({"AnIndexBeyondTheVertices", glb_text(triangle.json(), far)});
  const std::pair<const char*, std::vector<std::uint16_t>> lists[] = {
      {"SparseOutOfOrder", {1, 0}}, {"SparseTwice", {1, 1}}, {"SparseOutOfRange", {1, 3}}};
  for (const auto& [law, list] : lists) {
    GltfBuilder with_list = one_triangle();
    with_list.view(bytes_of(list));
    const std::string sparse = replaced(sparse_words, "\"bufferView\":1", "\"bufferView\":2");
    const std::string json = replaced(with_list.json(), vec3_count, vec3_count + sparse);
    all.push_back({law, glb_text(json, with_list.bin)});
  }
}

// Before, within and behind each part of the container.
void add_cuts(HostileFiles& all) {
  const GltfBuilder triangle = one_triangle();
  const std::string glb = to_text(triangle.glb());
  const std::size_t bin_at = 20 + (triangle.json().size() + 3) / 4 * 4;
  for (const std::size_t at : {std::size_t{8}, std::size_t{12}, bin_at})
    all.push_back({"ALengthOfAllOnesAt" + std::to_string(at),
                   std::string(glb).replace(at, 4, "\xFF\xFF\xFF\xFF")});
  for (const std::size_t cut :
       {std::size_t{4}, std::size_t{11}, std::size_t{12}, std::size_t{19}, std::size_t{20},
        bin_at - 1, bin_at, bin_at + 7, bin_at + 8, glb.size() - 1})
    all.push_back({"CutAt" + std::to_string(cut), glb.substr(0, cut)});
}

void add_textures(HostileFiles& all) {
  Bytes jpeg = flat_jpeg({140, 120, 130});
  const Bytes frame{0xFF, 0xC0};
  const auto at = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end());
  std::fill_n(at + 5, 4, std::uint8_t{255});
  const std::pair<const char*, Bytes> files[] = {
      {"png", png({65535, 65535, 8, rgba}, "x")},
      {"jpeg", jpeg},
      {"webp", lossless_webp(16384, 16384, {1, 2, 3, 4, 5}, "")}};
  for (const auto& [type, bytes] : files) {
    GltfBuilder triangle = one_triangle();
    const int view = triangle.view(bytes);
    triangle.set("images", "[{\"mimeType\":\"image/" + std::string(type) +
                               "\",\"bufferView\":" + std::to_string(view) + "}]");
    triangle.set("textures", R"([{"source":0}])");
    triangle.set("materials", R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])");
    const std::string json =
        replaced(triangle.json(), "\"attributes\"", "\"material\":0,\"attributes\"");
    all.push_back({std::string("ATextureOf65535Squared_") + type, glb_text(json, triangle.bin)});
  }
}

}  // namespace

HostileFiles hostile_gltf() {
  HostileFiles all;
  add_words_and_trees(all);
  add_numbers(all);
  add_cuts(all);
  add_textures(all);
  return all;
}

}  // namespace tia::test
