// The textures of a model's material as maps of a principled.
#pragma once

#include <memory>

#include "core/materials/principled_maps.h"
#include "core/models/kept_model.h"
#include "core/shapes/mesh/mesh.h"

namespace tia {

/// Null where the material has none that shows, on that mesh: grain runs along its tangents, or
/// where it has none as a scene's principled has it.
/// Domain: a material of the model's, a mesh of pieces_of().
std::shared_ptr<const PrincipledMaps> maps_of(const KeptModel& kept, const ModelMaterial& material,
                                              const Mesh& mesh);

/// The texture along whose rows a mesh's tangents run, where its material asks for tangents; null
/// where it does not. Grain without a texture takes the first uvs as they are.
const TextureUse* tangent_texture(const ModelMaterial& material);

/// Whether a texture of it is looked up by the second set of uvs.
bool wants_more_uvs(const ModelMaterial& material);

/// What the mip pyramids of all of a model's materials take, once they are made. Space/units:
/// bytes.
std::size_t pyramid_bytes(const KeptModel& kept);
/// The most that the tangents take that are made of it and kept. Space/units: bytes.
std::size_t tangent_bytes(const Model& model);

}  // namespace tia
