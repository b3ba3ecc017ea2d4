// PLY files put together: one content, written in each of the encodings.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/models/ply.h"
#include "tests/core/models/model_reading.h"

namespace tia::test {

inline constexpr std::array<std::string_view, 3> ply_encodings{"ascii", "binary_little_endian",
                                                               "binary_big_endian"};

/// A number as its type's bytes, lowest first. Domain: a number that the type has.
inline std::string ply_number_bytes(std::string_view type, double x) {
  if (type == "char" || type == "int8") return bytes_of_number(static_cast<std::int8_t>(x));
  if (type == "uchar" || type == "uint8") return bytes_of_number(static_cast<std::uint8_t>(x));
  if (type == "short" || type == "int16") return bytes_of_number(static_cast<std::int16_t>(x));
  if (type == "ushort" || type == "uint16") return bytes_of_number(static_cast<std::uint16_t>(x));
  if (type == "int" || type == "int32") return bytes_of_number(static_cast<std::int32_t>(x));
  if (type == "uint" || type == "uint32") return bytes_of_number(static_cast<std::uint32_t>(x));
  if (type == "float" || type == "float32") return bytes_of_number(static_cast<float>(x));
  return bytes_of_number(x);
}

/// PlyFile: the header's lines and the values of the body, which know their types.
class PlyFile {
 public:
  PlyFile& element(const std::string& name, std::size_t count) {
    return line("element " + name + " " + std::to_string(count));
  }
  PlyFile& property(const std::string& type, const std::string& name) {
    return line("property " + type + " " + name);
  }
  PlyFile& list(const std::string& count, const std::string& type, const std::string& name) {
    return line("property list " + count + " " + type + " " + name);
  }
  PlyFile& line(const std::string& text) {
    head_ += text + "\n";
    return *this;
  }
  /// A number of the body.
  PlyFile& put(std::string_view type, double x) {
    values_.push_back({std::string(type), x});
    return *this;
  }
  PlyFile& put_list(std::string_view count, std::string_view type, const std::vector<int>& list) {
    put(count, static_cast<double>(list.size()));
    for (const int x : list) put(type, x);
    return *this;
  }
  PlyFile& end_row() {
    values_.push_back({"", 0});
    return *this;
  }

  std::string in(std::string_view encoding) const {
    std::string file = "ply\nformat " + std::string(encoding) + " 1.0\n" + head_ + "end_header\n";
    for (const auto& [type, x] : values_) {
      std::string bytes = type.empty() ? "" : ply_number_bytes(type, x);
      if (encoding == "binary_big_endian") std::reverse(bytes.begin(), bytes.end());
      if (encoding != "ascii") file += bytes;
      else file += type.empty() ? "\n" : text_of(x) + " ";
    }
    return file;
  }

 private:
  static std::string text_of(double x) {
    std::array<char, 64> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
  }

  std::string head_;
  std::vector<std::pair<std::string, double>> values_;
};

/// The file with its header made of so many vertices of float x, y, z and such lines; rows follow.
inline std::string ply_text(std::size_t vertices, const std::string& lines,
                            const std::string& body) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\n" + lines + "end_header\n" + body;
}

inline const std::string ply_face_lines =
    "element face 1\nproperty list uchar int vertex_indices\n";
inline const std::string ply_corners = "0 0 0\n1 0 0\n0 1 0\n";

inline ReadModel read_ply_file(const std::string& file, const ModelLimits& limits = {}) {
  return read_model_file(read_ply, file, limits);
}

/// A text's warnings may have lines where bytes have none.
inline Model without_lines(Model model) {
  for (ModelWarning& warning : model.warnings) warning.line = 0;
  return model;
}

/// The text, which is the same in every other encoding.
inline ReadModel read_in_all(const PlyFile& file) {
  ReadModel text = read_ply_file(file.in("ascii"));
  for (const std::string_view encoding : ply_encodings) {
    const ReadModel read = read_ply_file(file.in(encoding));
    for (const Fault& fault : read.faults) ADD_FAILURE() << encoding << ": " << describe(fault);
    EXPECT_TRUE(without_lines(read.model) == without_lines(text.model)) << encoding;
    expect_sound_model(read);
  }
  return text;
}

/// A file of so many vertices of float x, y, z, to be gone on with.
inline PlyFile ply_vertices(std::size_t count) {
  PlyFile file;
  file.element("vertex", count);
  for (const char* name : {"x", "y", "z"}) file.property("float", name);
  return file;
}

}  // namespace tia::test
