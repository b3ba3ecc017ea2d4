// What was read of models, by id, in bounded memory: a cache. Any thread may call.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include "core/models/kept_model.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"

namespace tia::server {

/// KnownModel: a model with what is told of it.
struct KnownModel {
  SharedModel model;
  std::shared_ptr<const std::string> text;  ///< its description, JSON
  explicit operator bool() const { return model != nullptr; }
};

/// What it holds in memory, in bytes, with the mip pyramids and tangents that it makes when it is
/// drawn.
std::size_t bytes_of(const KeptModel& model);

class ReadModels {
 public:
  ReadModels(std::int64_t max_bytes, MemoryAccount& account)
      : share_(max_bytes, &account, MemoryAccount::read_models) {}

  /// The model of that id, which is the one last asked for from now on; or null.
  KnownModel find(const std::string& id);
  /// Adds one, in place of those that nobody has asked for longest; unless it does not fit alone.
  void add(const std::string& id, const KnownModel& known);
  /// Lets go of that one, if it is there.
  void remove(const std::string& id);
  /// Lets go of those that nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes);

  std::size_t count() const;
  std::size_t bytes() const;

 private:
  struct Entry {
    KnownModel known;
    std::size_t bytes = 0;
  };
  using Models = LruMap<std::string, Entry>;
  Models::Entries take_surplus(std::size_t most);

  MemoryShare share_;
  mutable std::mutex mutex_;
  Models models_;
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
