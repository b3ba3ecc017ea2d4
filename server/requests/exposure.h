// What the samples of a picture are of: one plain scene, or those of the strata of its open time.
#pragma once

#include <cstddef>
#include <vector>

#include "server/requests/render_context.h"

namespace tia::server {

/// Exposure. A picture of one moment has one scene and one stratum.
struct Exposure {
  KnownScene moving;   ///< whose moments they are (exposed_scene); null: of a picture of one moment
  double seconds = 0;  ///< the frame's own time
  std::vector<KnownScene> scenes;   ///< plain, no two in a row the same
  std::vector<std::size_t> strata;  ///< of each stratum of time, which of them

  bool blurs() const { return strata.size() > 1; }
  int blur_steps() const { return static_cast<int>(strata.size()); }
};

/// That of the scene which has been found, with as many strata as the options want, at most one a
/// sample; in_effect.blur_steps stays where that is not as usual. One moment where nothing moves
/// while the shutter is open. Errors: InputError at /blur_steps; as scene_at.
Exposure exposure_of(const TraceRequest& asked, const FoundScene& found, SceneOptions& in_effect,
                     const RenderContext& context, const Requester& requester);

/// The worlds of its scenes. Errors: as GeometryStore::compile.
std::vector<World> worlds_of(const Exposure& exposure, const RenderContext& context,
                             const Workers& workers);

}  // namespace tia::server
