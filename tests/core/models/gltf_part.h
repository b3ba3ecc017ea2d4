// What one part of the glTF reader makes of a document, and the files that documents name.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/models/gltf/gltf_parts.h"
#include "tests/core/film/files.h"

namespace tia::test {

struct NamedFile {
  std::string path;
  Bytes bytes;
};

/// PartRead: what came of it.
struct PartRead {
  Model model;
  Faults faults;

  /// "wrong_type /images/0" and so on: the kinds as numbers' names, in order.
  std::vector<std::string> fault_lines() const {
    constexpr std::string_view kinds[] = {"malformed", "unknown_name", "wrong_type", "out_of_range",
                                          "missing",   "conflict",     "limit"};
    std::vector<std::string> lines;
    for (const Fault& fault : faults.list())
      lines.push_back(std::string(kinds[static_cast<std::size_t>(fault.kind)]) + " " +
                      fault.pointer);
    return lines;
  }
  std::vector<std::string> warning_lines() const {
    std::vector<std::string> lines;
    for (const ModelWarning& warning : model.warnings)
      lines.push_back(warning.pointer + ": " + warning.text);
    return lines;
  }
};

using GltfPart = void (*)(const tia::gltf::GltfSource& source, Model& model);

/// Reads a part of a document named "model.gltf". Its only buffer is the file "data.bin".
PartRead read_part(GltfPart part, const std::string& json,
                   const std::vector<NamedFile>& files = {});

inline std::string data_uri(std::string_view type, const Bytes& bytes) {
  return "data:" + std::string(type) + ";base64," + base64(to_text(bytes));
}

}  // namespace tia::test
