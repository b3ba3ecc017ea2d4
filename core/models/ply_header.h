// The header of a PLY file: which elements come, of which properties, in which encoding.
// Source: Turk, The PLY Polygon File Format (1994).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/errors.h"

namespace tia {

/// PlyType: how a number is kept.
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::float64: return 8;
    default: return 4;
  }
}
constexpr bool is_whole(PlyType type) { return type < PlyType::float32; }

/// PlyProperty: a number of each row of an element, or a list of numbers.
struct PlyProperty {
  std::string_view name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  ///< how a list's count is kept, which comes before its numbers
};

/// PlyElement: rows of the same properties.
struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::size_t line = 0;
  std::vector<PlyProperty> properties;
};

/// A fault at an element's line.
inline Fault ply_fault(FaultKind kind, const PlyElement& element, std::optional<Value> got,
                       std::string allowed) {
  return {kind, "", std::move(got), std::move(allowed), "", std::nullopt, element.line};
}

/// PlyTexture: a picture that a comment names.
struct PlyTexture {
  std::string_view name;
  std::size_t line = 0;
};

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

/// PlyHeader: it refers to the file's text.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  static constexpr std::size_t most_textures = 20;
  std::vector<PlyTexture> textures;  ///< the first 20
  char line_end = '\n';              ///< CR where that alone ends the first line
  std::size_t lines = 0;
  std::string_view body;  ///< what follows the header
};

/// Whether a file begins with the line `ply`.
bool begins_ply(std::string_view file);

/// Returns: the header; none where it has a fault. The body has the fewest bytes that so many rows
/// can take.
/// Errors: `malformed`, `missing` and `limit`, as faults with their lines.
std::optional<PlyHeader> read_ply_header(std::string_view file, Faults& faults);

}  // namespace tia
