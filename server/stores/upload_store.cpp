#include "server/stores/upload_store.h"

#include "core/input/errors.h"

namespace tia::server {
namespace {

constexpr std::size_t upload_entry_bytes =
    512;  // an entry's own, with its places in list and table

}  // namespace

void UploadStore::keep(const ModelUpload& upload) {
  if (folder_) keep_in_folder(upload);
  else keep_in_memory(upload);
}

void UploadStore::keep_in_folder(const ModelUpload& upload) {
  const auto there = folder_->find(upload.id);
  if (there && !unpacked_upload(upload.id, *there)) folder_->remove(upload.id);
  if (upload.in_file != nullptr) folder_->keep(upload.id, *upload.in_file);
  else folder_->keep(upload.id, upload.packed());
}

void UploadStore::keep_in_memory(const ModelUpload& upload) {
  if (find(upload.id)) return;
  const std::size_t bytes = upload_entry_bytes + upload.head.size() + upload.bytes();
  if (bytes > max_bytes_)
    throw InputError({FaultKind::limit, "", Value("a model of " + std::to_string(bytes) + " bytes"),
                      "kept models of " + std::to_string(max_bytes_) +
                          " bytes in all (option TIA_MAX_MODELS_BYTES)"});
  std::string packed;
  packed.reserve(bytes - upload_entry_bytes);
  for (const std::string_view piece : upload.packed()) packed += piece;
  auto shared = std::make_shared<const std::string>(std::move(packed));
  Uploads::Entries surplus;
  const std::lock_guard lock(mutex_);
  if (uploads_.contains(upload.id)) return;  // somebody has kept the same meanwhile
  uploads_.add(upload.id, std::move(shared));
  bytes_ += bytes;
  while (bytes_ > max_bytes_) {
    bytes_ -= upload_entry_bytes + uploads_.last()->size();
    uploads_.take_last(surplus);
  }
  share_.book(bytes_);
}

bool UploadStore::contains(const std::string& id) {
  if (!is_model_id(id)) return false;
  if (folder_) return folder_->contains(id);
  const std::lock_guard lock(mutex_);
  return uploads_.find(id) != nullptr;
}

std::shared_ptr<const std::string> UploadStore::find(const std::string& id) {
  if (!is_model_id(id)) return nullptr;
  if (folder_) {
    auto packed = folder_->find(id);
    return packed ? std::make_shared<const std::string>(std::move(*packed)) : nullptr;
  }
  const std::lock_guard lock(mutex_);
  const auto* const known = uploads_.find(id);
  return known == nullptr ? nullptr : *known;
}

bool UploadStore::remove(const std::string& id) {
  if (!contains(id)) return false;
  if (folder_) {
    folder_->remove(id);
    return true;
  }
  Uploads::Entries taken;
  const std::lock_guard lock(mutex_);
  if (!uploads_.take(id, taken)) return false;
  bytes_ -= upload_entry_bytes + taken.front().value->size();
  share_.book(bytes_);
  return true;
}

std::size_t UploadStore::count() const {
  if (folder_) return folder_->count();
  const std::lock_guard lock(mutex_);
  return uploads_.size();
}

}  // namespace tia::server
