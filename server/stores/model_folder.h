// Models' files on the disk, FOLDER/models/{id}, each whole or not there. Any thread may call, and
// any process of the machine may use the same folder.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"
#include "server/stores/digest.h"
#include "server/stores/unnamed_file.h"

namespace tia::server {

/// SentFile: a body on its way into the folder, hashed as it comes. It is a model's only file, or
/// says what its files are.
class SentFile : public LongBody {
 public:
  SentFile(int folder, DiskRoom& room) : file_(folder, room) {}
  void append(std::string_view bytes) override {
    file_.append(bytes);
    hash_.add(bytes);
  }
  std::size_t size() const override { return file_.size(); }
  /// What has come, as the disk has it. Domain: all has come; once.
  /// Errors: StorageError, also where it is not what has come.
  std::string contents();
  /// Its SHA-256. Domain: contents() has been called.
  const std::string& sha256() const { return sha256_; }
  UnnamedFile& file() { return file_; }

 private:
  UnnamedFile file_;
  Sha256 hash_;
  std::string sha256_;
};

class ModelFolder {
 public:
  /// Makes the folder, if need be, and measures what is in it.
  /// Errors: std::runtime_error where it cannot be made or used.
  ModelFolder(const std::string& data_dir, std::int64_t max_bytes);
  ModelFolder(const ModelFolder&) = delete;
  ModelFolder& operator=(const ModelFolder&) = delete;

  // Of all that follows. Domain: ids as is_model_id() knows them.

  /// Writes a file that has no name before it is whole: what is kept when this returns is there
  /// after any crash, and nothing else is. One that is there already stays.
  /// Errors: HttpError (storage-full) where the disk or max_bytes has no room; StorageError.
  void keep(const std::string& id, const std::vector<std::string_view>& pieces);
  /// The same of one that is written already.
  void keep(const std::string& id, UnnamedFile& file);
  /// A new file. Domain: the folder outlives it.
  std::shared_ptr<SentFile> begin() { return std::make_shared<SentFile>(folder_, room_); }
  bool contains(const std::string& id) const;
  /// The bytes of that name, whatever they are, or nothing. Errors: StorageError.
  std::optional<std::string> find(const std::string& id) const;
  /// Takes it away, if it is there. Errors: StorageError.
  void remove(const std::string& id);

  /// What is there, as far as this process knows; of bytes, with those that are being written.
  std::size_t count() const { return count_; }
  std::int64_t bytes() const { return room_.used(); }

 private:
  void measure();

  std::string path_;
  DiskRoom room_;
  OpenFile folder_;
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace tia::server
