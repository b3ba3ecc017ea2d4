#include "server/radio_command.h"

#include "core/parallel/pool.h"
#include "server/files.h"
#include "server/requests/map_request.h"
#include "server/requests/radio_request.h"
#include "server/scene_argument.h"

namespace tia::server {

void radio_paths_to_file(const std::string& scene, const std::string& question,
                         const std::string& file, const Config& config) {
  const Scene read = scene_called(scene);
  const auto asked = read_described<RadioQuestion>(parse_json(read_file(question)));
  Pool pool(config.threads);
  const RadioAnswer answer =
      radio_paths(read, asked, radio_limits(config.limits()), pool.workers(config.threads));
  write_file(file, to_json(radio_paths_json(asked, answer)));
}

void radio_map_to_file(const std::string& scene, const std::string& question,
                       const std::string& file, const Config& config) {
  const Scene read = scene_called(scene);
  auto asked = read_described<DrawnMap>(parse_json(read_file(question)));
  for (const MapFormatRow& row : map_formats)
    if (file.ends_with("." + std::string(row.name))) asked.format = row.format;
  const std::string recipe = recipe_of(asked, known(std::make_shared<const Scene>(read)));
  Pool pool(config.threads);
  write_file(file,
             draw_map(asked, read, recipe, config.limits(), pool.workers(config.threads)).bytes);
}

}  // namespace tia::server
