#include "core/models/gltf/gltf_head.h"

#include <algorithm>
#include <charconv>

namespace tia::gltf {
namespace {

// The extensions that Tia takes.
const std::vector<std::string_view> taken_extensions{
    "KHR_materials_unlit",        "KHR_materials_emissive_strength",
    "KHR_materials_ior",          "KHR_materials_specular",
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_clearcoat",    "KHR_materials_sheen",
    "KHR_materials_anisotropy",   "KHR_materials_dispersion",
    "KHR_materials_variants",     "KHR_texture_transform",
    "KHR_lights_punctual",        "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",    "EXT_texture_webp",
    "KHR_draco_mesh_compression", "EXT_meshopt_compression"};

bool is_taken(std::string_view name) {
  return std::ranges::find(taken_extensions, name) != taken_extensions.end();
}

struct GltfVersion {
  int major = 0, minor = 0;
};
std::optional<GltfVersion> version_of(std::string_view text) {
  GltfVersion version;
  const char* const end = text.data() + text.size();
  const auto [dot, wrong] = std::from_chars(text.data(), end, version.major);
  if (wrong != std::errc{} || version.major < 0 || dot == end || *dot != '.') return std::nullopt;
  const auto [last, error] = std::from_chars(dot + 1, end, version.minor);
  if (error != std::errc{} || version.minor < 0 || last != end) return std::nullopt;
  return version;
}

// Of any 2.x version, unless it says that it needs more than 2.0.
void read_version(const GltfObject& asset) {
  if (!asset.needs("version", "a text such as \"2.0\"")) return;
  const std::string text = asset.text("version"), least = asset.text("minVersion");
  if (!asset.faults().empty()) return;
  const auto version = version_of(text), needed = version_of(least);
  if (!version || version->major != 2)
    asset.fault(FaultKind::out_of_range, "version", excerpt(text), "glTF of a version 2.x");
  else if (!least.empty() && (!needed || needed->major != 2 || needed->minor != 0))
    asset.fault(FaultKind::out_of_range, "minVersion", excerpt(least), "2.0");
}

void refuse_required(const GltfObject& root) {
  const std::vector<std::string> required = root.texts("extensionsRequired");
  const Place place = root.at().at("extensionsRequired");
  for (std::size_t i = 0; i < required.size() && !root.faults().full(); ++i)
    if (!is_taken(required[i]))
      root.faults().add({FaultKind::unknown_name, place.at(i).pointer(), Value(required[i]),
                         "extensions that are taken: " + listed(taken_extensions),
                         nearest_name(required[i], taken_extensions)});
}

void warn_of_used(const GltfObject& root, Model& model) {
  const Place place = root.at().at("extensionsUsed");
  for (std::size_t i = 0; i < model.extensions.size(); ++i) {
    if (model.warnings.size() == Model::most_warnings) return;
    const std::string name = excerpt_of(model.extensions[i], longest_name);
    if (!is_taken(name)) model.warn({place.at(i).pointer(), 0, name + " is not taken"});
  }
}

}  // namespace

bool read_head(const GltfObject& root, Model& model) {
  if (root.needs("asset", "an object with the version of glTF"))
    root.with("asset", [&](const GltfObject& asset) {
      read_version(asset);
      model.generator = asset.text("generator");
      model.copyright = asset.text("copyright");
    });
  if (!root.faults().empty()) return false;
  model.extensions = root.texts("extensionsUsed");
  refuse_required(root);
  warn_of_used(root, model);
  return root.faults().empty();
}

bool uses(const Model& model, std::string_view extension) {
  return std::ranges::find(model.extensions, extension) != model.extensions.end();
}

}  // namespace tia::gltf
