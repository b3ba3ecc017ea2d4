// Short words about bytes, and numbers out of them.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/models/model_files.h"

namespace tia::gltf {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

/// A number from anywhere in memory.
template <class Number>
Number load(const std::uint8_t* from) {
  Number number;
  std::memcpy(&number, from, sizeof number);
  return number;
}

inline std::string_view text_of(ModelBytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The largest integer that each smaller one can be told from in JSON.
inline constexpr std::uint64_t most_integer = std::uint64_t{1} << 53U;

/// "12 bytes".
inline std::string bytes_text(std::uint64_t count) { return std::to_string(count) + " bytes"; }

}  // namespace tia::gltf
