// The textures of a model's material as maps of a principled.
#pragma once

#include <memory>

#include "core/materials/principled_maps.h"
#include "core/models/kept_model.h"

namespace tia {

/// Null where the material has none that shows. Of clearcoat_normal_texture and the direction in
/// anisotropy_texture nothing is shown. `colored`: whether what wears it has colours of vertices.
/// Domain: a material of the model's.
std::shared_ptr<const PrincipledMaps> maps_of(const KeptModel& kept, const ModelMaterial& material,
                                              bool colored);

/// The texture along whose rows a mesh's tangents run, where its material asks for tangents; null
/// where it does not.
const TextureUse* tangent_texture(const ModelMaterial& material);

/// Whether a texture of it is looked up by the second set of uvs.
bool wants_more_uvs(const ModelMaterial& material);

/// What the mip pyramids of all of a model's materials take, once they are made. Space/units:
/// bytes.
std::size_t pyramid_bytes(const KeptModel& kept);

}  // namespace tia
