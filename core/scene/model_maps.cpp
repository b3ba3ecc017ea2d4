#include "core/scene/model_maps.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/math/deterministic.h"

namespace tia {
namespace {

using N = PrincipledNumbers;
using M = ModelMaterial;
using Channels = std::vector<MapUse::Channel>;
constexpr std::size_t r = 0, g = 1, b = 2, a = 3;

/// Slot: which of a material's textures is multiplied into which numbers.
struct Slot {
  MaybeTexture M::*texture;
  Encoding encoding;
  Vec3d N::*color;
  Channels channels;
};

// Source: Khronos, glTF 2.0, 3.9, and its extensions KHR_materials_*.
const std::vector<Slot>& lit_slots() {
  constexpr auto srgb = Encoding::srgb, linear = Encoding::linear;
  static const std::vector<Slot> all{
      {&M::base_color_texture, srgb, &N::base, {{&N::alpha, a}}},
      {&M::metallic_roughness_texture, linear, nullptr, {{&N::roughness, g}, {&N::metallic, b}}},
      {&M::metallic_texture, linear, nullptr, {{&N::metallic, r}}},
      {&M::roughness_texture, linear, nullptr, {{&N::roughness, r}}},
      {&M::alpha_texture, linear, nullptr, {{&N::alpha, r}}},
      {&M::occlusion_texture, linear, nullptr, {{&N::occlusion, r}}},
      {&M::emissive_texture, srgb, &N::emissive, {}},
      {&M::specular_texture, linear, nullptr, {{&N::specular, a}}},
      {&M::specular_color_texture, srgb, &N::specular_color, {}},
      {&M::transmission_texture, linear, nullptr, {{&N::transmission, r}}},
      {&M::clearcoat_texture, linear, nullptr, {{&N::clearcoat, r}}},
      {&M::clearcoat_roughness_texture, linear, nullptr, {{&N::clearcoat_roughness, g}}},
      {&M::sheen_color_texture, srgb, &N::sheen_color, {}},
      {&M::sheen_roughness_texture, linear, nullptr, {{&N::sheen_roughness, a}}},
      {&M::anisotropy_texture, linear, nullptr, {{&N::anisotropy, b}}},
  };
  return all;
}
// What is unlit shines with its base colour.
const std::vector<Slot>& unlit_slots() {
  static const std::vector<Slot> all{
      {&M::base_color_texture, Encoding::srgb, &N::emissive, {{&N::alpha, a}}},
      {&M::alpha_texture, Encoding::linear, nullptr, {{&N::alpha, r}}},
  };
  return all;
}
const std::vector<Slot>& slots_of(const ModelMaterial& material) {
  return material.unlit ? unlit_slots() : lit_slots();
}

// The picture of a use; null where its image has no file.
std::shared_ptr<const ImageRgba8> image_of(const KeptModel& kept, const TextureUse& use) {
  const ModelIndex image = kept.model->textures[use.texture].image;
  return image < kept.images.size() ? kept.images[image] : nullptr;
}

std::optional<TextureMap> map_of(const KeptModel& kept, const MaybeTexture& use,
                                 Encoding encoding) {
  const auto image = use ? image_of(kept, *use) : nullptr;
  if (!image) return std::nullopt;
  const ModelTexture& texture = kept.model->textures[use->texture];
  TextureMap map;
  map.pyramid = kept.pyramids->of(image, encoding, !texture.nearest);
  map.wrap_u = texture.wrap_u, map.wrap_v = texture.wrap_v;
  map.nearest = texture.nearest;
  map.uv_set = use->uv_set;
  map.transform({use->offset[0], use->offset[1]}, {use->scale[0], use->scale[1]}, use->rotation);
  map.strength = use->strength;
  return map;
}

// Pictures often hold several numbers, which are then looked up once.
void add(TextureMap map, const Slot& slot, std::vector<MapUse>& uses) {
  const auto same = std::ranges::find_if(
      uses, [&](const MapUse& use) { return slot.color == nullptr && use.map == map; });
  if (same == uses.end()) return void(uses.push_back({std::move(map), slot.color, slot.channels}));
  same->channels.insert(same->channels.end(), slot.channels.begin(), slot.channels.end());
}

bool bends_coat(const ModelMaterial& material) {
  return material.clearcoat > 0 && material.clearcoat_normal_texture;
}

// Calls f(use, encoding) for each texture that shows.
template <class F>
void each_use(const ModelMaterial& material, F f) {
  for (const Slot& slot : slots_of(material))
    if (const MaybeTexture& use = material.*slot.texture) f(*use, slot.encoding);
  if (material.unlit) return;
  if (material.normal_texture) f(*material.normal_texture, Encoding::linear);
  if (bends_coat(material)) f(*material.clearcoat_normal_texture, Encoding::linear);
}

std::optional<Grain> grain_of(const KeptModel& kept, const ModelMaterial& material) {
  if (!(material.anisotropy > 0)) return std::nullopt;
  const double angle = material.anisotropy_rotation;
  return Grain{map_of(kept, material.anisotropy_texture, Encoding::linear),
               {cos_of(angle), sin_of(angle)}};
}

}  // namespace

std::shared_ptr<const PrincipledMaps> maps_of(const KeptModel& kept, const ModelMaterial& material,
                                              const Mesh& mesh) {
  PrincipledMaps maps;
  for (const Slot& slot : slots_of(material))
    if (auto map = map_of(kept, material.*slot.texture, slot.encoding))
      add(std::move(*map), slot, maps.uses);
  maps.shines_with_mesh = material.unlit && !mesh.colors.values.empty();
  if (!material.unlit) {
    maps.normal = map_of(kept, material.normal_texture, Encoding::linear);
    if (bends_coat(material))
      maps.coat_normal = map_of(kept, material.clearcoat_normal_texture, Encoding::linear);
    if (!mesh.tangents.values.empty()) maps.grain = grain_of(kept, material);
  }
  if (maps == PrincipledMaps{}) return nullptr;
  return std::make_shared<const PrincipledMaps>(std::move(maps));
}

const TextureUse* tangent_texture(const ModelMaterial& material) {
  static const TextureUse first_uvs;
  if (material.unlit) return nullptr;
  if (material.normal_texture) return &*material.normal_texture;
  if (bends_coat(material)) return &*material.clearcoat_normal_texture;
  if (!(material.anisotropy > 0)) return nullptr;
  return material.anisotropy_texture ? &*material.anisotropy_texture : &first_uvs;
}

bool wants_more_uvs(const ModelMaterial& material) {
  bool wants = false;
  each_use(material, [&](const TextureUse& use, Encoding) { wants = wants || use.uv_set == 1; });
  return wants;
}

std::size_t tangent_bytes(const Model& model) {
  const auto wants = [&](const ModelPart& part, ModelIndex material) {
    const TextureUse* const use = tangent_texture(model.materials[material]);
    return use != nullptr && !part.uvs[use->uv_set].empty();
  };
  std::size_t bytes = 0;
  for (const ModelMesh& mesh : model.meshes)
    for (const ModelPart& part : mesh.parts) {
      const bool wanted = (part.material && wants(part, *part.material)) ||
                          std::ranges::any_of(part.variants, [&](const VariantMaterial& each) {
                            return wants(part, each.material);
                          });
      if (!wanted || !part.tangents.empty()) continue;
      const std::size_t corners = part.indices.size(), most = part.vertices() + corners;
      bytes += 4 * sizeof(double) * most + 2 * sizeof(std::uint32_t) * corners;
    }
  return bytes;
}

std::size_t pyramid_bytes(const KeptModel& kept) {
  std::set<std::pair<const ImageRgba8*, Encoding>> all;
  for (const ModelMaterial& material : kept.model->materials)
    each_use(material, [&](const TextureUse& use, Encoding encoding) {
      if (const auto image = image_of(kept, use);
          image && !kept.model->textures[use.texture].nearest)
        all.emplace(image.get(), encoding);
    });
  std::size_t bytes = 0;
  for (const auto& [image, encoding] : all) bytes += bytes_of_halves(image->width, image->height);
  return bytes;
}

}  // namespace tia
