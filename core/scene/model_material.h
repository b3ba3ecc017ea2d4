// A model's material as one of scenes.
#pragma once

#include "core/materials/material.h"
#include "core/models/model.h"

namespace tia {

/// The principled of its factors: textures and occlusion are left out. One that is unlit
/// shines with its base colour and scatters nothing.
Material material_of(const ModelMaterial& material);

}  // namespace tia
