// malloc and its kin in place of the C library's, as its manual allows ("Replacing malloc"): what a
// request allocates, by whichever library, is charged to its claim, and fails where the account has
// no more. Linked into the program alone; other C libraries and sanitizers have allocators of their
// own, under which claims only grow by what is reserved.
#include <cerrno>
#include <cstddef>

#if defined(__GLIBC__)

#include <dlfcn.h>
#include <malloc.h>

#include "server/operation/memory_account.h"

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

using tia::server::MemoryClaim;

// What comes next: the C library's, or that of a library that was loaded before it. Until it is
// looked up, which may itself allocate, the C library's.
struct Next {
  void* (*malloc)(std::size_t) = __libc_malloc;
  void* (*calloc)(std::size_t, std::size_t) = __libc_calloc;
  void* (*realloc)(void*, std::size_t) = __libc_realloc;
  void* (*memalign)(std::size_t, std::size_t) = __libc_memalign;
  void (*free)(void*) = __libc_free;
};
constinit Next next;

template <class Function>
Function looked_up(const char* name, Function usual) {
  void* const found = dlsym(RTLD_NEXT, name);
  return found == nullptr ? usual : reinterpret_cast<Function>(found);
}

__attribute__((constructor)) void look_up() {
  next = {looked_up("malloc", next.malloc), looked_up("calloc", next.calloc),
          looked_up("realloc", next.realloc), looked_up("memalign", next.memalign),
          looked_up("free", next.free)};
}

std::int64_t size_of(void* piece) {
  return piece == nullptr ? 0 : static_cast<std::int64_t>(malloc_usable_size(piece));
}

// Whether the claim may have that much more, before it is known how much it really takes.
bool admits(MemoryClaim* claim, std::size_t size) {
  if (claim == nullptr || claim->charge(static_cast<std::int64_t>(size))) return true;
  errno = ENOMEM;
  return false;
}

// Books a piece as large as it is, where so many bytes have been charged for it.
void* booked(MemoryClaim* claim, std::size_t charged, void* piece) {
  if (claim != nullptr) claim->discharge(static_cast<std::int64_t>(charged) - size_of(piece));
  return piece;
}

template <class Allocate>
void* counted(std::size_t size, const Allocate& allocate) {
  MemoryClaim* const claim = MemoryClaim::current();
  return admits(claim, size) ? booked(claim, size, allocate()) : nullptr;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
  return counted(size, [&] { return next.malloc(size); });
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  std::size_t all = 0;
  if (__builtin_mul_overflow(count, size, &all)) return errno = ENOMEM, nullptr;
  return counted(all, [&] { return next.calloc(count, size); });
}

void* realloc(void* piece, std::size_t size) noexcept {
  MemoryClaim* const claim = MemoryClaim::current();
  const std::int64_t before = size_of(piece);
  if (!admits(claim, size)) return nullptr;
  void* const moved = booked(claim, size, next.realloc(piece, size));
  if (claim != nullptr && (moved != nullptr || size == 0)) claim->discharge(before);
  return moved;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return counted(size, [&] { return next.memalign(alignment, size); });
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

int posix_memalign(void** to, std::size_t alignment, std::size_t size) noexcept {
  const int before = errno;
  void* const piece = memalign(alignment, size);
  errno = before;
  if (piece == nullptr) return ENOMEM;
  *to = piece;
  return 0;
}

void free(void* piece) noexcept {
  if (MemoryClaim* const claim = MemoryClaim::current()) claim->discharge(size_of(piece));
  next.free(piece);
}

}  // extern "C"

#endif
