#include "core/models/mtl_maps.h"

#include "core/models/mtl_options.h"

namespace tia {
namespace {

// Whether a file begins as those that are decoded: PNG, JPEG or WebP.
bool is_mtl_picture(ModelBytes file) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  return text.starts_with("\x89PNG\r\n\x1A\n") || text.starts_with("\xFF\xD8\xFF") ||
         (text.starts_with("RIFF") && text.substr(4).substr(4).starts_with("WEBP"));
}

}  // namespace

MtlMaps::MtlMaps(MtlReading& reading) : reading_(reading) {
  const Model& model = reading.model();
  for (std::size_t i = 0; i < model.images.size(); ++i)
    images_.emplace(model.images[i].name, static_cast<ModelIndex>(i));
  for (std::size_t i = 0; i < model.textures.size(); ++i)
    textures_.emplace(std::pair(model.textures[i].image, model.textures[i].wrap_u),
                      static_cast<ModelIndex>(i));
}

MaybeTexture MtlMaps::read(std::string_view statement, ObjWords words) {
  MtlOptions options;
  if (!read_mtl_options(statement, words, reading_, options)) return std::nullopt;
  const std::string_view name = words.rest();
  if (name.empty()) {
    reading_.fault(FaultKind::malformed, reading_.line(), "options, then the name of a picture");
    return std::nullopt;
  }
  const MaybeIndex found = image(name);
  if (!found) return std::nullopt;
  TextureUse use;
  use.texture = texture(*found, options.clamp ? Wrap::clamp_to_edge : Wrap::repeat);
  // MTL's v is 1 - v: s (1 - v) + o = 1 - (s v + 1 - s - o).
  use.scale = options.scale;
  use.offset = {options.offset[0], 1 - options.scale[1] - options.offset[1]};
  use.strength = options.strength;
  return use;
}

MaybeIndex MtlMaps::image(std::string_view name) {
  const auto found = names_.find(name);
  if (found != names_.end()) return found->second;
  if (names_.size() == most_mtl_names) {
    reading_.stop(name, most_mtl_names, "names of pictures");
    return std::nullopt;
  }
  return names_.emplace(name, find_image(name)).first->second;
}

MaybeIndex MtlMaps::find_image(std::string_view name) {
  const ModelFile* file = reading_.find(name);
  if (file == nullptr) return std::nullopt;
  const auto found = images_.find(file->path);
  if (found != images_.end()) return found->second;
  if (!is_mtl_picture(file->bytes)) {
    reading_.warn(excerpt_of(name, longest_name) +
                  ": a picture that is no PNG, JPEG or WebP is not taken");
    return std::nullopt;
  }
  std::vector<ModelImage>& images = reading_.model().images;
  const auto index = static_cast<ModelIndex>(images.size());
  images.push_back({file->path, {file->bytes.begin(), file->bytes.end()}});
  images_.emplace(file->path, index);
  return index;
}

ModelIndex MtlMaps::texture(ModelIndex image, Wrap wrap) {
  std::vector<ModelTexture>& textures = reading_.model().textures;
  const auto index = static_cast<ModelIndex>(textures.size());
  const auto [found, is_new] = textures_.try_emplace({image, wrap}, index);
  if (is_new) textures.push_back({image, wrap, wrap, false});
  return found->second;
}

}  // namespace tia
