// Finish: the slides' and POV-Ray's surface words.
#pragma once

#include <optional>
#include <string_view>

#include "core/materials/texture.h"

namespace tia {

/// Finish: what a surface does with light: diffuse * color * light * max(0, n.l), plus emission.
struct Finish {
  static constexpr std::string_view type = "finish";
  Color color{1, 1, 1};
  double diffuse = 1;
  Color emission{};
  std::optional<Texture> texture = {};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("color", &Finish::color, Spec{.about = "the surface's linear RGB", .max = 1e6});
    visit("diffuse", &Finish::diffuse,
          Spec{.about = "share of the light that is scattered", .min = 0, .max = 1});
    visit("emission", &Finish::emission,
          Spec{.about = "light of its own; a luminous sphere is a light too", .max = 1e6});
    visit("texture", &Finish::texture,
          Spec{.about = "colours from place to place; replaces color"});
  }
  bool operator==(const Finish&) const = default;
};

}  // namespace tia
