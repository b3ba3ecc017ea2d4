#include "server/stores/gallery.h"

#include "core/input/object_schema.h"
#include "core/scene/read_scene.h"
#include "server/stores/assets.h"

namespace tia::server {

Gallery::Gallery() {
  constexpr std::string_view folder = "/scenes/", ending = ".json";
  for (const Asset& asset : assets()) {
    if (!asset.path.starts_with(folder) || !asset.path.ends_with(ending)) continue;
    std::string_view name = asset.path.substr(folder.size());
    name.remove_suffix(ending.size());
    texts_.try_emplace(std::string(name));
    scenes_.emplace(name, known(std::make_shared<const Scene>(read_scene(asset.bytes))));
  }
  Value::Array list;
  for (const auto& [name, scene] : scenes_)
    list.push_back(Value::Object{
        {"name", name}, {"title", scene->title}, {"description", scene->description}});
  listing_ = to_json(Value::Object{{"scenes", list}});
}

Value Gallery::listing_schema(Definitions& named) {
  return schema_called("scene_list", named, [] {
    const Value text = plain_schema<std::string>();
    const Value scene = object_schema({{"name", text, "what requests call it"},
                                       {"title", text, "what the picture shows"},
                                       {"description", text, "what to look at"}});
    return object_schema({{"scenes", list_schema(scene), "sorted by name"}});
  });
}

KnownScene Gallery::find(std::string_view name) const {
  const auto found = scenes_.find(name);
  return found == scenes_.end() ? KnownScene{} : found->second;
}

const std::string& Gallery::text(const std::string& name) const {
  Text& text = texts_.at(name);
  std::call_once(text.made, [&] { text.text = canonical_text(*scenes_.at(name)); });
  return text.text;
}

std::vector<std::string_view> Gallery::names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, scene] : scenes_) names.push_back(name);
  return names;
}

}  // namespace tia::server
