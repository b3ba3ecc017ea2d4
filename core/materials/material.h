// THE LIST of materials. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/input/boxed.h"
#include "core/input/kinds.h"
#include "core/materials/finish.h"
#include "core/materials/principled.h"
#include "core/materials/radio_material.h"

namespace tia {

/// What a kind must bring:
///   shading_of  its shading parameters, for ambient light of that linear RGB
///   texture_of  its texture, null if it has none
template <class Kind>
concept IsMaterial = IsKind<Kind> && requires(const Kind& kind, const Vec3d& ambient_light) {
  { shading_of(kind, ambient_light) } -> std::same_as<ShadingParameters>;
  { texture_of(kind) } -> std::same_as<const Texture*>;
};

/// What a kind may bring: prepare() makes a form of it, for numbers that are textured.
template <class Kind>
concept HasTexturedNumbers = requires(const Kind& kind, const Vec3d& ambient_light) {
  { prepare(kind, ambient_light) } -> std::same_as<PrincipledForm>;
};

/// MaterialList: checks each kind of the list against IsMaterial. Most materials are finishes, and
/// a larger kind must not make all as large: it lives on the heap.
template <IsMaterial Kind>
using ListedMaterial = std::conditional_t<(sizeof(Kind) > sizeof(Finish)), Boxed<Kind>, Kind>;
template <class... Kinds>
using MaterialList = std::variant<ListedMaterial<Kinds>...>;

struct Material {
  static constexpr std::string_view schema_name = "material";
  MaterialList<Finish, Principled> kind;
  OptionalBox<RadioMaterial> radio{};  ///< none: what radio.h assumes

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Material::kind, Spec{.about = "the kind of material"});
    visit("radio", &Material::radio,
          Spec{.about = "what it is to radio waves, which /radio/paths follows; pictures do not "
                        "show it. Else closed bodies are concrete, open ones sheets of it"});
  }
  bool operator==(const Material&) const = default;
};

inline ShadingParameters shading_of(const Material& material, const Vec3d& ambient_light) {
  return std::visit(
      [&](const auto& held) { return shading_of(detail::unboxed(held), ambient_light); },
      material.kind);
}
inline const Texture* texture_of(const Material& material) {
  return std::visit([](const auto& held) { return texture_of(detail::unboxed(held)); },
                    material.kind);
}

/// What tells its shading parameters at each point, for ambient light of that linear RGB; none
/// where they are the same everywhere.
inline std::optional<PrincipledForm> textured_form_of(const Material& material,
                                                      const Vec3d& ambient_light) {
  return std::visit(
      [&]<class Held>(const Held& held) -> std::optional<PrincipledForm> {
        if constexpr (HasTexturedNumbers<detail::KindOf<Held>>) {
          PrincipledForm form = prepare(detail::unboxed(held), ambient_light);
          if (!is_even(form)) return form;
        }
        return std::nullopt;
      },
      material.kind);
}

}  // namespace tia
