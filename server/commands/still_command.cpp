// `tia still FILE -o PICTURE`: the picture of a model's file, without a server.
#include <algorithm>

#include "core/input/json.h"
#include "core/scene/read_scene.h"
#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"
#include "server/commands/model_sources.h"
#include "server/commands/picture_file.h"
#include "server/requests/still_query.h"

namespace tia::server {
namespace {

struct StillAsked {
  std::vector<std::string> files;
  std::string output;
  std::vector<Setting> parameters = {};
  bool plain = false;
};

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

// To a file (or "-", standard output); with as=scene its scene is written there.
void still_to_file(const StillAsked& by, const Config& config) {
  StillParameters asked = asked_of(by.output, by.parameters);
  Workshop workshop(config);
  SharedModel model;
  read_model_files(by.files, [&](const ModelFiles& files) {
    const ModelUpload upload = upload_of(files);
    model = workshop.models().keep(upload, {}).known.model;
    asked.id = upload.id;
  });
  Scene scene = still_of(asked, model);
  if (asked.as == StillAs::scene) return write_file(by.output, canonical_text(scene));
  PictureRequest picture = asked;
  picture.scene = std::move(scene);
  picture.along = {asked.id, model};
  workshop.draw_to(by.output, picture, by.plain);
}

}  // namespace

void add_still(CommandLine& line) {
  auto& asked = line.keep<StillAsked>();
  Command still = line.add("still", "draw the picture of a model's file",
                           [&] { still_to_file(asked, line.config()); });
  still.takes_all();
  add_model_files(still, asked.files);
  add_output(still, asked.output, picture_files() + ", or - for standard output");
  add_plain(still, asked.plain);
  StillParameters::fields(ParameterFlags{still, asked.parameters});
}

}  // namespace tia::server
