// Long lists of numbers, as meshes have them: in JSON a flat array or typed bytes in base64.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/input/codec.h"
#include "core/input/shared_list.h"

namespace tia {

/// Numbers: a list of T, which is float or std::uint32_t. In JSON an array of numbers, or the
/// little-endian bytes of the T in base64: {"float32": "…"}, {"uint32": "…"}. It is always written
/// as the array, so that equal lists have equal text. Float lists keep double, which holds the
/// numbers of both spellings exactly. Copies share the list until one of them changes it.
template <class T>
struct Numbers {
  using Number = std::conditional_t<std::is_floating_point_v<T>, double, T>;
  SharedList<Number> values;
  bool operator==(const Numbers&) const = default;
};

/// The range and the fewest items hold for both spellings.
template <class T>
struct Codec<Numbers<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   Numbers<T>& out);
  static Value write(const Numbers<T>& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};
extern template struct Codec<Numbers<float>>;
extern template struct Codec<Numbers<std::uint32_t>>;

}  // namespace tia
