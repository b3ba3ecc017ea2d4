// Small models for the server's tests, alone and with what they name.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "server/stores/model_upload.h"

namespace tia::test {

/// A triangle as ASCII STL, of that name.
inline std::string stl_text(const std::string& name = "part") {
  return "solid " + name +
         "\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"
         "endsolid " +
         name + "\n";
}

/// NamedText: a file by its path.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// A triangle as OBJ, and the materials that it names.
inline NamedTexts obj_and_mtl() {
  return {{"chair.obj", "mtllib mtl/wood.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
          {"mtl/wood.mtl", "newmtl wood\nKd 0.5 0.25 0.125\n"}};
}

inline ModelFile file_of(const std::string& path, const std::string& text) {
  return {path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}};
}
/// Views into the texts, the first of which is the model.
inline server::ModelUpload upload_of_texts(const NamedTexts& texts) {
  ModelFiles files;
  for (const auto& [path, text] : texts) files.all.push_back(file_of(path, text));
  return server::upload_of(std::move(files));
}

inline std::string joined_text(const std::vector<std::string_view>& pieces) {
  std::string all;
  for (const std::string_view piece : pieces) all += piece;
  return all;
}

/// The body of a form of these files, with the boundary "border".
inline std::string form_of_files(const NamedTexts& texts) {
  std::string body;
  for (const auto& [path, text] : texts)
    body += joined_text({"--border\r\nContent-Disposition: form-data; name=\"file\"; filename=\"",
                         path, "\"\r\n\r\n", text, "\r\n"});
  return body + "--border--\r\n";
}
inline constexpr const char* form_type = "multipart/form-data; boundary=border";

}  // namespace tia::test
