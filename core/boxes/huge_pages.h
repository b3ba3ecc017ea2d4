// HugePages: memory for large lists that are accessed in random order.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "core/math/heap.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace tia {

/// HugePages: an allocator that asks the system for pages of 2 MiB where a list has several of
/// them: one entry of the processor's table of pages then covers 512 times as much. Measured on a
/// million triangles: nodes and leaves 5 to 8 % of a ray, other lists 3 to 6 %, and most of the
/// cost of touching new memory.
template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;

  HugePages() = default;
  template <class Other>
  HugePages(const HugePages<Other>&) {}

  /// Space/units: bytes; what a list of that capacity holds.
  static constexpr std::size_t bytes_for(std::size_t count) {
    const std::size_t unit = unit_for(count);
    return (count * sizeof(T) + unit - 1) / unit * unit;
  }

  T* allocate(std::size_t count) {
    const std::size_t bytes = bytes_for(count);
    void* const memory = std::aligned_alloc(unit_for(count), bytes);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    if (unit_for(count) == page)
      ::madvise(memory, bytes, MADV_HUGEPAGE);  // as good without, where it is refused
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  bool operator==(const HugePages&) const = default;

 private:
  // Of what it asks for a multiple, as std::aligned_alloc wants it: and by what it aligns.
  static constexpr std::size_t unit_for(std::size_t count) {
    if (count * sizeof(T) >= 2 * page) return page;
    return alignof(T) > 32 ? alignof(T) : 32;
  }
};

/// HugeVector: a list that rays access in random order.
template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

template <class T>
std::size_t heap_bytes(const HugeVector<T>& list) {
  return list.capacity() > 0 ? heap_block + HugePages<T>::bytes_for(list.capacity()) : 0;
}

}  // namespace tia
