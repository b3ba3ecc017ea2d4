// Backdrop: what a picture has where it shows no object.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/input/codec.h"

namespace tia {

/// Backdrop: a linear colour, or none: the picture is transparent there. In JSON a colour, or
/// "transparent".
struct Backdrop {
  std::optional<Color> color;

  static constexpr std::string_view transparent = "transparent";
  bool is_transparent() const { return !color; }
  bool operator==(const Backdrop&) const = default;
};

template <>
struct Codec<Backdrop> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   Backdrop& out);
  static Value write(const Backdrop& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

}  // namespace tia
