// What a request's words stand for: its scene, found and changed as it says, and its options.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "core/render/render.h"
#include "core/scene/limits.h"
#include "server/operation/long_work.h"
#include "server/operation/memory_costs.h"
#include "server/operation/requester.h"
#include "server/requests/view_request.h"
#include "server/stores/gallery.h"
#include "server/stores/geometry_store.h"
#include "server/stores/model_store.h"
#include "server/stores/pressed_scenes.h"
#include "server/stores/scene_store.h"

namespace tia::server {

/// OutsideEncoder: the program ffmpeg, where there is one.
struct OutsideEncoder {
  std::string program;  ///< "" = none
  unsigned cpu_s = 600;
};

/// Elsewhere: what clients have sent to others of a farm: "models/ID" packed, "scenes/ID" as
/// canonical text; or none. Errors: StorageError.
using Elsewhere = std::function<std::optional<std::string>(const std::string& name)>;

/// What every picture needs of its host.
struct RenderContext {
  const Gallery& gallery;
  SceneStore& kept;
  GeometryStore& geometries;
  PressedScenes& pressed;
  Pool& pool;
  LongWork& long_work;
  Limits limits;
  ModelStore* models = nullptr;            ///< null: none are kept
  OutsideEncoder ffmpeg{};                 ///< of films
  const Elsewhere* elsewhere = nullptr;    ///< asked for what is not here; null: nobody is
  std::set<std::string>* named = nullptr;  ///< told by such names what was asked for and found

  /// Does what copies or writes so many bytes of a scene: as long work, unless they are few.
  /// Returns: what it does. Errors: as LongWork, and whatever it throws.
  template <class Work>
  auto go_through(std::size_t bytes, const Requester& requester, const Work& work) const {
    constexpr std::size_t few = 16 << 10;  // a tenth of a millisecond
    if (bytes <= few) return work();
    return long_work({bytes, memory_for(memory_cost::patch, bytes), "what the scene says"},
                     requester, work);
  }
};

/// Whether there is a scene of that name or id in memory, and nothing else has to be asked.
bool is_at_hand(const std::string& name, const RenderContext& context);

/// The scene of that name or id. Errors: InputError (unknown_name) at /scene; as SceneStore::find.
KnownScene find_scene(const std::string& name, const RenderContext& context,
                      const Requester& requester);

/// The model of that id or, in the gallery, of that name; or null. Errors: as ModelStore::find.
SharedModel find_model(const std::string& name, const RenderContext& context,
                       const Requester& requester);

/// The scene that is asked for, in all of its time: with what its models stand for, with its camera
/// patched, its key pressed or its light moved. Errors: as scene_of.
KnownScene changed_scene_of(const ViewRequest& asked, const RenderContext& context,
                            const Requester& requester);

/// The same with tracks in the place of its physics, where it has bodies that move.
/// Errors: as PressedScenes::simulation_of.
KnownScene scene_in_motion(const KnownScene& scene, const RenderContext& context,
                           const Requester& requester);

/// Both: the scene that is asked for, with its animation, if it moves. Errors: as scene_of.
KnownScene moving_scene_of(const ViewRequest& asked, const RenderContext& context,
                           const Requester& requester);

/// FoundScene: a scene, and what it is the moment of.
struct FoundScene {
  KnownScene plain;    ///< without an animation
  KnownScene moving;   ///< null: it has none
  double seconds = 0;  ///< the time
};

/// The scene that is asked for, its bodies' motion found, then at the moment that is asked for. It
/// may be the request's own, and lives no longer. Errors: InputError; as PressedScenes::get,
/// ModelStore::find.
FoundScene found_scene(const ViewRequest& asked, const RenderContext& context,
                       const Requester& requester);
/// The plain one.
inline KnownScene scene_of(const ViewRequest& asked, const RenderContext& context,
                           const Requester& requester) {
  return found_scene(asked, context, requester).plain;
}

/// The plain scene of a time, with what its models stand for. Domain: a scene with an animation.
/// Errors: InputError, as at_time; as ModelStore::find.
KnownScene scene_at(const KnownScene& moving, double seconds, const ModelAlong& along,
                    const RenderContext& context, const Requester& requester);

/// How light is traced by options in effect, within the limits.
RenderOptions options_of(const SceneOptions& in_effect, const Limits& limits);

}  // namespace tia::server
