#include "core/scene/model_scene.h"

#include "core/scene/model_lights.h"
#include "core/scene/model_place.h"
#include "core/scene/still.h"

namespace tia {
namespace {

// Balls of the size that a model's points have where its object says nothing of it.
StillPoints points_in(const Model& model, const Pose& pose, const Affine& to_scene) {
  const Aabb box = bounds_of(model, pose);
  StillPoints points = still_points(model, pose, to_scene, length(box.size()) / 500);
  if (points.empty()) points.corners.push_back({});  // a scene of the file that shows nothing
  return points;
}

std::optional<Camera> first_shown_camera(const Model& model, const Pose& pose,
                                         const Affine& to_scene) {
  std::optional<Camera> camera;
  for (std::size_t i = 0; i < model.cameras.size() && !camera; ++i)
    camera = still_camera(model, pose, to_scene, static_cast<int>(i));
  return camera;
}

}  // namespace

Scene model_scene(const Model& model, const std::string& id, double aspect) {
  const Affine to_scene = upright(model.z_up ? UpAxis::z : UpAxis::y);
  const Pose pose = pose_of(model);
  PlacedModel placed;
  placed.id = id;
  StillBody body;
  body.objects = {{"", std::move(placed), {}, {}}};
  body.points = points_in(model, pose, to_scene);
  body.camera = first_shown_camera(model, pose, to_scene);
  StillRequest request;
  request.studio = Studio::neutral;
  Scene scene = still_scene(request, std::move(body), aspect);
  scene.backdrop.reset();
  if (auto lights = model_lights(model, pose, to_scene); !lights.empty())
    scene.lights = std::move(lights);
  return scene;
}

}  // namespace tia
