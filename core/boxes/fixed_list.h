// FixedList: a list of a few things that are made where they stand.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace tia {

/// FixedList: up to `most` things, none of which costs anything before it is added.
template <class T, std::size_t most>
class FixedList {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  FixedList() = default;  // the bytes are whatever they are
  FixedList(const FixedList&) = delete;
  FixedList& operator=(const FixedList&) = delete;

  /// Domain: fewer than `most` so far.
  template <class... Args>
  T& add(Args&&... args) {
    return *::new (&bytes_[sizeof(T) * count_++]) T(std::forward<Args>(args)...);
  }
  std::span<T> all() { return {std::launder(reinterpret_cast<T*>(bytes_.data())), count_}; }

 private:
  alignas(T) std::array<std::byte, sizeof(T) * most> bytes_;
  std::size_t count_ = 0;
};

}  // namespace tia
