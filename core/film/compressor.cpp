#include "core/film/compressor.h"

#include <libdeflate.h>

#include <memory>

namespace tia {

libdeflate_compressor* compressor() {
  struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
  };
  constexpr int level = 2;
  thread_local const std::unique_ptr<libdeflate_compressor, Free> mine(
      libdeflate_alloc_compressor(level));
  return mine.get();
}

}  // namespace tia
