#include "server/stores/gallery_models.h"

#include <algorithm>

#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "server/stores/assets.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

std::vector<GalleryModel> models_of_assets() {
  constexpr std::string_view folder = "/models/";
  std::vector<GalleryModel> all;
  for (const Asset& asset : assets()) {
    if (!asset.path.starts_with(folder)) continue;
    const std::string_view file = asset.path.substr(folder.size());
    const std::size_t dot = file.rfind('.');
    all.push_back(
        {file.substr(0, dot), asset.bytes, sha256_hex(asset.bytes), file.substr(dot + 1)});
  }
  return all;
}

}  // namespace

const std::vector<GalleryModel>& gallery_models() {
  static const std::vector<GalleryModel> all = models_of_assets();
  return all;
}

const GalleryModel* gallery_model(std::string_view name_or_id) {
  const auto& all = gallery_models();
  const auto found = std::ranges::find_if(all, [&](const GalleryModel& model) {
    return model.name == name_or_id || model.id == name_or_id;
  });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string_view> gallery_model_names() {
  std::vector<std::string_view> names;
  for (const GalleryModel& model : gallery_models()) names.push_back(model.name);
  return names;
}

std::string gallery_models_listing() {
  Value::Array list;
  for (const GalleryModel& model : gallery_models())
    list.push_back(Value::Object{{"name", model.name},
                                 {"id", model.id},
                                 {"format", model.format},
                                 {"bytes", static_cast<double>(model.bytes.size())},
                                 {"location", "/models/" + std::string(model.name)}});
  return to_json(Value::Object{{"models", list}});
}

Value gallery_models_schema(Definitions& named) {
  return schema_called("model_list", named, [] {
    const Value text = plain_schema<std::string>();
    const Value model = object_schema({{"name", text, "what requests and scenes call it"},
                                       {"id", text, "SHA-256 of its file, which works as well"},
                                       {"format", text},
                                       {"bytes", count_schema()},
                                       {"location", text, "what is in it"}});
    return object_schema({{"models", list_schema(model), "sorted by name"}});
  });
}

}  // namespace tia::server
