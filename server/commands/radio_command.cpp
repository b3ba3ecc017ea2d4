// `tia radio paths|map SCENE QUESTION -o FILE`: radio waves followed without a server.
#include "core/parallel/pool.h"
#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"
#include "server/commands/scene_argument.h"
#include "server/requests/map_request.h"
#include "server/requests/radio_request.h"

namespace tia::server {
namespace {

struct RadioAsked {
  std::string scene, question, file;
};

// What POST /radio/paths answers.
void radio_paths_to_file(const RadioAsked& by, const Config& config) {
  const Scene read = scene_called(by.scene);
  const auto asked = read_described<RadioQuestion>(parse_json(read_file(by.question)));
  Pool pool(config.threads);
  const RadioAnswer answer =
      radio_paths(read, asked, radio_limits(config.limits()), pool.workers(config.threads));
  write_file(by.file, to_json(radio_paths_json(asked, answer)));
}

// What POST /radio/map does: a PNG, or what the file's ending or the question's format says.
void radio_map_to_file(const RadioAsked& by, const Config& config) {
  const Scene read = scene_called(by.scene);
  auto asked = read_described<DrawnMap>(parse_json(read_file(by.question)));
  for (const MapFormatRow& row : map_formats)
    if (by.file.ends_with("." + std::string(row.name))) asked.format = row.format;
  const std::string recipe = recipe_of(asked, known(std::make_shared<const Scene>(read)));
  Pool pool(config.threads);
  write_file(by.file,
             draw_map(asked, read, recipe, config.limits(), pool.workers(config.threads)).bytes);
}

void add_question(Command command, const std::string& of, RadioAsked& asked,
                  const std::string& files) {
  add_scene(command, asked.scene);
  command.word("question", asked.question,
               "a file with the parameters of /radio/" + of + " but the scene, as JSON");
  add_output(command, asked.file, files);
}

}  // namespace

void add_radio(CommandLine& line) {
  auto& asked = line.keep<RadioAsked>();
  const Command radio = line.add_group("radio", "follow radio waves in a scene");
  add_question(line.add_to(radio, "paths", "the ways between antennas, as JSON",
                           [&] { radio_paths_to_file(asked, line.config()); }),
               "paths", asked, "NAME.json, or - for standard output");
  add_question(line.add_to(radio, "map", "what is received where",
                           [&] { radio_map_to_file(asked, line.config()); }),
               "map", asked, "NAME.png, NAME.pfm, NAME.json, or - for a PNG");
}

}  // namespace tia::server
