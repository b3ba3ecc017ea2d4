// Files of models as texts, and what was read of them.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/models/model_files.h"

namespace tia::test {

/// A view of a text that must live on.
inline ModelBytes file_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline ModelBytes bytes_of(std::string_view text) { return file_bytes(text); }
inline std::string_view text_of_file(ModelBytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace tia::test
