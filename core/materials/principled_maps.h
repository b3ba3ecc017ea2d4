// PrincipledMaps: the pictures that a principled material of a model has beside its numbers.
#pragma once

#include <optional>
#include <vector>

#include "core/materials/texture_map.h"

namespace tia {

/// PrincipledNumbers: what of it may be textured, at a point. Colours are what its own are
/// multiplied with there.
struct PrincipledNumbers {
  double metallic = 0, roughness = 0, specular = 0, transmission = 0;
  double clearcoat = 0, clearcoat_roughness = 0, sheen_roughness = 0, anisotropy = 0;
  Vec3d base{1, 1, 1}, emissive{1, 1, 1}, specular_color{1, 1, 1}, sheen_color{1, 1, 1};
  double occlusion = 1;  ///< what is left of ambient light
  double alpha = 1;      ///< what its own is multiplied with
};

/// MapUse: a picture, and what it is multiplied into.
struct MapUse {
  struct Channel {
    double PrincipledNumbers::*number;
    std::size_t channel;  ///< of Rgba
    bool operator==(const Channel&) const = default;
  };
  TextureMap map;
  Vec3d PrincipledNumbers::*color = nullptr;  ///< gets red, green and blue; null: none does
  std::vector<Channel> channels{};
  bool operator==(const MapUse&) const = default;
};

/// Grain: along which direction of the tangent space facets are stretched.
/// Source: KHR_materials_anisotropy.
struct Grain {
  std::optional<TextureMap> map{};  ///< red and green, from -1 to 1; none: along the tangent
  Vec2d turned{1, 0};               ///< cosine and sine of the angle by which that is turned
  bool operator==(const Grain&) const = default;
};

/// PrincipledMaps: as glTF's material has them.
struct PrincipledMaps {
  std::vector<MapUse> uses;
  std::optional<TextureMap> normal;
  /// Whether it shines with its mesh's colour, as what is unlit does.
  bool shines_with_mesh = false;
  std::optional<TextureMap> coat_normal{};
  std::optional<Grain> grain{};
  bool operator==(const PrincipledMaps&) const = default;
};

/// Whether points of the same material shine differently.
bool emission_varies(const PrincipledMaps& maps);
/// Multiplies what the maps have there into the numbers, and into alpha the mesh's. The mesh's
/// colour is left out, but where the material shines with it.
void multiply(const PrincipledMaps& maps, TextureReader& reader, PrincipledNumbers& numbers);
/// Alpha alone: the product of the maps' and the mesh's.
double map_alpha(const PrincipledMaps& maps, const TexturePoint& at);
/// A normal map's normal in tangent space, unit: x along the tangent, y along the bitangent, z
/// along the shading normal.
/// Source: Khronos, glTF 2.0, 3.9.3: normalize((2 t - 1) (scale, scale, 1)).
Vec3d mapped_normal(const TextureMap& map, TextureReader& reader);
/// The grain's direction there, along the tangent and the bitangent, unit.
Vec2d mapped_grain(const Grain& grain, TextureReader& reader);
/// The map whose coordinates tell the tangent space where the mesh has no tangents.
const TextureMap& tangent_map(const PrincipledMaps& maps);

}  // namespace tia
