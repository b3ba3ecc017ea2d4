#include "server/gallery.h"

#include "core/scene/read_scene.h"
#include "server/assets.h"

namespace tia::server {

Gallery::Gallery() {
  constexpr std::string_view folder = "/scenes/", ending = ".json";
  for (const Asset& asset : assets()) {
    if (!asset.path.starts_with(folder) || !asset.path.ends_with(ending)) continue;
    std::string_view name = asset.path.substr(folder.size());
    name.remove_suffix(ending.size());
    scenes_.emplace(name, read_scene(asset.bytes));
  }
}

const Scene* Gallery::find(std::string_view name) const {
  const auto found = scenes_.find(name);
  return found == scenes_.end() ? nullptr : &found->second;
}

const Scene& Gallery::scene(std::string_view name, std::string_view pointer) const {
  if (const Scene* scene = find(name)) return *scene;
  std::vector<std::string_view> known;
  for (const auto& [each, scene] : scenes_) known.push_back(each);
  throw InputError({FaultKind::unknown_name, std::string(pointer), Value(name),
                    "a scene's name (" + listed(known) + ") or a whole scene",
                    nearest_name(name, known)});
}

}  // namespace tia::server
