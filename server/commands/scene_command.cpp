// `tia scene from-geojson FILE -o FILE`: scenes from what is none.
#include "core/input/json.h"
#include "core/scene/footprints.h"
#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"

namespace tia::server {
namespace {

struct FootprintsAsked {
  std::string geojson, file;
};

void footprints_to_file(const FootprintsAsked& asked) {
  const Scene scene = scene_of_footprints(parse_json(read_file(asked.geojson)));
  write_file(asked.file, to_json(write_value(scene)));
}

}  // namespace

void add_scenes(CommandLine& line) {
  auto& asked = line.keep<FootprintsAsked>();
  Command buildings =
      line.add_to(line.add_group("scene", "make scenes"), "from-geojson",
                  "blocks of polygons with heights, in metres", [&] { footprints_to_file(asked); });
  buildings.word("file", asked.geojson, "GeoJSON");
  add_output(buildings, asked.file, "NAME.json, or - for standard output");
}

}  // namespace tia::server
