#include "core/film/compressor.h"

#include <libdeflate.h>

#include <memory>
#include <new>

#include "core/parallel/per_thread.h"

namespace tia {
namespace {

struct Free {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, Free>;

}  // namespace

libdeflate_compressor& compressor() {
  constexpr int level = 2;
  auto& mine = per_thread<Compressor, struct OfAllPictures>();
  if (!mine) mine.reset(libdeflate_alloc_compressor(level));
  if (!mine) throw std::bad_alloc();
  return *mine;
}

}  // namespace tia
