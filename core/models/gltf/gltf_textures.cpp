#include "core/models/gltf/gltf_textures.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string>

#include "core/models/gltf/gltf_images.h"
#include "core/models/gltf/gltf_values.h"

namespace tia::gltf {
namespace {

// ---- samplers -----------------------------------------------------------------------------------

// Source: glTF 2.0, 5.26 (sampler), whose numbers are OpenGL's.
constexpr std::uint64_t gl_repeat = 10497, gl_mirrored = 33648, gl_clamp = 33071;
constexpr std::uint64_t gl_nearest = 9728, gl_linear = 9729, most_of_gl = 65535;

// One of these numbers: the first where it is not there; another is a fault.
std::uint64_t gl_number(const GltfObject& sampler, std::string_view name,
                        std::initializer_list<std::uint64_t> allowed, std::string_view words) {
  const std::uint64_t number = sampler.integer(name, 0, most_of_gl).value_or(*allowed.begin());
  if (std::ranges::find(allowed, number) == allowed.end())
    sampler.fault(FaultKind::out_of_range, name, excerpt(*sampler.member(name)),
                  std::string(words));
  return number;
}

Wrap wrap_of(const GltfObject& sampler, std::string_view name) {
  const std::uint64_t number =
      gl_number(sampler, name, {gl_repeat, gl_mirrored, gl_clamp},
                "10497 (repeat), 33648 (mirrored repeat) or 33071 (clamp to edge)");
  if (number == gl_clamp) return Wrap::clamp_to_edge;
  return number == gl_mirrored ? Wrap::mirrored_repeat : Wrap::repeat;
}

bool is_nearest(const GltfObject& sampler) {
  return gl_number(sampler, "magFilter", {gl_linear, gl_nearest},
                   "9728 (nearest) or 9729 (linear)") == gl_nearest;
}

// As textures that have no image yet.
std::vector<ModelTexture> read_samplers(const GltfObject& root) {
  std::vector<ModelTexture> samplers;
  root.for_each("samplers", [&](const GltfObject& sampler, std::size_t) {
    samplers.push_back(
        {0, wrap_of(sampler, "wrapS"), wrap_of(sampler, "wrapT"), is_nearest(sampler)});
  });
  return samplers;
}

// ---- textures -----------------------------------------------------------------------------------

// The image of a texture. Where it has several, its `source`, which every reader can decode; else
// the WebP; none where it has only what is not taken, as KTX2.
MaybeIndex image_of(const GltfObject& texture, std::size_t images, Model& model) {
  if (texture.has("source")) return texture.index("source", images);
  MaybeIndex image;
  bool is_webp = false, is_ktx = false;
  texture.with("extensions", [&](const GltfObject& extensions) {
    is_webp = extensions.with("EXT_texture_webp", [&](const GltfObject& webp) {
      if (webp.has("source")) image = webp.index("source", images);
    });
    is_ktx = extensions.has("KHR_texture_basisu");
  });
  if (!image)
    model.warn({texture.at().pointer(), 0,
                std::string(is_ktx && !is_webp ? "a texture with no image but a KTX2"
                                               : "a texture without an image") +
                    " is left out; the factors that it belongs to stay"});
  return image;
}

// Returns: the number of the uv set; an extension's counts.
std::uint64_t read_transform(const GltfObject& info, TextureUse& use) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  constexpr Range range{-1e9, 1e9};
  std::uint64_t uv_set = info.integer("texCoord", 0, most).value_or(0);
  info.with_extension("KHR_texture_transform", [&](const GltfObject& transform) {
    use.offset = transform.numbers<2>("offset", range).value_or(use.offset);
    use.scale = transform.numbers<2>("scale", range).value_or(use.scale);
    use.rotation = transform.number_or("rotation", 0, range);
    uv_set = transform.integer("texCoord", 0, most).value_or(uv_set);
  });
  return uv_set;
}

}  // namespace

GltfTextures::GltfTextures(const GltfSource& source, Model& model) : model_(&model) {
  const std::vector<ModelTexture> samplers = read_samplers(source.root);
  std::vector<bool> wanted(source.root.size_of("images"));
  source.root.for_each("textures", [&](const GltfObject& texture, std::size_t) {
    const auto image = image_of(texture, wanted.size(), model);
    const auto sampler = texture.index("sampler", source.root.size_of("samplers"));
    numbers_.emplace_back();
    if (!image) return;
    wanted[*image] = true;
    numbers_.back() = static_cast<ModelIndex>(model.textures.size());
    model.textures.push_back(sampler && *sampler < samplers.size() ? samplers[*sampler]
                                                                   : ModelTexture{});
    model.textures.back().image = *image;
  });
  const std::vector<ModelIndex> holders = read_images(source, wanted, model);
  for (ModelTexture& texture : model.textures) texture.image = holders[texture.image];
}

MaybeTexture GltfTextures::use(const GltfObject& owner, std::string_view name,
                               Strength strength) const {
  MaybeTexture out;
  owner.with(name, [&](const GltfObject& info) {
    info.needs("index", "the number of a texture");
    const auto number = info.index("index", numbers_.size());
    TextureUse use;
    const std::uint64_t uv_set = read_transform(info, use);
    if (!strength.name.empty()) use.strength = info.number_or(strength.name, 1, strength.range);
    if (!number || !numbers_[*number]) return;
    use.texture = *numbers_[*number];
    if (uv_set <= 1) use.uv_set = static_cast<std::uint32_t>(uv_set);
    else
      model_->warn({info.at().pointer(), 0,
                    "TEXCOORD_" + std::to_string(uv_set) + " is not taken, but TEXCOORD_0"});
    out = use;
  });
  return out;
}

}  // namespace tia::gltf
