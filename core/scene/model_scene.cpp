#include "core/scene/model_scene.h"

#include "core/models/pose.h"
#include "core/scene/model_lights.h"
#include "core/scene/model_place.h"
#include "core/scene/resolve_models.h"
#include "core/scene/still.h"
#include "core/scene/still_points.h"

namespace tia {
namespace {

Object shown_alone(const SharedModel& model, const std::string& id, const std::stop_token& stop) {
  PlacedModel placed;
  placed.id = id;
  Scene alone;
  alone.objects = {{"", std::move(placed), {}, {}}};
  Faults faults(stop);
  resolve_models(
      alone, [&](const std::string&) { return model; }, faults);
  if (!faults.empty()) throw InputError(faults.list());
  return alone.objects.get()[0];
}

StillPoints points_in(const Object& object) {
  StillPoints points = points_of(*std::get<PlacedModel>(object.shape).shown);
  if (points.empty()) points.corners.push_back({});  // a scene of the file that shows nothing
  return points;
}

std::optional<Camera> first_shown_camera(const Model& model, const Object& object) {
  std::optional<Camera> camera;
  for (std::size_t i = 0; i < model.cameras.size() && !camera; ++i) {
    Faults not_shown;
    camera = still_camera(model, object, static_cast<int>(i), {}, not_shown);
  }
  return camera;
}

}  // namespace

Scene model_scene(const SharedModel& model, const std::string& id, double aspect,
                  const std::stop_token& stop) {
  const Model& file = *model->model;
  StillBody body;
  body.objects = {shown_alone(model, id, stop)};
  body.points = points_in(body.objects[0]);
  body.camera = first_shown_camera(file, body.objects[0]);
  StillRequest request;
  request.studio = Studio::neutral;
  request.ground = Ground::none;
  Scene scene = still_scene(request, std::move(body), aspect);
  scene.backdrop.reset();
  const Affine to_scene = upright(file.z_up ? UpAxis::z : UpAxis::y);
  if (auto lights = model_lights(file, pose_of(file), to_scene); !lights.empty())
    scene.lights = std::move(lights);
  return scene;
}

}  // namespace tia
