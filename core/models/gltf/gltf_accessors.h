// Accessors: how the elements of a list lie in a glTF document's bytes, and the rules that their
// readers have for them.
#pragma once

#include <optional>

#include "core/models/gltf/gltf_parts.h"
#include "core/models/gltf/gltf_view.h"

namespace tia::gltf {

enum class Component : std::uint8_t {
  signed_byte,
  unsigned_byte,
  signed_short,
  unsigned_short,
  unsigned_int,
  floating
};
constexpr std::size_t size_of(Component component) {
  constexpr std::array<std::size_t, 6> sizes{1, 1, 2, 2, 4, 4};
  return sizes[static_cast<std::size_t>(component)];
}

/// Sets of formats: a component type, and whether it is normalised.
using Formats = std::uint16_t;
constexpr Formats format(Component component, bool normalized = false) {
  return static_cast<Formats>(1U << (static_cast<unsigned>(component) * 2 + (normalized ? 1 : 0)));
}

enum class ElementType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };
/// Sets of types.
using ElementTypes = std::uint8_t;
constexpr ElementTypes only(ElementType type) {
  return static_cast<ElementTypes>(1U << static_cast<unsigned>(type));
}

/// ElementLayout: how an element lies in bytes. A vector is one column; the columns of a matrix
/// begin at multiples of four bytes.
/// Source: Khronos, glTF 2.0 (2021), section 3.6.2.4.
struct ElementLayout {
  Component component = Component::floating;
  bool normalized = false;
  std::size_t rows = 1, columns = 1;

  std::size_t numbers() const { return rows * columns; }
  std::size_t column_bytes() const { return rows * size_of(component); }
  std::size_t column_stride() const {
    return columns == 1 ? column_bytes() : (column_bytes() + 3) / 4 * 4;
  }
  /// From one element to the next where nothing else is said.
  std::size_t stride() const { return columns * column_stride(); }
  /// What must be there of the last one.
  std::size_t bytes() const { return (columns - 1) * column_stride() + column_bytes(); }
};

/// SparseElements: those that differ from what the accessor's view has.
struct SparseElements {
  std::uint64_t count = 0;
  Component component = Component::unsigned_int;  ///< of the indices
  ModelBytes indices, values;                     ///< as many as are needed
};

/// Accessor. Without bytes its elements are zeros.
struct Accessor {
  bool good = false;   ///< else a fault says why not, and nothing else here means anything
  ModelIndex index{};  ///< its place in the document's list
  ElementType type = ElementType::scalar;
  ElementLayout layout;
  std::uint64_t count = 0;
  std::size_t stride = 0;
  bool strided = false;  ///< whether its view names a stride
  bool in_fours = true;  ///< whether it is aligned as a vertex attribute has to be
  ModelBytes bytes;      ///< from its first element on, as many as are needed, or none
  std::optional<SparseElements> sparse;
};

/// Errors: faults of accessors that are not all in their views: /accessors/3, /accessors/3/count.
/// Cost: linear in their number; no element is looked at.
std::vector<Accessor> read_accessors(const GltfObject& root, const std::vector<GltfView>& views,
                                     const ModelLimits& limits);

/// AccessorRule: what an accessor may be in a use.
struct AccessorRule {
  ElementTypes types = 0;
  Formats formats = 0;
};
bool fits(const Accessor& accessor, const AccessorRule& rule);
/// "VEC3 of FLOAT".
std::string words(const AccessorRule& rule);
std::string words(const Accessor& accessor);

}  // namespace tia::gltf
