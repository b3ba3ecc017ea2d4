// The options before the names of pictures in MTL files.
#pragma once

#include <array>
#include <string_view>

#include "core/models/mtl_reading.h"

namespace tia {

/// MtlOptions: those that are taken.
struct MtlOptions {
  std::array<double, 2> offset{0, 0}, scale{1, 1};  ///< v upward
  double strength = 1;
  bool clamp = false;
};

/// Reads options, and leaves what follows them. Those that are not taken, but change what is seen,
/// are passed over with a warning. Errors: as faults: options without their numbers.
/// Returns: whether there was no fault.
bool read_mtl_options(std::string_view statement, ObjWords& words, MtlReading& reading,
                      MtlOptions& options);

}  // namespace tia
