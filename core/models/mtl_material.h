// What a material of an MTL file says, and what that means.
#pragma once

#include <optional>

#include "core/models/model.h"

namespace tia {

/// MtlMaterial: the statements that came, the last one where there were several, within their
/// ranges.
struct MtlMaterial {
  std::string name;
  std::optional<Color> diffuse, emission;  ///< Kd, Ke
  std::optional<double> exponent;          ///< Ns
  std::optional<double> dissolve, transparency, illumination, ior;
  std::optional<double> roughness, metallic, sheen, clearcoat, clearcoat_roughness;
  MaybeTexture diffuse_map, emission_map, dissolve_map, roughness_map, metallic_map, normal_map;
};

/// The material that it means, as read_mtl says.
ModelMaterial mtl_material_of(const MtlMaterial& mtl);

}  // namespace tia
