// Models that clients have sent, and those of the gallery: what came, by id, and what was read of
// it. Any thread may call.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "core/models/model_files.h"
#include "server/operation/long_work.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/operation/metrics.h"
#include "server/operation/store_counts.h"
#include "server/stores/model_reader.h"
#include "server/stores/read_models.h"
#include "server/stores/upload_store.h"

namespace tia::server {

class ModelStore {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Now = std::function<Time()>;
  /// A model that a reader has died of is not read again for so long.
  static constexpr std::chrono::hours rest_after_death{1};
  static constexpr std::size_t most_deaths = 1024;  ///< that are remembered

  struct Bounds {
    std::int64_t max_bytes = 0;  ///< of what came, without a folder; and of what was read
    ModelLimits limits;
  };
  struct Surroundings {
    MemoryAccount& memory;
    LongWork& long_work;
    Metrics& metrics;
  };
  ModelStore(
      ModelReader reader, const Bounds& bounds, const Surroundings& surroundings,
      std::unique_ptr<ModelFolder> folder,
      Now now = [] { return std::chrono::steady_clock::now(); });

  /// Kept: a model that is kept now, and whether it was not before.
  struct Kept {
    KnownModel known;
    bool is_new = false;
  };
  /// Where one that is long may go while it comes; null: to memory.
  std::shared_ptr<LongBody> begin() { return uploads_.begin(); }
  /// Keeps one that can be read; the gallery's are kept for good. Errors: as find(), InputError of
  /// its faults, UploadStore::keep.
  Kept keep(const ModelUpload& upload, const Requester& requester);

  /// The files of an archive that is sent; of one that a reader has died of, nothing for an hour.
  /// Domain: in a place of long texts. Errors: ReaderDied; as ModelReader::unpack.
  ModelReader::Unpacked unpack(ModelBytes archive, const ZipLimits& limits,
                               const std::stop_token& stop);

  /// What is in one that is not to be kept, read unless it is in memory. Errors: as keep(), but for
  /// UploadStore's.
  KnownModel look_into(const ModelUpload& upload, const Requester& requester);

  /// Whether one of that id is kept, or one of the gallery is called that. What is damaged is known
  /// only to who reads it.
  bool contains(const std::string& name);
  /// The model of that id, or of that name in the gallery, read again where it is no more in
  /// memory; or null, as for whatever can be neither.
  /// Errors: StorageError of one that is damaged; ReaderDied; as LongWork, ModelReader::read.
  KnownModel find(const std::string& name, const Requester& requester);

  /// What came by that id, packed; null where nothing has. Errors: StorageError.
  std::shared_ptr<const std::string> packed(const std::string& id) { return uploads_.find(id); }

  /// Takes away one that was kept; the gallery's stay. Returns: whether it was there.
  /// Errors: StorageError.
  bool remove(const std::string& id);

  ModelCounts counts() const { return {uploads_.count(), read_.count()}; }
  /// Lets go of what was read and nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes) { return read_.give_way(bytes); }

 private:
  KnownModel find_packed(const std::string& id, std::string_view packed,
                         const Requester& requester);
  KnownModel read(const ModelUpload& upload, const Requester& requester);
  KnownModel read_now(const ModelUpload& upload, const std::stop_token& stop);
  SharedModel model_of(const ModelUpload& upload, const std::stop_token& stop) const;
  void check_rest(const std::string& id);
  void remember_death(const std::string& id);

  const ModelReader reader_;
  const ModelLimits limits_;
  LongWork& long_work_;
  Metrics& metrics_;
  const Now now_;
  UploadStore uploads_;
  ReadModels read_;
  std::mutex mutex_;
  LruMap<std::string, Time> deaths_;  // by id
};

}  // namespace tia::server
