// Pure checks of what a picture may cost, before anything is traced.
#pragma once

#include <cstdint>

#include "core/input/errors.h"

namespace tia {

/// Limits: what one request may ask for.
struct Limits {
  std::int64_t max_pixels = 16'777'216;  ///< pixels of the whole picture
};

/// Errors: InputError of one `limit` fault that names the limit and the option that sets it.
void check_size(int width, int height, const Limits& limits);

}  // namespace tia
