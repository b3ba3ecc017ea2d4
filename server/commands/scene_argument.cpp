#include "server/commands/scene_argument.h"

#include <stdexcept>

#include "core/input/nearest_listed.h"
#include "core/scene/read_scene.h"
#include "server/commands/files.h"
#include "server/stores/gallery.h"

namespace tia::server {

Scene scene_called(const std::string& scene) {
  if (scene.find_first_of("./") != scene.npos) return read_scene(read_file(scene));
  const Gallery gallery;
  if (const KnownScene known = gallery.find(scene)) return *known;
  throw std::runtime_error("no scene is called " + scene +
                           "; there are: " + nearest_listed(scene, gallery.names()) +
                           " in the gallery, and files, NAME.json or a path");
}

}  // namespace tia::server
