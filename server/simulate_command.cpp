#include "server/simulate_command.h"

#include <stdexcept>

#include "core/input/nearest_listed.h"
#include "core/motion/simulate.h"
#include "core/scene/read_scene.h"
#include "server/files.h"
#include "server/scene_argument.h"

namespace tia::server {

void simulate_to_file(const std::string& scene, const std::string& file, const Config& config) {
  const Scene read = scene_called(scene);
  if (!read.physics) throw std::runtime_error(scene + ": a scene without physics");
  const auto most_events = static_cast<std::size_t>(config.max_events);
  write_file(file, canonical_text(with_motion(read, simulate(read, most_events))));
}

}  // namespace tia::server
