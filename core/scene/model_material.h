// A model's material as one of scenes.
#pragma once

#include "core/materials/material.h"
#include "core/models/model.h"

namespace tia {

/// The principled of its factors and textures. One that is unlit shines with its base colour and
/// scatters nothing. `maps`: as maps_of() gives them; null: none. `ambient`: what of the scene's
/// ambient light it sends back in whitted.
Material material_of(const ModelMaterial& material,
                     std::shared_ptr<const PrincipledMaps> maps = nullptr, double ambient = 0);

}  // namespace tia
