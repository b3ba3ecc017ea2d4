#include "server/stores/gallery.h"

#include "core/input/object_schema.h"
#include "core/scene/read_scene.h"
#include "server/operation/memory_account.h"
#include "server/stores/assets.h"

namespace tia::server {

Gallery::Gallery() {
  constexpr std::string_view folder = "/scenes/", ending = ".json";
  for (const Asset& asset : assets()) {
    if (!asset.path.starts_with(folder) || !asset.path.ends_with(ending)) continue;
    std::string_view name = asset.path.substr(folder.size());
    name.remove_suffix(ending.size());
    entries_.try_emplace(std::string(name), asset.bytes);
  }
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

std::vector<std::string_view> Gallery::names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return names;
}

KnownScene Gallery::find(std::string_view name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return {};
  Entry& entry = found->second;
  std::call_once(entry.is_read, [&] {
    const ClaimScope nobodys(nullptr);  // what stays is the program's
    entry.scene = known(std::make_shared<const Scene>(read_scene(entry.json)));
  });
  return entry.scene;
}

std::map<std::string, KnownScene> Gallery::scenes() const {
  std::map<std::string, KnownScene> scenes;
  for (const auto& [name, entry] : entries_) scenes.emplace(name, find(name));
  return scenes;
}

const std::string& Gallery::text(const std::string& name) const {
  Entry& entry = entries_.at(name);
  std::call_once(entry.is_written, [&] {
    const ClaimScope nobodys(nullptr);
    entry.text = canonical_text(*find(name));
  });
  return entry.text;
}

const std::string& Gallery::listing() const {
  std::call_once(is_listed_, [&] {
    const ClaimScope nobodys(nullptr);
    Value::Array list;
    for (const auto& [name, scene] : scenes())
      list.push_back(Value::Object{
          {"name", name}, {"title", scene->title}, {"description", scene->description}});
    listing_ = to_json(Value::Object{{"scenes", list}});
  });
  return listing_;
}

}  // namespace tia::server
