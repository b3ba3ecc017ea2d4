// THE LIST of materials. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <string_view>
#include <variant>

#include "core/input/kinds.h"
#include "core/materials/finish.h"
#include "core/materials/principled.h"

namespace tia {

/// What a kind must bring:
///   shading_of  its shading parameters, for ambient light of that linear RGB
///   texture_of  its texture, null if it has none
template <class Kind>
concept IsMaterial = IsKind<Kind> && requires(const Kind& kind, const Vec3d& ambient_light) {
  { shading_of(kind, ambient_light) } -> std::same_as<ShadingParameters>;
  { texture_of(kind) } -> std::same_as<const Texture*>;
};

/// MaterialList: checks each kind of the list against IsMaterial.
template <IsMaterial Kind>
using ListedMaterial = Kind;
template <class... Kinds>
using MaterialList = std::variant<ListedMaterial<Kinds>...>;

struct Material {
  static constexpr std::string_view schema_name = "material";
  MaterialList<Finish, Principled> kind;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Material::kind, Spec{.about = "the kind of material"});
  }
  bool operator==(const Material&) const = default;
};

inline ShadingParameters shading_of(const Material& material, const Vec3d& ambient_light) {
  return std::visit([&](const auto& kind) { return shading_of(kind, ambient_light); },
                    material.kind);
}
inline const Texture* texture_of(const Material& material) {
  return std::visit([](const auto& kind) { return texture_of(kind); }, material.kind);
}

}  // namespace tia
