// What a model is read from: files by their names, and how much of them is read.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tia {

using ModelBytes = std::span<const std::uint8_t>;

/// ModelFile. Domain: a path with '/' between its parts, none of them empty, `.` or `..`.
struct ModelFile {
  std::string path;
  ModelBytes bytes;
};

/// ModelFiles: a file, and those that it may name.
struct ModelFiles {
  std::vector<ModelFile> all;
  std::size_t main = 0;

  const ModelFile& main_file() const { return all[main]; }
  /// The file that a path means in a file of that path, or null: relative to the folder of that
  /// file, `.` and `..` resolved; none that leads out of what came, or begins with '/'.
  const ModelFile* find(std::string_view path, std::string_view from) const;
};

/// ModelLimits: the most that is read of a model.
struct ModelLimits {
  std::uint64_t triangles = 8'388'608;
  std::uint64_t vertices = 3 * std::uint64_t{8'388'608};
  std::uint64_t nodes = 65'536, depth = 256, instances = 1 << 20;
  std::uint64_t polygon_corners = 4096;
  std::size_t json_values = 1'000'000;
  std::uint64_t texture_pixels = 100'663'296, texture_side = 16'384;
};

}  // namespace tia
