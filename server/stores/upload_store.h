// What came as models, by id: in a folder that outlives the server, else in bounded memory. Any
// thread may call.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/stores/model_folder.h"
#include "server/stores/model_upload.h"

namespace tia::server {

class UploadStore {
 public:
  /// Without a folder it holds so many bytes of memory at most, and books them.
  UploadStore(std::int64_t max_bytes, MemoryAccount& account, std::unique_ptr<ModelFolder> folder)
      : max_bytes_(static_cast<std::size_t>(max_bytes)),
        share_(max_bytes, &account, MemoryAccount::models),
        folder_(std::move(folder)) {}

  /// Where one that is long may go while it comes; null where there is no folder.
  std::shared_ptr<LongBody> begin() { return folder_ ? folder_->begin() : nullptr; }
  /// Keeps one, in memory in place of those that nobody has asked for longest. What is damaged in
  /// the folder is written anew.
  /// Errors: InputError (limit) for one that does not fit into memory alone; as ModelFolder::keep.
  void keep(const ModelUpload& upload);
  /// Whether there is one, which is the one last asked for from now on.
  bool contains(const std::string& id);
  /// The bytes of ModelUpload::packed(), one after the other; null where there are none.
  /// Errors: as ModelFolder::find.
  std::shared_ptr<const std::string> find(const std::string& id);

  /// Takes it away. Returns: whether it was there. Errors: as ModelFolder::remove.
  bool remove(const std::string& id);

  std::size_t count() const;

 private:
  void keep_in_memory(const ModelUpload& upload);
  void keep_in_folder(const ModelUpload& upload);

  using Uploads = LruMap<std::string, std::shared_ptr<const std::string>>;
  const std::size_t max_bytes_;
  MemoryShare share_;
  const std::unique_ptr<ModelFolder> folder_;  // null: they are in memory
  mutable std::mutex mutex_;
  Uploads uploads_;
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
