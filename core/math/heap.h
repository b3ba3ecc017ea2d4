// How much memory a value owns on the heap: heap_bytes(value), one function a type that owns any.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace tia {

/// What the allocator adds to each piece. Space/units: bytes.
inline constexpr std::size_t heap_block = 16;

/// A type that owns nothing.
template <class T>
concept IsPlain = std::is_trivially_copyable_v<T>;

template <IsPlain T>
std::size_t heap_bytes(const T&) {
  return 0;
}
/// Of the list itself, not of what its elements own.
template <class T>
std::size_t heap_bytes(const std::vector<T>& list) {
  return list.capacity() > 0 ? heap_block + list.capacity() * sizeof(T) : 0;
}

/// A form tells what it owns, so that what is kept can be bounded.
template <class T>
concept TellsHeap = requires(const T& value) {
  { heap_bytes(value) } -> std::same_as<std::size_t>;
};

}  // namespace tia
