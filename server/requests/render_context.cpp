#include "server/requests/render_context.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/input/nearest_listed.h"
#include "core/input/object_schema.h"
#include "core/scene/at_time.h"
#include "core/scene/read_scene.h"
#include "core/scene/resolve_models.h"
#include "server/contract/problem.h"
#include "server/stores/gallery_models.h"
#include "server/stores/model_upload.h"

namespace tia::server {
namespace {

// For what lives longer than the request.
SharedScene not_owned(const Scene& scene) { return {SharedScene(), &scene}; }

// The scene as change() makes it anew, with the same objects.
template <class Change>
KnownScene changed(const KnownScene& scene, const RenderContext& context,
                   const Requester& requester, const Change& change) {
  return context.go_through(scene.others, requester, [&] {
    return KnownScene{std::make_shared<const Scene>(change()), scene.objects, scene.others,
                      scene.models};
  });
}

// Whether somebody has looked up already what all models stand for.
bool are_shown(const std::vector<Object>& objects) {
  return std::ranges::all_of(objects, [](const Object& object) {
    if (const auto* model = std::get_if<PlacedModel>(&object.shape)) return model->shown != nullptr;
    const auto* group = std::get_if<Group>(&object.shape);
    return group == nullptr || are_shown(group->children);
  });
}

// The scene with what its models stand for. What reads one again works alone: all are there before
// this does.
KnownScene with_models(const KnownScene& scene, const ModelAlong& along,
                       const RenderContext& context, const Requester& requester) {
  std::map<std::string, SharedModel> models;
  std::size_t bytes = 0;
  for (const std::string& id : models_in(*scene)) {
    SharedModel& model = models[id];
    model = along.model && id == along.id ? along.model : find_model(id, context, requester);
    if (model) bytes += bytes_of(*model);
  }
  if (models.empty()) return scene;
  if (are_shown(scene->objects.get())) return {scene.scene, scene.objects, scene.others, bytes};
  return context.go_through(scene.others + bytes, requester, [&] {
    auto shown = std::make_shared<Scene>(*scene);
    Faults faults(requester.stop);
    const Place all{};
    resolve_models(
        *shown, [&](const std::string& id) { return models.at(id); }, faults, {}, all.at("scene"));
    faults.raise();
    return KnownScene{std::move(shown), scene.objects, scene.others, bytes};
  });
}

// The request's own, which may be large.
KnownScene told(const Scene& scene, const RenderContext& context, const Requester& requester) {
  KnownScene made;
  Flow flow{requester.number()};
  context.pool.alone([&] { made = known(not_owned(scene)); }, requester.stop, &flow);
  return made;
}

// A display of a named type replaces whatever display there is: its fields are of no other kind.
bool names_display(const CameraPatch& patch) {
  const Value* display = find(patch.members, "display");
  const auto* members = display != nullptr ? display->as<Value::Object>() : nullptr;
  return members != nullptr && find(*members, "type") != nullptr;
}

Camera patched(Camera camera, const CameraPatch& patch) {
  const Place all{}, at = all.at("camera");
  if (names_display(patch)) camera.display.reset();
  return read_described<Camera>(merge_patch(write_value(camera), patch.members), at);
}

// ---- what others of a farm were sent, kept here as if it had been sent to this one -------------

SharedModel taken_model(const std::string& id, const std::string& packed,
                        const RenderContext& context, const Requester& requester) {
  const auto upload = unpacked_upload(id, packed);
  if (!upload) throw StorageError("the model " + id + " is damaged where a farm keeps it");
  return context.models->keep(*upload, requester).known.model;
}

KnownScene taken_scene(const std::string& id, const std::string& text, const RenderContext& context,
                       const Requester& requester) {
  return context.go_through(text.size(), requester, [&] {
    constexpr JsonLimits any{.values = std::numeric_limits<std::size_t>::max()};
    const NewScene made(
        read_described<Scene>(parse_json(text, any, requester.stop), {}, requester.stop));
    if (made.id != id) throw StorageError("the scene " + id + " is damaged where a farm keeps it");
    context.kept.keep(made);
    return made.scene;
  });
}

}  // namespace

bool is_at_hand(const std::string& name, const RenderContext& context) {
  return context.gallery.has(name) || context.kept.is_at_hand(name);
}

SharedModel find_model(const std::string& name, const RenderContext& context,
                       const Requester& requester) {
  if (context.models == nullptr) return nullptr;
  SharedModel model = context.models->find(name, requester).model;
  if (gallery_model(name) != nullptr) return model;
  const std::string lent = "models/" + name;
  if (!model && context.elsewhere != nullptr && is_model_id(name))
    if (const auto packed = (*context.elsewhere)(lent))
      model = taken_model(name, *packed, context, requester);
  if (model && context.named != nullptr) context.named->insert(lent);
  return model;
}

KnownScene find_scene(const std::string& name, const RenderContext& context,
                      const Requester& requester) {
  if (KnownScene scene = context.gallery.find(name)) return scene;
  KnownScene kept = context.kept.find(name, requester);
  const std::string lent = "scenes/" + name;
  if (!kept && context.elsewhere != nullptr && is_model_id(name))
    if (const auto text = (*context.elsewhere)(lent))
      kept = taken_scene(name, *text, context, requester);
  if (kept && context.named != nullptr) context.named->insert(lent);
  if (kept) return kept;
  const std::vector<std::string_view> known = context.gallery.names();
  throw InputError(
      {FaultKind::unknown_name, "/scene", Value(name),
       "a scene's name (" + nearest_listed(name, known) +
           "; GET /scenes has all), the id of a scene that is still kept, or a whole scene",
       nearest_name(name, known)});
}

KnownScene changed_scene_of(const ViewRequest& asked, const RenderContext& context,
                            const Requester& requester) {
  const auto* name = std::get_if<std::string>(&asked.scene);
  KnownScene scene = name != nullptr ? find_scene(*name, context, requester)
                                     : told(std::get<Scene>(asked.scene), context, requester);
  scene = with_models(scene, asked.along, context, requester);
  if (asked.camera)
    scene = changed(scene, context, requester, [&] {
      Scene patched_scene = *scene;
      patched_scene.camera = patched(scene->camera, *asked.camera);
      return patched_scene;
    });
  if (asked.key && !moves_light_only(*scene, *asked.key)) {
    const bool is_named = name != nullptr && !asked.camera;
    scene = context.pressed.get(is_named ? *name : "", scene, *asked.key, requester);
    return with_models(scene, asked.along, context, requester);
  }
  if (!asked.key && !asked.light) return scene;
  const auto middles = context.pressed.middles_of(scene, requester);
  return changed(scene, context, requester, [&] {
    return asked.key ? press(*scene, *asked.key, *middles)
                     : with_light(*scene, *asked.light, *middles);
  });
}

KnownScene scene_in_motion(const KnownScene& scene, const RenderContext& context,
                           const Requester& requester) {
  if (!scene->physics) return scene;
  const auto simulation =
      context.pressed.simulation_of(scene, context.limits.max_events, requester);
  const std::size_t bytes = scene.others + scene.objects.bytes + bytes_of(*simulation);
  return context.go_through(bytes, requester, [&] {
    // At the time 0 all is where it was, and so the middles of its objects are the same.
    return KnownScene{std::make_shared<const Scene>(with_motion(*scene, *simulation)),
                      scene.objects, scene.others + bytes_of(*simulation), scene.models};
  });
}

KnownScene moving_scene_of(const ViewRequest& asked, const RenderContext& context,
                           const Requester& requester) {
  return scene_in_motion(changed_scene_of(asked, context, requester), context, requester);
}

KnownScene scene_at(const KnownScene& moving, double seconds, const ModelAlong& along,
                    const RenderContext& context, const Requester& requester) {
  const Animation& animation = *moving->animation;
  const PressedScenes::SharedMiddles middles =
      moves_key_light(animation) ? context.pressed.middles_of(moving, requester) : nullptr;
  const bool objects = moves_objects(animation);
  const std::size_t bytes = moving.others + (objects ? moving.objects.bytes : 0);
  const KnownScene plain = context.go_through(bytes, requester, [&] {
    const Place all{};
    auto made = std::make_shared<const Scene>(
        at_time(*moving, seconds, middles ? *middles : Middles{}, all.at("scene"), requester.stop));
    if (objects) return known(std::move(made));
    return KnownScene{std::move(made), moving.objects, moving.others, moving.models};
  });
  return with_models(plain, along, context, requester);
}

FoundScene found_scene(const ViewRequest& asked, const RenderContext& context,
                       const Requester& requester) {
  const KnownScene scene = moving_scene_of(asked, context, requester);
  if (scene->animation) {
    const double seconds = asked.seconds_in(*scene->animation);
    return {scene_at(scene, seconds, asked.along, context, requester), scene, seconds};
  }
  if (asked.is_asked())
    throw InputError({FaultKind::conflict, asked.time ? "/time" : "/frame",
                      asked.time ? Value(*asked.time) : Value(*asked.frame),
                      "a scene with an animation or physics; this one does not move"});
  return {scene, {}, 0};
}

RenderOptions options_of(const SceneOptions& in_effect, const Limits& limits) {
  RenderOptions options;
  options.integrator = in_effect.integrator;
  options.max_depth = in_effect.max_depth.value_or(row_of(in_effect.integrator).max_depth);
  options.ao_radius = in_effect.ao_radius.value_or(options.ao_radius);
  options.clamp = in_effect.clamp.value_or(options.clamp);
  options.samples = in_effect.samples.value_or(in_effect.usual_samples());
  options.threshold = in_effect.threshold.value_or(0);
  options.noise = in_effect.noise.value_or(0);
  options.tone = in_effect.tone();
  options.seed = in_effect.seed;
  options.max_rays = limits.max_rays;
  options.max_work = limits.max_work;
  return options;
}

}  // namespace tia::server
