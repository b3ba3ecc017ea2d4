// What came as a model, by its id, and packed into one text as it is kept.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/models/model_files.h"

namespace tia::server {

class UnnamedFile;

/// Whether a text could be an id: 64 hexadecimal digits, small ones.
bool is_model_id(std::string_view text);

/// ModelUpload: a file, or several that came together, and their name. The bytes are elsewhere.
struct ModelUpload {
  ModelFiles files;
  /// SHA-256 of the only file, else of bundle_text() of all.
  std::string id;
  /// What stands before the files' bytes where they are kept: of several their bundle_text() and
  /// how long each is, a line of JSON each; of one nothing.
  std::string head;
  /// Holds packed() already; or null.
  UnnamedFile* in_file = nullptr;

  std::size_t bytes() const;
  /// What is kept, piece by piece.
  std::vector<std::string_view> packed() const;
};

/// The files in the order of their bundle_text(), named. Cost: reads all bytes.
/// Domain: each path once, without the lone folder. `known_sha256`: of the only file, where
/// somebody has read it already.
ModelUpload upload_of(ModelFiles files, std::string known_sha256 = "");

/// The files in what was kept by that id, as views into it. Returns: nothing where it is damaged:
/// the hash of each file is looked at. Cost: reads all bytes.
std::optional<ModelUpload> unpacked_upload(const std::string& id, std::string_view packed);

}  // namespace tia::server
