// malloc and its kin in place of the C library's, as its manual allows ("Replacing malloc"), and
// operator new on top of them, which else a sanitizer would bring.
#include "tests/memory/scarce_memory.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <new>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
// The sanitizers', where the program has one.
void* __interceptor_malloc(std::size_t) __attribute__((weak));
void* __interceptor_calloc(std::size_t, std::size_t) __attribute__((weak));
void* __interceptor_realloc(void*, std::size_t) __attribute__((weak));
void* __interceptor_memalign(std::size_t, std::size_t) __attribute__((weak));
void __interceptor_free(void*) __attribute__((weak));
}

namespace {

constexpr long never = std::numeric_limits<long>::max();
std::atomic<long> asked = 0, first = never, last = never, live = 0, bytes = 0, peak = 0;

bool is_short() {
  const long n = ++asked;
  if (n < first || n > last) return false;
  errno = ENOMEM;
  return true;
}

// Before that a sanitizer that is not ready itself must not be asked how large a piece is.
std::atomic<bool> begun = false;
__attribute__((constructor)) void begin() { begun = true; }

// What a piece takes: the C library puts its size before it.
long bytes_of(void* piece) {
  if (!begun) return 0;
  return static_cast<long>(malloc_usable_size(piece) + sizeof(std::size_t));
}

void add_bytes(void* piece) {
  const long now = bytes += bytes_of(piece);
  for (long most = peak; most < now && !peak.compare_exchange_weak(most, now);) continue;
}

void* counted(void* piece) {
  if (piece == nullptr) return nullptr;
  ++live;
  add_bytes(piece);
  return piece;
}

}  // namespace

namespace tia::test {

void run_out_of_memory(long n, Shortage shortage) {
  asked = 0;
  last = shortage == Shortage::once ? n : never;
  first = n;
}

bool end_shortage() {
  const long from = first.exchange(never);
  return asked >= from;
}

long allocations() { return asked; }
long live_pieces() { return live; }
long live_bytes() { return bytes; }
long take_peak_bytes() { return peak.exchange(bytes); }

}  // namespace tia::test

// ---- the C library's ------------------------------------------------------------------------

extern "C" {

void* malloc(std::size_t size) noexcept {
  if (is_short()) return nullptr;
  return counted(__interceptor_malloc != nullptr ? __interceptor_malloc(size)
                                                 : __libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  if (is_short()) return nullptr;
  return counted(__interceptor_calloc != nullptr ? __interceptor_calloc(count, size)
                                                 : __libc_calloc(count, size));
}

void* realloc(void* piece, std::size_t size) noexcept {
  if (piece == nullptr) return malloc(size);
  if (is_short()) return nullptr;
  const long before = bytes_of(piece);
  void* const moved = __interceptor_realloc != nullptr ? __interceptor_realloc(piece, size)
                                                       : __libc_realloc(piece, size);
  if (moved == nullptr && size == 0) --live;  // it was freed
  if (moved != nullptr || size == 0) bytes -= before;
  if (moved != nullptr) add_bytes(moved);
  return moved;
}

void* memalign(std::size_t unit, std::size_t size) noexcept {
  if (is_short()) return nullptr;
  return counted(__interceptor_memalign != nullptr ? __interceptor_memalign(unit, size)
                                                   : __libc_memalign(unit, size));
}

void* aligned_alloc(std::size_t unit, std::size_t size) noexcept { return memalign(unit, size); }

int posix_memalign(void** piece, std::size_t unit, std::size_t size) noexcept {
  *piece = memalign(unit, size);
  return *piece == nullptr ? ENOMEM : 0;
}

void free(void* piece) noexcept {
  if (piece == nullptr) return;
  --live;
  bytes -= bytes_of(piece);
  if (__interceptor_free != nullptr) __interceptor_free(piece);
  else __libc_free(piece);
}

}  // extern "C"

// ---- C++'s ----------------------------------------------------------------------------------

namespace {

void* given(void* piece) {
  if (piece == nullptr) throw std::bad_alloc();
  return piece;
}
std::size_t unit_of(std::align_val_t unit) { return static_cast<std::size_t>(unit); }

}  // namespace

void* operator new(std::size_t size) { return given(std::malloc(size)); }
void* operator new[](std::size_t size) { return given(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t unit) {
  return given(memalign(unit_of(unit), size));
}
void* operator new[](std::size_t size, std::align_val_t unit) {
  return given(memalign(unit_of(unit), size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void operator delete(void* piece) noexcept { std::free(piece); }
void operator delete[](void* piece) noexcept { std::free(piece); }
void operator delete(void* piece, std::size_t) noexcept { std::free(piece); }
void operator delete[](void* piece, std::size_t) noexcept { std::free(piece); }
void operator delete(void* piece, std::align_val_t) noexcept { std::free(piece); }
void operator delete[](void* piece, std::align_val_t) noexcept { std::free(piece); }
void operator delete(void* piece, std::size_t, std::align_val_t) noexcept { std::free(piece); }
void operator delete[](void* piece, std::size_t, std::align_val_t) noexcept { std::free(piece); }
void operator delete(void* piece, const std::nothrow_t&) noexcept { std::free(piece); }
void operator delete[](void* piece, const std::nothrow_t&) noexcept { std::free(piece); }
