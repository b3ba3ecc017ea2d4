#include "server/requests/studio.h"

#include "core/input/object_schema.h"

namespace tia::server {
namespace {

// For what lives longer than the request.
SharedScene not_owned(const Scene& scene) { return {SharedScene(), &scene}; }

// The scene as change() makes it anew, with the same objects.
template <class Change>
KnownScene changed(const KnownScene& scene, const Studio& studio, const Asker& asker,
                   const Change& change) {
  return studio.go_through(scene.others, asker, [&] {
    return KnownScene{std::make_shared<const Scene>(change()), scene.objects, scene.others};
  });
}

// The request's own, which may be large.
KnownScene told(const Scene& scene, const Studio& studio, const Asker& asker) {
  KnownScene made;
  Flow flow{asker.number()};
  studio.pool.alone([&] { made = known(not_owned(scene)); }, asker.stop, &flow);
  return made;
}

Camera patched(const Camera& camera, const CameraPatch& patch) {
  const Place all{}, at = all.at("camera");
  return read_described<Camera>(merge_patch(write_value(camera), patch.members), at);
}

}  // namespace

bool is_at_hand(const std::string& name, const Studio& studio) {
  return studio.gallery.find(name) || studio.kept.is_at_hand(name);
}

KnownScene find_scene(const std::string& name, const Studio& studio, const Asker& asker) {
  if (KnownScene scene = studio.gallery.find(name)) return scene;
  if (KnownScene scene = studio.kept.find(name, asker)) return scene;
  const std::vector<std::string_view> known = studio.gallery.names();
  throw InputError({FaultKind::unknown_name, "/scene", Value(name),
                    "a scene's name (" + listed(known) +
                        "), the id of a scene that is still kept, or a whole scene",
                    nearest_name(name, known)});
}

KnownScene scene_of(const ViewRequest& asked, const Studio& studio, const Asker& asker) {
  const auto* name = std::get_if<std::string>(&asked.scene);
  KnownScene scene = name != nullptr ? find_scene(*name, studio, asker)
                                     : told(std::get<Scene>(asked.scene), studio, asker);
  if (asked.camera)
    scene = changed(scene, studio, asker, [&] {
      Scene patched_scene = *scene;
      patched_scene.camera = patched(scene->camera, *asked.camera);
      return patched_scene;
    });
  if (asked.key && !moves_light_only(*scene, *asked.key)) {
    const bool is_named = name != nullptr && !asked.camera;
    return studio.pressed.get(is_named ? *name : "", scene, *asked.key, asker);
  }
  if (!asked.key && !asked.light) return scene;
  const auto middles = studio.pressed.middles_of(scene, asker);
  return changed(scene, studio, asker, [&] {
    return asked.key ? press(*scene, *asked.key, *middles)
                     : with_light(*scene, *asked.light, *middles);
  });
}

RenderOptions options_of(const TraceRequest& asked, const Scene& scene, const Studio& studio) {
  const SceneOptions& own = scene.options;
  RenderOptions options;
  options.integrator = asked.integrator.value_or(own.integrator);
  options.max_depth = asked.max_depth.value_or(own.max_depth);
  if (averages(options.integrator)) {
    options.samples = asked.samples ? *asked.samples : own.samples.value_or(1);
    options.threshold = asked.threshold ? *asked.threshold : own.threshold.value_or(0);
  }
  options.seed = asked.seed.value_or(own.seed);
  options.max_rays = studio.limits.max_rays;
  options.max_work = studio.limits.max_work;
  return options;
}

}  // namespace tia::server
