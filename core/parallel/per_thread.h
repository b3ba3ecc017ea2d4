// What a thread keeps for itself from one call to the next.
#pragma once

#include <memory>
#include <utility>

namespace tia {
namespace detail {

/// Kept: one of the things that a thread keeps.
struct Kept {
  Kept() = default;
  virtual ~Kept() = default;
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;
  std::unique_ptr<Kept> next;
};

/// Keeps it until the calling thread ends. Errors: std::bad_alloc.
void keep_for_thread(std::unique_ptr<Kept> thing);

}  // namespace detail

/// The calling thread's own T for that use (any type's name): made when the thread first asks,
/// destroyed when it ends.
///
/// As a thread_local with a destructor, but for this: the first use of such a one has to take down
/// the destructor, and where there is no memory for that the C library ends the program ("failed to
/// register TLS destructor"). This throws.
/// Errors: std::bad_alloc; what making a T throws.
template <class T, class Use>
T& per_thread() {
  struct Own : detail::Kept {
    T value{};
  };
  thread_local T* own = nullptr;
  if (own == nullptr) {
    auto made = std::make_unique<Own>();
    T* const value = &made->value;
    detail::keep_for_thread(std::move(made));
    own = value;
  }
  return *own;
}

}  // namespace tia
