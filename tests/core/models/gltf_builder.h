// How tests write glTF files: numbers into the bytes of one buffer, and the JSON around them.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/models/gltf/gltf.h"
#include "tests/core/faults.h"
#include "tests/core/film/files.h"

namespace tia::test::gltf_files {

inline constexpr int gltf_byte = 5120, gltf_ubyte = 5121, gltf_short = 5122, gltf_ushort = 5123,
                     gltf_uint = 5125, gltf_float = 5126;

template <class T>
Bytes bytes_of(const std::vector<T>& numbers) {
  Bytes bytes(numbers.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}
inline void append(Bytes& to, const Bytes& from) { to.insert(to.end(), from.begin(), from.end()); }
inline void append_word(Bytes& to, std::uint32_t word) {
  append(to, bytes_of<std::uint32_t>({word}));
}
inline ModelBytes span_of(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

/// A member of a JSON object behind others: `, "name":value`.
inline std::string member(std::string_view name, const std::string& value) {
  return ",\"" + std::string(name) + "\":" + value;
}

/// A GLB chunk, padded.
inline Bytes glb_chunk(std::string_view type, Bytes bytes, char padding = ' ') {
  while (bytes.size() % 4 != 0) bytes.push_back(static_cast<std::uint8_t>(padding));
  Bytes chunk;
  append_word(chunk, static_cast<std::uint32_t>(bytes.size()));
  append(chunk, to_bytes(type));
  append(chunk, bytes);
  return chunk;
}
inline Bytes glb_of(const std::vector<Bytes>& chunks, std::uint32_t version = 2) {
  Bytes inside;
  for (const Bytes& chunk : chunks) append(inside, chunk);
  Bytes file = to_bytes("glTF");
  append_word(file, version);
  append_word(file, static_cast<std::uint32_t>(inside.size() + 12));
  append(file, inside);
  return file;
}

/// GltfBuilder: a document with one buffer.
class GltfBuilder {
 public:
  /// Puts bytes at the next multiple of four. Returns: the view of them.
  int view(const Bytes& bytes, const std::string& more = "") {
    while (bin.size() % 4 != 0) bin.push_back(0);
    add(views_, "{\"buffer\":0,\"byteOffset\":" + std::to_string(bin.size()) +
                    ",\"byteLength\":" + std::to_string(bytes.size()) + more + "}");
    append(bin, bytes);
    return view_count_++;
  }
  /// Any accessor; `view` -1: none.
  int accessor(int view, int component, std::string_view type, std::size_t count,
               const std::string& more = "") {
    add(accessors_, "{" + (view < 0 ? "" : "\"bufferView\":" + std::to_string(view) + ",") +
                        "\"componentType\":" + std::to_string(component) + ",\"type\":\"" +
                        std::string(type) + "\",\"count\":" + std::to_string(count) + more + "}");
    return accessor_count_++;
  }
  /// Packed numbers with an accessor of their own.
  template <class T>
  int numbers(int component, std::string_view type, std::size_t size, const std::vector<T>& values,
              const std::string& more = "") {
    return accessor(view(bytes_of(values)), component, type, values.size() / size, more);
  }
  int floats(std::string_view type, std::size_t size, const std::vector<float>& values) {
    return numbers(gltf_float, type, size, values);
  }
  int vec3(const std::vector<float>& values) { return floats("VEC3", 3, values); }

  /// A list of the document: `set("nodes", "[{}]")`.
  void set(std::string_view name, const std::string& value) { members += member(name, value); }

  std::string json(const std::string& buffer_more = "") const {
    std::string text = "{\"asset\":{\"version\":\"2.0\"}" + members;
    if (!bin.empty())
      text +=
          member("buffers", "[{\"byteLength\":" + std::to_string(bin.size()) + buffer_more + "}]");
    if (view_count_ > 0) text += member("bufferViews", "[" + views_ + "]");
    if (accessor_count_ > 0) text += member("accessors", "[" + accessors_ + "]");
    return text + "}";
  }
  Bytes glb() const {
    std::vector<Bytes> chunks{glb_chunk("JSON", to_bytes(json()))};
    if (!bin.empty()) chunks.push_back(glb_chunk({"BIN\0", 4}, bin, '\0'));
    return glb_of(chunks);
  }

  Bytes bin;
  std::string members;

 private:
  static void add(std::string& list, const std::string& entry) {
    list += (list.empty() ? "" : ",") + entry;
  }

  std::string views_, accessors_;
  int view_count_ = 0, accessor_count_ = 0;
};

/// A document of one primitive: `{"attributes":{…}, more}`.
inline std::string one_primitive(const std::string& attributes, const std::string& more = "") {
  return "[{\"primitives\":[{\"attributes\":{" + attributes + "}" + more + "}]}]";
}

using Indices = std::vector<std::uint32_t>;
/// The pointer of a document's first primitive.
inline const std::string primitive = "/meshes/0/primitives/0";

/// `"POSITION":3`.
inline std::string named(std::string_view attribute, int accessor) {
  return "\"" + std::string(attribute) + "\":" + std::to_string(accessor);
}

/// n points in a row.
inline std::vector<float> row(std::size_t n) {
  std::vector<float> points(n * 3);
  for (std::size_t i = 0; i < n; ++i) points[i * 3] = static_cast<float>(i);
  return points;
}

/// A primitive of n vertices; `more` behind its attributes.
inline GltfBuilder of_vertices(std::size_t n, const std::string& more = "") {
  GltfBuilder builder;
  builder.set("meshes", one_primitive(named("POSITION", builder.vec3(row(n))), more));
  return builder;
}

/// What came of reading.
struct ReadGltf {
  Model model;
  std::vector<Fault> faults;

  bool warned(std::string_view pointer) const {
    for (const ModelWarning& warning : model.warnings)
      if (warning.pointer == pointer) return true;
    return false;
  }
};
inline ReadGltf read_files(const std::vector<std::pair<std::string, Bytes>>& files,
                           const ModelLimits& limits = {}) {
  ModelFiles all;
  for (const auto& file : files) all.all.push_back({file.first, span_of(file.second)});
  ReadGltf read;
  Faults faults;
  read_gltf(all, limits, faults, read.model);
  read.faults = faults.list();
  return read;
}
inline ReadGltf read_glb(const Bytes& file, const ModelLimits& limits = {}) {
  return read_files({{"a.glb", file}}, limits);
}
inline ReadGltf read_built(const GltfBuilder& builder, const ModelLimits& limits = {}) {
  return read_glb(builder.glb(), limits);
}
/// The model, without a fault.
inline Model model_of(const GltfBuilder& builder) {
  const ReadGltf read = read_built(builder);
  expect_faults(read.faults, {});
  return read.model;
}
/// The first primitive's part, which is empty where there is none.
inline ModelPart part_of(const GltfBuilder& builder) {
  const Model model = model_of(builder);
  const bool has = !model.meshes.empty() && !model.meshes[0].parts.empty();
  EXPECT_TRUE(has);
  return has ? model.meshes[0].parts[0] : ModelPart{};
}

/// Kind and place of one fault, which is all of them.
inline void expect_one_fault(const ReadGltf& read, FaultKind kind, const std::string& pointer) {
  ASSERT_EQ(read.faults.size(), 1U) << [&] {
    std::string all;
    for (const Fault& fault : read.faults) all += describe(fault) + "\n";
    return pointer + " expected, not\n" + all;
  }();
  EXPECT_EQ(read.faults[0].kind, kind) << describe(read.faults[0]);
  EXPECT_EQ(read.faults[0].pointer, pointer) << describe(read.faults[0]);
}

/// One triangle in the plane z = 0, as a document.
inline GltfBuilder one_triangle() {
  GltfBuilder builder;
  const int positions = builder.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int indices = builder.numbers<std::uint16_t>(gltf_ushort, "SCALAR", 1, {0, 1, 2});
  builder.set("meshes", one_primitive("\"POSITION\":" + std::to_string(positions),
                                      member("indices", std::to_string(indices))));
  builder.set("nodes", "[{\"mesh\":0}]");
  builder.set("scenes", "[{\"nodes\":[0]}]");
  return builder;
}

/// The text with its first `from` replaced. Domain: it is there.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

}  // namespace tia::test::gltf_files
