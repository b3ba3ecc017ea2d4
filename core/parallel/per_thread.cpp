#include "core/parallel/per_thread.h"

#include <pthread.h>

#include <new>
#include <utility>

namespace tia::detail {
namespace {

void destroy(void* first) {
  std::unique_ptr<Kept> list(static_cast<Kept*>(first));
  while (list) list = std::move(list->next);  // one by one, however many there are
}

/// Key: by which each thread has a list of its own.
struct Key {
  Key() {
    if (pthread_key_create(&key, destroy) != 0) throw std::bad_alloc();
  }
  pthread_key_t key{};
};

}  // namespace

void keep_for_thread(std::unique_ptr<Kept> thing) {
  static const Key mine;
  thing->next.reset(static_cast<Kept*>(pthread_getspecific(mine.key)));
  if (pthread_setspecific(mine.key, thing.get()) != 0) {
    static_cast<void>(thing->next.release());  // which the key still has
    throw std::bad_alloc();
  }
  static_cast<void>(thing.release());
}

}  // namespace tia::detail
