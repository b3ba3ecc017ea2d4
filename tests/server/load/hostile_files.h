// Files that are made to harm who reads them.
#pragma once

#include <string>
#include <vector>

namespace tia::test {

/// HostileFile: what it tries, and its bytes.
struct HostileFile {
  std::string law, bytes, type = "application/octet-stream";
};
using HostileFiles = std::vector<HostileFile>;

/// Files of glTF: what they say of their bytes, their nodes, their numbers and their textures.
HostileFiles hostile_gltf();

}  // namespace tia::test
