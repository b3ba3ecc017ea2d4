// Any text as a scene: what is read has a canonical text that reads as itself, and can be drawn;
// all that goes wrong is an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/film/png.h"
#include "core/render/render.h"
#include "core/scene/keys.h"
#include "core/scene/limits.h"
#include "core/scene/read_scene.h"

namespace {

using namespace tia;

void must(bool holds) {
  if (!holds) std::abort();
}

void draw(const Scene& scene) {
  static Pool pool(1);
  RenderOptions options;
  options.integrator = scene.options.integrator;
  options.max_depth = scene.options.max_depth.value_or(options.max_depth);
  options.max_rays = 4096;
  options.max_work = 1'000'000;
  render(compile(scene), view_of(scene.camera, 8, 8), {0, 0, 8, 8}, options, pool, {},
         [](const FilmTile&) {});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Scene scene = read_scene({reinterpret_cast<const char*>(data), size});
    const std::string text = canonical_text(scene);
    must(canonical_text(read_scene(text)) == text);
    draw(scene);
  } catch (const InputError& error) {
    must(!error.faults().empty() && *error.what() != '\0');
  }
  return 0;
}
