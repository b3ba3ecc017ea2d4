// `tia simulate SCENE -o FILE`: a scene's motion found without a server.
#include <stdexcept>

#include "core/input/nearest_listed.h"
#include "core/motion/simulate.h"
#include "core/scene/read_scene.h"
#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"
#include "server/commands/scene_argument.h"

namespace tia::server {
namespace {

struct SimulateAsked {
  std::string scene, file;
};

// The scene with tracks in the place of its physics, as canonical text.
void simulate_to_file(const SimulateAsked& asked, const Config& config) {
  const Scene read = scene_called(asked.scene);
  if (!read.physics) throw std::runtime_error(asked.scene + ": a scene without physics");
  const auto most_events = static_cast<std::size_t>(config.max_events);
  write_file(asked.file, canonical_text(with_motion(read, simulate(read, most_events))));
}

}  // namespace

void add_simulate(CommandLine& line) {
  auto& asked = line.keep<SimulateAsked>();
  Command simulate = line.add("simulate", "put tracks in the place of a scene's physics",
                              [&] { simulate_to_file(asked, line.config()); });
  simulate.takes_all();
  add_scene(simulate, asked.scene);
  add_output(simulate, asked.file, "NAME.json, or - for standard output");
}

}  // namespace tia::server
