// Values by key, in the order in which they were last asked for: what stores that are bounded keep,
// and what they let go of first. It takes no lock and knows no bound: both are the store's.
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <list>
#include <unordered_map>
#include <utility>

#include "server/operation/memory_account.h"

namespace tia::server {

template <class Key, class Value, class Hash = std::hash<Key>>
class LruMap {
 public:
  struct Entry {
    Key key;
    Value value;
  };
  /// Entries: what has been taken out, for the caller to destroy when no lock is held. It was the
  /// store's: its end gives nothing back to the claim of who happens to push it out.
  struct Entries : std::list<Entry> {
    Entries() = default;
    Entries(Entries&&) noexcept = default;
    Entries& operator=(Entries&&) noexcept = default;
    ~Entries() {
      const ClaimScope nobodys(nullptr);
      this->clear();
    }
  };

  bool contains(const Key& key) const { return table_.contains(key); }
  std::size_t size() const { return entries_.size(); }

  /// The value of that key, which is the one last asked for from now on; or null.
  Value* find(const Key& key) {
    const auto known = table_.find(key);
    if (known == table_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, known->second);
    return &known->second->value;
  }
  /// Adds one as the one last asked for. Domain: a key that it does not contain.
  /// Errors: std::bad_alloc, which leaves all as it was.
  void add(Key key, Value value) {
    Entries one;
    one.push_back({std::move(key), std::move(value)});
    table_.emplace(one.front().key, one.begin());
    entries_.splice(entries_.begin(), one);
  }
  /// Takes that one out, if it contains it. Returns: whether it did.
  bool take(const Key& key, Entries& into) {
    const auto known = table_.find(key);
    if (known == table_.end()) return false;
    into.splice(into.end(), entries_, known->second);
    table_.erase(known);
    return true;
  }
  /// The key of the one that nobody has asked for longest among those of which `is` holds; null
  /// where there is none. Cost: O(size).
  template <class Is>
  const Key* last_of(const Is& is) const {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
      if (is(entry->value)) return &entry->key;
    return nullptr;
  }
  /// The one that nobody has asked for longest. Domain: there is one.
  const Value& last() const { return entries_.back().value; }
  const Key& last_key() const { return entries_.back().key; }
  /// Takes it out.
  void take_last(Entries& into) {
    table_.erase(entries_.back().key);
    into.splice(into.end(), entries_, std::prev(entries_.end()));
  }

 private:
  Entries entries_;
  std::unordered_map<Key, typename Entries::iterator, Hash> table_;
};

}  // namespace tia::server
