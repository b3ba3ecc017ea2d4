#include "server/requests/still_query.h"

#include "core/input/described.h"
#include "core/scene/resolve_models.h"
#include "core/scene/still_points.h"

namespace tia::server {
namespace {

constexpr std::string_view of_object = "/objects/0", of_options = "/options";

// Faults of a scene of one model, at the parameters that the scene was made from.
InputError of_parameters(std::vector<Fault> faults) {
  for (Fault& fault : faults)
    for (const std::string_view stem : {of_object, of_options})
      if (fault.pointer.starts_with(stem)) fault.pointer.erase(0, stem.size());
  return InputError(std::move(faults));
}
void raise(const Faults& faults) {
  if (!faults.empty()) throw of_parameters(faults.list());
}

Object placed_of(const StillParameters& asked) {
  PlacedModel placed = asked;
  // A studio's sky is ambient light to whatever does not follow paths.
  if (asked.integrator_in_effect() != IntegratorName::path) placed.ambient = 1;
  Object object;
  object.shape = std::move(placed);
  return object;
}

StillBody body_of(const StillParameters& asked, const SharedModel& model,
                  const std::stop_token& stop) {
  Faults faults(stop);
  Scene alone;
  alone.objects = {placed_of(asked)};
  resolve_models(
      alone, [&](const std::string&) { return model; }, faults);
  raise(faults);
  StillBody body;
  body.objects = alone.objects.get();
  body.points = points_of(*std::get<PlacedModel>(body.objects[0].shape).shown);
  if (body.points.empty())
    throw InputError({FaultKind::missing, asked.hide.empty() ? "/scene" : "/hide", std::nullopt,
                      "what leaves a triangle or a point of the model to be seen"});
  if (asked.StillRequest::camera)
    body.camera = still_camera(*model->model, body.objects[0], *asked.StillRequest::camera,
                               Place{}.at("camera"), faults);
  raise(faults);
  return body;
}

SceneOptions options_of(const StillParameters& asked) {
  SceneOptions options;
  options.integrator = asked.integrator_in_effect();
  const IntegratorRow& row = row_of(options.integrator);
  if (row.gathers_light() && !row.is_chance()) options.samples = 16;
  return options_in_effect<PictureRequest>(options, asked);
}

// As POST /render would read it, but for what the model stands for, which is known. What is told in
// numbers that scenes cannot have is refused here.
Scene read_again(const Scene& scene, const std::stop_token& stop) {
  Faults faults(stop);
  Scene again;
  read_value(write_value(scene), Place{}, Spec{}, faults, again);
  for (const Fault& fault : faults.list())
    if (!fault.pointer.starts_with(of_options))
      throw InputError({FaultKind::out_of_range, "/fit", std::nullopt,
                        "a box for the model, which is too large, too small or too far away for a "
                        "camera and lights around it"});
  raise(faults);
  std::get<PlacedModel>(again.objects.edit()[0].shape).shown =
      std::get<PlacedModel>(scene.objects.get()[0].shape).shown;
  return again;
}

Scene unread_still(const StillParameters& asked, const SharedModel& model,
                   const std::stop_token& stop) {
  const double aspect = static_cast<double>(asked.width) / asked.height;
  Scene scene =
      still_scene(asked, body_of(asked, model, stop), aspect, asked.integrator_in_effect());
  scene.options = options_of(asked);
  return scene;
}

}  // namespace

std::optional<Spec> still_parameter(StillPart of, std::string_view name, const Spec& spec) {
  if (of == StillPart::moment) return std::nullopt;  // a model's own time is PlacedModel's
  if (name == "blur_steps") return std::nullopt;     // a still does not move
  if (of == StillPart::model && (name == "id" || name == "ambient")) return std::nullopt;
  for (const std::string_view other : {"scene", "key", "light", "camera"})
    if (of == StillPart::view && name == other) return std::nullopt;
  Spec as_told = spec;
  if (name == "integrator") as_told.about = "how light is gathered; else path";
  if (name == "samples")
    as_told.about =
        "rays a pixel; 1 goes through its centre; else 64 by path, 16 by whitted and thesis, and "
        "with noise up to 4096";
  return as_told;
}

void StillParameters::check(const Place& at, Faults& faults) const {
  StillRequest::check(at, faults);
  PictureRequest::check(at, faults);
  if (!has_alpha(format) && background.is_transparent() && gathers_light(integrator_in_effect()))
    faults.add({FaultKind::conflict, at.at("format").pointer(), write_value(format),
                alpha_formats() + ", which have alpha, or a background that is a colour"});
}

void ShownStill::check(const Place& at, Faults& faults) const {
  StillParameters::check(at, faults);
  if (stream && as == StillAs::scene)
    faults.add({FaultKind::conflict, at.at("stream").pointer(), write_value(*stream),
                "as=picture, which is drawn"});
}

Scene still_of(const StillParameters& asked, const SharedModel& model,
               const std::stop_token& stop) {
  return read_again(unread_still(asked, model, stop), stop);
}

Scene TurnedStills::at(int n) const {
  const SheetView& view = views[static_cast<std::size_t>(n)];
  Scene scene = first;
  scene.camera = view.camera;
  scene.lights = view.lights;
  return scene;
}

TurnedStills turned_stills_of(StillParameters asked, const SharedModel& model, int views,
                              const std::stop_token& stop) {
  asked.turntable = views;
  Scene scene = unread_still(asked, model, stop);
  std::vector<SheetView> turned = std::move(scene.sheet->views);
  scene.sheet.reset();
  return {read_again(scene, stop), std::move(turned)};
}

}  // namespace tia::server
