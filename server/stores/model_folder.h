// Models' files on the disk, FOLDER/models/{id}, each whole or not there. Any thread may call, and
// any process of the machine may use the same folder.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tia::server {

class ModelFolder {
 public:
  /// Makes the folder, if need be, and measures what is in it.
  /// Errors: std::runtime_error where it cannot be made or used.
  ModelFolder(const std::string& data_dir, std::int64_t max_bytes);
  ~ModelFolder();
  ModelFolder(const ModelFolder&) = delete;
  ModelFolder& operator=(const ModelFolder&) = delete;

  // Of all that follows. Domain: ids as is_model_id() knows them.

  /// Writes a file that has no name before it is whole: what is kept when this returns is there
  /// after any crash, and nothing else is. One that is there already stays.
  /// Errors: HttpError (storage-full) where the disk or max_bytes has no room; StorageError.
  void keep(const std::string& id, const std::vector<std::string_view>& pieces);
  bool contains(const std::string& id) const;
  /// The bytes of that name, whatever they are, or nothing. Errors: StorageError.
  std::optional<std::string> find(const std::string& id) const;
  /// Takes it away, if it is there. Errors: StorageError.
  void remove(const std::string& id);

  /// What is there, as far as this process knows.
  std::size_t count() const { return count_; }
  std::int64_t bytes() const { return bytes_; }

 private:
  void measure();

  std::string path_;
  const std::int64_t max_bytes_;
  int folder_ = -1;
  std::atomic<std::int64_t> bytes_ = 0;
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace tia::server
