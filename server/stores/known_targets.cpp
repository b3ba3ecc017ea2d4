#include "server/stores/known_targets.h"

#include "server/http/headers.h"

namespace tia::server {
namespace {

constexpr std::size_t entry_bytes = 512;  // an entry's own, with its places in list and table

}  // namespace

std::optional<KnownTarget> KnownTargets::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const KnownTarget* known = targets_.find(name);
  return known == nullptr ? std::nullopt : std::optional(*known);
}

// The names alone are counted: they are what clients make long.
void KnownTargets::keep(const std::string& name, KnownTarget known) {
  LruMap<std::string, KnownTarget>::Entries surplus;
  const std::lock_guard lock(mutex_);
  if (targets_.contains(name)) return;
  targets_.add(name, std::move(known));
  bytes_ += entry_bytes + 2 * name.size();
  while (bytes_ > most_bytes) {
    targets_.take_last(surplus);
    bytes_ -= entry_bytes + 2 * surplus.back().key.size();
  }
}

std::string KnownTargets::name_of(const Request& request) {
  return request.target + '\n' + joined(request, "Accept");
}

}  // namespace tia::server
