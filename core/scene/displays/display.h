// THE LIST of displays: what more than one view of a scene is made for. A new one is a file beside
// this one and one entry here. It has `type`, `fields`, `needs`, perhaps `check`, and `grid`, its
// views; where it has a plane that stays where it is, `focus` and `focus_field`.
#pragma once

#include <string_view>
#include <variant>

#include "core/scene/displays/cube.h"
#include "core/scene/displays/modules.h"
#include "core/scene/displays/omnistereo.h"
#include "core/scene/displays/quilt.h"
#include "core/scene/displays/stereo.h"
#include "core/scene/displays/two_plane.h"

namespace tia {

template <class Kind>
concept IsDisplay = requires(const Kind& kind, const DisplayFrame& frame) {
  { Kind::type } -> std::convertible_to<std::string_view>;
  { Kind::needs } -> std::convertible_to<DisplayNeeds>;
  { kind.grid(frame) } -> std::same_as<ViewGrid>;
};
template <IsDisplay Kind>
using ListedDisplay = Kind;
template <class... Kinds>
using DisplayList = std::variant<ListedDisplay<Kinds>...>;

struct Display {
  static constexpr std::string_view schema_name = "display";
  using Kinds = DisplayList<Cube, Stereo, Omnistereo, Quilt, Modules, TwoPlane>;
  Kinds kind;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Display::kind, Spec{.about = "the kind of display", .required = true});
  }
  bool operator==(const Display&) const = default;

  std::string_view type() const {
    return std::visit([](const auto& of) { return std::remove_cvref_t<decltype(of)>::type; }, kind);
  }
  DisplayNeeds needs() const {
    return std::visit([](const auto& of) { return std::remove_cvref_t<decltype(of)>::needs; },
                      kind);
  }
  /// Whether its views are squares, whatever their pixels' number.
  bool is_square() const {
    return std::visit(
        [](const auto& of) {
          return requires { of.square; };
        },
        kind);
  }
  /// The field of the distance that it takes from look_at where it is not given; null: none.
  const char* missing_focus() const {
    return std::visit(
        [](const auto& of) -> const char* {
          if constexpr (requires { of.focus(); }) return of.focus() ? nullptr : of.focus_field;
          else return nullptr;
        },
        kind);
  }
  const Quilt* quilt() const { return std::get_if<Quilt>(&kind); }
};

}  // namespace tia
