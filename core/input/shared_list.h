// SharedList: a list that its copies share until one of them is changed (copy on write).
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "core/input/codec.h"

namespace tia {

/// SharedList<T>: as std::vector<T>, but a copy costs nothing however long it is, for most copies
/// of a scene change its light or its camera alone. Reading is const throughout; what changes it
/// first makes it its own. Threads may read copies at once.
template <class T>
class SharedList {
 public:
  using List = std::vector<T>;

  SharedList() = default;
  SharedList(List list) : list_(std::make_shared<List>(std::move(list))) {}
  SharedList(std::initializer_list<T> list) : SharedList(List(list)) {}

  const List& get() const {
    static const List none;
    return list_ ? *list_ : none;
  }
  operator const List&() const { return get(); }
  auto begin() const { return get().begin(); }
  auto end() const { return get().end(); }
  std::size_t size() const { return get().size(); }
  bool empty() const { return get().empty(); }
  const T& operator[](std::size_t i) const { return get()[i]; }
  const T& at(std::size_t i) const { return get().at(i); }
  const T& front() const { return get().front(); }
  const T& back() const { return get().back(); }

  /// Its own list, to change. Cost: O(size) where copies share it.
  List& edit() {
    if (!list_) list_ = std::make_shared<List>();
    else if (list_.use_count() > 1) list_ = std::make_shared<List>(*list_);
    return *list_;
  }
  T& operator[](std::size_t i) { return edit()[i]; }
  T& at(std::size_t i) { return edit().at(i); }
  T& front() { return edit().front(); }
  T& back() { return edit().back(); }
  void clear() { list_.reset(); }
  void assign(std::initializer_list<T> values) { edit().assign(values); }
  template <class Iterator>
  void assign(Iterator first, Iterator last) {
    edit().assign(first, last);
  }
  /// Puts values before one of its own. Cost: as std::vector's.
  void insert(typename List::const_iterator before, std::initializer_list<T> values) {
    insert(before, values.begin(), values.end());
  }
  template <class Iterator>
  void insert(typename List::const_iterator before, Iterator first, Iterator last) {
    const auto at = before - begin();  // its own list may be another one
    List& list = edit();
    list.insert(list.begin() + at, first, last);
  }
  void push_back(T value) { edit().push_back(std::move(value)); }
  template <class... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return edit().emplace_back(std::forward<Arguments>(arguments)...);
  }
  void pop_back() { edit().pop_back(); }

  bool operator==(const SharedList& other) const {
    return list_ == other.list_ || get() == other.get();
  }

 private:
  std::shared_ptr<List> list_;  // null: empty
};

template <class T>
struct Codec<SharedList<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   SharedList<T>& out) {
    read_value(v, at, spec, faults, out.edit());
  }
  static Value write(const SharedList<T>& v) { return write_value(v.get()); }
  static Value schema(const Spec& spec, Definitions& named) {
    return Codec<std::vector<T>>::schema(spec, named);
  }
  static std::string allowed(const Spec& spec) { return Codec<std::vector<T>>::allowed(spec); }
};

}  // namespace tia
