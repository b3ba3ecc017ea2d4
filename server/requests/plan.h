// A picture whose request has been checked: all that is needed to draw it.
#pragma once

#include <optional>
#include <string>

#include "core/film/denoise.h"
#include "core/render/render.h"
#include "core/scene/views.h"
#include "server/requests/exposure.h"
#include "server/requests/picture_request.h"
#include "server/stores/known_scene.h"

namespace tia::server {

/// Whether the picture has alpha.
inline bool is_transparent(const Scene& scene, IntegratorName integrator) {
  return scene.backdrop && scene.backdrop->is_transparent() && gathers_light(integrator);
}

/// Plan: a request whose picture can be drawn: all that may be wrong with it has been checked.
struct Plan {
  KnownScene scene;  ///< plain, of the frame's own time
  Exposure exposure;
  View view;  ///< the scene's camera's own; each view of the picture is as large
  Window window;
  Window whole;            ///< all of the picture, of which `window` is asked for
  ViewGrid views;          ///< but of a sheet
  SceneOptions in_effect;  ///< the scene's options, or what the request says instead
  RenderOptions options;
  DisplayRule display;
  Format format = Format::png;
  bool takes_codes = false;  ///< the bytes are the pixels' codes (PNG) or light in floats, row by
                             ///< row, and no file
  bool takes_light = false;  ///< the bytes are the pixels' light in floats, and no file
  LayerSet layers = {};      ///< of an exr, which alone has any
  std::optional<GazeCount> gaze = {};     ///< the points that rays go through, of one for a gaze
  const PictureRequest* asked = nullptr;  ///< the request
  int fewest_samples = 1;                 ///< that a pixel has in any case
  std::string recipe = {};       ///< what POST /render would draw the same picture from (recipe.h)
  std::string rounds_name = {};  ///< of what its rounds come to (recipe.h); empty: of no use again
  std::string cost_key = {};     ///< what tells how much one of its rays takes (draw.h)

  /// Whether the picture has several views, or is mixed of them.
  bool has_several() const { return scene->sheet || has_display(scene->camera); }
  bool is_mixed() const { return !scene->sheet && views.is_mixed(); }
  /// The pixels that are traced: with a margin where they are denoised and the picture goes on; of
  /// several views without their margins.
  Window traced() const {
    if (!options.denoise || has_several()) return window;
    return window.grown(denoise_margin, view.width, view.height);
  }
  /// How many points rays go through: of what is mixed, each pixel of each view.
  std::int64_t points() const {
    if (gaze) return gaze->all();
    const auto mixed = static_cast<std::int64_t>(is_mixed() ? views.views.size() : 1);
    return std::int64_t{traced().width()} * traced().height() * mixed;
  }
  /// The rays that the eye sends out: the fewest with a threshold, the most with noise.
  double rays() const {
    return static_cast<double>(points()) * least_samples(options.samples, options.threshold);
  }
  /// Those that it sends out in any case.
  double sure_rays() const { return static_cast<double>(points()) * fewest_samples; }
};

}  // namespace tia::server
