#include "server/requests/stream_change.h"

#include "server/stores/scene_bytes.h"

namespace tia {

void Codec<server::ScenePatch>::read(const Value& v, const Place& at, const Spec& spec,
                                     Faults& faults, server::ScenePatch& out) {
  const auto* members = v.as<Value::Object>();
  if (members == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
  out.members = *members;
}

}  // namespace tia

namespace tia::server {
namespace {

// Written, patched and read again.
Scene patched(const Scene& scene, const ScenePatch& patch, const RenderContext& context,
              const Requester& requester) {
  const std::size_t bytes = bytes_of(scene);
  const std::int64_t memory = memory_for(memory_cost::patch, bytes);
  return context.long_work({bytes, memory, "the scene with its patch"}, requester, [&] {
    const Place all{};
    return read_described<Scene>(merge_patch(write_value(scene), patch.members), all.at("scene"),
                                 requester.stop);
  });
}

}  // namespace

void StreamChange::check(const Place& at, Faults& faults) const {
  Moment::check(at, faults);
  if (key && light)
    faults.add(
        {FaultKind::conflict, at.at("light").pointer(), write_value(*light), "key or light"});
}

RenderRequest changed_by(const StreamChange& change, RenderRequest request,
                         const RenderContext& context, const Requester& requester) {
  if (change.scene) {
    const auto* name = std::get_if<std::string>(&request.scene);
    const KnownScene found = name ? find_scene(*name, context, requester) : KnownScene{};
    request.scene =
        patched(name ? *found : std::get<Scene>(request.scene), *change.scene, context, requester);
  }
  if (change.camera) request.camera = change.camera;
  if (change.gaze) request.gaze = change.gaze;
  if (change.key || change.light) {
    request.key = change.key;
    request.light = change.light;
  }
  if (change.is_asked()) static_cast<Moment&>(request) = change;
  return request;
}

}  // namespace tia::server
