// The threads of all measurements here.
#pragma once

#include "core/parallel/pool.h"

namespace tia::bench {

/// Two threads, started by the first call.
inline Pool& pool() {
  static Pool two(2);
  return two;
}

}  // namespace tia::bench
