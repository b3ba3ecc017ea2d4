#include "server/scene_command.h"

#include "core/input/json.h"
#include "core/scene/footprints.h"
#include "server/files.h"

namespace tia::server {

void footprints_to_file(const std::string& geojson, const std::string& file) {
  const Scene scene = scene_of_footprints(parse_json(read_file(geojson)));
  write_file(file, to_json(write_value(scene)));
}

}  // namespace tia::server
