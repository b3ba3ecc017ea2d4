#include "server/still_command.h"

#include <algorithm>

#include "core/input/json.h"
#include "core/scene/read_scene.h"
#include "server/files.h"
#include "server/model_sources.h"
#include "server/picture_file.h"
#include "server/requests/still_query.h"

namespace tia::server {
namespace {

StillParameters asked_of(const std::string& file, const std::vector<Setting>& parameters) {
  const bool as_scene = std::ranges::any_of(parameters, [](const Setting& each) {
    return each.name == "as" && each.text == name_of(StillAs::scene);
  });
  Value::Object asked;
  if (!as_scene)
    if (const std::string_view format = format_named_by(file, parameters); !format.empty())
      asked.emplace_back("format", format);
  return read_described<StillParameters>(asked_by<StillParameters>(std::move(asked), parameters));
}

}  // namespace

void still_to_file(const std::vector<std::string>& names, const std::string& file,
                   const std::vector<Setting>& parameters, bool plain, const Config& config) {
  StillParameters asked = asked_of(file, parameters);
  Workshop workshop(config);
  SharedModel model;
  read_model_files(names, [&](const ModelFiles& files) {
    const ModelUpload upload = upload_of(files);
    model = workshop.models().keep(upload, {}).known.model;
    asked.id = upload.id;
  });
  Scene scene = still_of(asked, model);
  if (asked.as == StillAs::scene) return write_file(file, canonical_text(scene));
  PictureRequest picture = asked;
  picture.scene = std::move(scene);
  picture.along = {asked.id, model};
  workshop.draw_to(file, picture, plain);
}

}  // namespace tia::server
