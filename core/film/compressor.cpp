#include "core/film/compressor.h"

#include <libdeflate.h>

#include <array>
#include <cstddef>
#include <mutex>
#include <new>
#include <utility>

namespace tia {
namespace {

/// Shelf: those that nobody has at present.
class Shelf {
 public:
  ~Shelf() {
    while (libdeflate_compressor* kept = take()) libdeflate_free_compressor(kept);
  }
  // Returns: null where there is none.
  libdeflate_compressor* take() {
    const std::lock_guard lock(mutex_);
    return count_ > 0 ? kept_[--count_] : nullptr;
  }
  void give_back(libdeflate_compressor* one) {
    {
      const std::lock_guard lock(mutex_);
      if (count_ < kept_.size()) kept_[count_++] = std::exchange(one, nullptr);
    }
    libdeflate_free_compressor(one);
  }

 private:
  std::mutex mutex_;
  std::array<libdeflate_compressor*, 16> kept_{};
  std::size_t count_ = 0;
};

Shelf& shelf() {
  static Shelf all;
  return all;
}

}  // namespace

Compressor::Compressor() : lent_(shelf().take()) {
  constexpr int level = 2;
  if (lent_ == nullptr) lent_ = libdeflate_alloc_compressor(level);
  if (lent_ == nullptr) throw std::bad_alloc();
}

Compressor::~Compressor() { shelf().give_back(lent_); }

}  // namespace tia
