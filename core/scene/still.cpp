#include "core/scene/still.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/models/pose.h"
#include "core/scene/model_objects.h"

namespace tia {
namespace {

// What a floor sends back of light.
constexpr double floor_albedo = 0.5;
// The widest view that a camera may have; files say up to 180 degrees.
constexpr double widest_degrees = 179;

// A finish that sends back all of ambient_light, as studio_light wants it.
Object floor_below(const StillPoints& points) {
  Finish finish;
  finish.color = {floor_albedo, floor_albedo, floor_albedo};
  finish.ambient = 1;
  Object floor;
  floor.name = "floor";
  floor.shape = Plane{{0, lowest_of(points), 0}, {0, 1, 0}};
  floor.material = MaterialRef(Material{finish});
  return floor;
}

/// StillEye: a camera and the azimuth that its studio stands at.
struct StillEye {
  Camera camera;
  double azimuth_degrees;
};

std::vector<StillEye> turning(const StillRequest& request, const StillPoints& points,
                              double aspect) {
  std::vector<double> azimuths;
  std::vector<Basis> axes;
  for (int i = 0; i < *request.turntable; ++i) {
    azimuths.push_back(request.orbit[0] + 360.0 * i / *request.turntable);
    axes.push_back(orbit_basis(azimuths.back(), request.orbit[1]));
  }
  const std::vector<Camera> cameras =
      framed_alike(points, axes, {{}, request.fov, request.zoom, aspect});
  std::vector<StillEye> eyes;
  for (std::size_t i = 0; i < cameras.size(); ++i) eyes.push_back({cameras[i], azimuths[i]});
  return eyes;
}

std::vector<StillEye> eyes_of(const StillRequest& request, const StillBody& body, double aspect) {
  if (body.camera) {
    // Where it looks from; straight down that is its back's side.
    const Vec3d view = unit(axis_of(*body.camera));
    return {{*body.camera, atan2_of(-view.x, -view.z) * (180 / pi)}};
  }
  if (request.turntable) return turning(request, body.points, aspect);
  const Basis axes = orbit_basis(request.orbit[0], request.orbit[1]);
  return {{framed(body.points, {axes, request.fov, request.zoom, aspect}), request.orbit[0]}};
}

// As many columns as rows, or one more.
int columns_of(const StillRequest& request, int views) {
  int columns = 1;
  while (columns * columns < views) ++columns;
  return request.columns.value_or(columns);
}

bool is_chosen(const Model& model, ModelIndex camera, const CameraChoice& choice) {
  if (const auto* number = std::get_if<int>(&choice)) return *number == static_cast<int>(camera);
  return model.cameras[camera].name == std::get<std::string>(choice);
}

// The cameras that there are, in words.
std::string cameras_of(const Model& model, const Pose& pose) {
  std::string numbers;
  std::vector<std::string_view> names;
  for (const ModelIndex node : pose.shown) {
    const MaybeIndex camera = model.nodes[node].camera;
    if (!camera) continue;
    numbers.append(numbers.empty() ? "" : ", ").append(std::to_string(*camera));
    if (const std::string& name = model.cameras[*camera].name; !name.empty()) names.push_back(name);
  }
  if (numbers.empty()) return "none; the model shows no camera";
  return "one of the model's cameras, " + excerpt_of(numbers, 240) +
         (names.empty() ? "" : ", or by its name, " + listed(names));
}

Camera camera_at(const ModelCamera& own, const Affine& place) {
  Camera camera;
  camera.location = place.offset;
  camera.direction = unit(place.z) * -1.0;
  camera.up = unit(place.y);
  if (own.orthographic) {
    camera.projection = Projection::orthographic;
    camera.height = 2 * std::fabs(own.ymag) * length(place.y);
  } else {
    camera.fov_degrees = std::min(own.yfov * (180 / pi), widest_degrees);
  }
  return camera;
}

}  // namespace

void Codec<CameraChoice>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                               CameraChoice& out) {
  if (v.as<std::string>() != nullptr) read_value(v, at, spec, faults, out.emplace<std::string>());
  else if (v.as<double>() != nullptr) read_value(v, at, spec, faults, out.emplace<int>());
  else detail::wrong_type(v, at, allowed(spec), faults);
}
Value Codec<CameraChoice>::write(const CameraChoice& v) {
  return std::visit([](const auto& is) { return write_value(is); }, v);
}
Value Codec<CameraChoice>::schema(const Spec& spec, Definitions& named) {
  return Value::Object{
      {"oneOf", Value::Array{schema_of<int>(spec, named), schema_of<std::string>(spec, named)}}};
}
std::string Codec<CameraChoice>::allowed(const Spec& spec) {
  return Codec<int>::allowed(spec) + ", or " + Codec<std::string>::allowed(spec);
}

void StillRequest::check(const Place& at, Faults& faults) const {
  const StillRequest usual;
  if (std::fabs(orbit[1]) > 90)
    faults.add({FaultKind::out_of_range, at.at("orbit").at(std::size_t{1}).pointer(), orbit[1],
                "an elevation from -90 to 90 degrees"});
  if (fov > 0 && fov < least_fov)
    faults.add({FaultKind::out_of_range, at.at("fov").pointer(), fov,
                "0, which is parallel, or 1 to 170 degrees"});
  const auto refuse = [&](const char* field, const Value& got, const std::string& allowed) {
    faults.add({FaultKind::conflict, at.at(field).pointer(), got, allowed});
  };
  if (camera && turntable) refuse("turntable", *turntable, "turntable goes without camera");
  if (columns && !turntable) refuse("columns", *columns, "columns goes with turntable");
  if (columns && turntable && *columns > *turntable)
    refuse("columns", *columns, "at most as many columns as views, " + std::to_string(*turntable));
  if (camera && (orbit != usual.orbit || zoom != usual.zoom || fov != usual.fov))
    refuse("camera", write_value(*camera), "camera goes without orbit, zoom and fov");
}

std::optional<Camera> still_camera(const Model& model, const Object& object,
                                   const CameraChoice& choice, const Place& at, Faults& faults) {
  Faults none;
  const ModelChoice shown = choice_of(model, object, {}, none);
  const Pose pose = pose_of(model, shown.moment);
  const auto node = std::ranges::find_if(pose.shown, [&](ModelIndex number) {
    const MaybeIndex camera = model.nodes[number].camera;
    return camera && is_chosen(model, *camera, choice);
  });
  if (node == pose.shown.end()) {
    faults.add({FaultKind::unknown_name, at.pointer(), excerpt(write_value(choice)),
                cameras_of(model, pose)});
    return std::nullopt;
  }
  ModelBudget budget;
  const Aabb box = bounds_of(pieces_of(model, shown, budget, nullptr));
  const Affine map = map_of(std::get<PlacedModel>(object.shape), shown, box);
  return camera_at(model.cameras[*model.nodes[*node].camera], map * pose.places[*node]);
}

Scene still_scene(const StillRequest& request, StillBody body, double aspect,
                  IntegratorName integrator) {
  const StillBall ball = ball_around(body.points);
  Scene scene;
  Sheet sheet;
  for (const StillEye& eye : eyes_of(request, body, aspect)) {
    StudioLight light = studio_light(
        request.studio, {ball, eye.azimuth_degrees, unit(axis_of(eye.camera)), integrator});
    scene.ambient_light = light.ambient_light;
    sheet.views.push_back({eye.camera, std::move(light.lights)});
  }
  scene.camera = sheet.views[0].camera;
  scene.lights = sheet.views[0].lights;
  if (request.turntable) {
    sheet.columns = columns_of(request, *request.turntable);
    scene.sheet = std::move(sheet);
  }
  if (request.ground == Ground::shadow)
    scene.shadow_ground = ShadowGround{{0, lowest_of(body.points), 0}, {0, 1, 0}};
  scene.backdrop = request.background;
  scene.objects = std::move(body.objects);
  if (request.ground == Ground::floor) scene.objects.push_back(floor_below(body.points));
  scene.options.integrator = integrator;
  return scene;
}

}  // namespace tia
