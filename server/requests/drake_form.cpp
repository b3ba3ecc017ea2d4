#include "server/requests/drake_form.h"

#include <algorithm>
#include <utility>

#include "core/film/tonemap.h"
#include "core/input/utf8.h"
#include "core/models/multipart.h"
#include "core/scene/pinhole.h"
#include "core/scene/resolve_models.h"
#include "core/scene/still.h"
#include "core/scene/view.h"

namespace tia::server {
namespace {

// Where a color picture shows nothing, as Drake's own renderers have it.
constexpr std::array<double, 3> background_codes{204, 229, 255};

bool is_utf8_field(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = decode_utf8(text).length;
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

Value field_of_part(const FormPart& part, Faults& faults) {
  const std::string_view text(reinterpret_cast<const char*>(part.bytes.data()), part.bytes.size());
  if (is_utf8_field(text)) return field_from_text<DrakeForm>(part.name, text);
  faults.add({FaultKind::malformed, Place{}.at(part.name).pointer(), std::nullopt, "UTF-8"});
  return "";
}

// ---- the scene ----------------------------------------------------------------------------------

Backdrop drake_background() {
  const auto light = [](double code) { return srgb_to_linear(code / 255); };
  return {
      Color{light(background_codes[0]), light(background_codes[1]), light(background_codes[2])}};
}

// The sensor's place, of the node that has camera 0.
Camera sensor_frame(const Object& object, const SharedModel& model) {
  Scene alone;
  alone.objects = {object};
  Faults faults;
  resolve_models(
      alone, [&](const std::string&) { return model; }, faults);
  std::optional<Camera> frame;
  if (faults.empty())
    frame = still_camera(*model->model, alone.objects.get()[0], CameraChoice{0}, {}, faults);
  if (frame) return *frame;
  std::vector<Fault> list = faults.list();
  for (Fault& fault : list) fault.pointer = "/scene";
  throw InputError(std::move(list));
}

Camera sensor_camera(const DrakeForm& form, const Camera& frame) {
  Camera camera = seen_through({form.focal_x, form.focal_y, form.center_x, form.center_y}, frame,
                               form.width, form.height);
  camera.near = form.near;
  camera.far = form.far;
  Faults faults;
  Camera again;
  read_value(write_value(camera), Place{}, Spec{}, faults, again);
  if (faults.within("/location"))
    throw InputError({FaultKind::out_of_range, "/scene", write_value(camera.location),
                      "a camera that is at most 1e9 from the origin"});
  if (!faults.empty())
    throw InputError({FaultKind::out_of_range, "/focal_x", form.focal_x,
                      "focal lengths and a center by which the picture is before the sensor"});
  return again;
}

IntegratorName integrator_of(const DrakeForm& form, const DrakeQuery& query) {
  const bool is_color = form.image_type == SensorImage::color;
  if (query.integrator && (!is_color || !gathers_light(*query.integrator)))
    throw InputError({FaultKind::conflict, "/integrator", write_value(*query.integrator),
                      is_color ? "one that gathers light, for image_type color"
                               : "none: image_type says what is looked for"});
  if (form.image_type == SensorImage::depth) return IntegratorName::planar_depth;
  if (form.image_type == SensorImage::label) return IntegratorName::label;
  return query.integrator.value_or(IntegratorName::path);
}

Scene sensor_scene(const DrakeForm& form, IntegratorName integrator, const std::string& id,
                   const SharedModel& model) {
  PlacedModel placed;
  placed.id = id;
  Object object;
  object.shape = std::move(placed);
  Scene scene;
  scene.camera = sensor_camera(form, sensor_frame(object, model));
  scene.objects = {std::move(object)};
  scene.options.integrator = integrator;
  if (form.image_type != SensorImage::color) return scene;
  // It shines along the view's axis, wherever the picture's centre is.
  const View view = view_of(scene.camera, form.width, form.height);
  StudioLight light =
      studio_light(Studio::headlight, {.view = view.axis, .integrator = integrator});
  scene.lights = std::move(light.lights);
  scene.ambient_light = light.ambient_light;
  scene.backdrop = drake_background();
  const IntegratorRow& row = row_of(integrator);
  if (!row.is_chance()) scene.options.samples = 16;
  return scene;
}

}  // namespace

bool drake_form_tells(std::string_view parameter) {
  for (const std::string_view told : {"scene", "key", "light", "camera", "width", "height", "crop",
                                      "format", "depth_range", "time", "frame"})
    if (parameter == told) return true;
  return false;
}

void DrakeForm::check(const Place& at, Faults& faults) const {
  const auto fault = [&](FaultKind kind, const char* field, std::optional<Value> got,
                         const char* allowed) {
    faults.add({kind, at.at(field).pointer(), std::move(got), allowed});
  };
  if (!(near < far)) fault(FaultKind::out_of_range, "far", far, "more than near");
  const bool is_depth = image_type == SensorImage::depth;
  const auto depth = [&](const char* field, const std::optional<double>& is, const char* about) {
    if (is_depth && !is) fault(FaultKind::missing, field, std::nullopt, about);
    if (!is_depth && is) fault(FaultKind::conflict, field, *is, "none: it goes with depth alone");
  };
  depth("min_depth", min_depth, "the least depth that is measured, for image_type depth");
  depth("max_depth", max_depth, "the greatest depth that is measured, for image_type depth");
  if (is_depth && min_depth && max_depth && *min_depth > *max_depth)
    fault(FaultKind::out_of_range, "max_depth", *max_depth, "not less than min_depth");
}

SentForm read_drake_form(std::string_view body, std::string_view boundary,
                         const std::stop_token& stop) {
  Faults faults(stop);
  const ModelBytes bytes{reinterpret_cast<const std::uint8_t*>(body.data()), body.size()};
  SentForm sent;
  Value::Object fields;
  for (const FormPart& part : parse_multipart(bytes, boundary, faults)) {
    if (find(fields, part.name) != nullptr)
      faults.add(
          {FaultKind::malformed, Place{}.at(part.name).pointer(), std::nullopt, "each field once"});
    else if (part.name == "scene") fields.emplace_back(part.name, ""), sent.scene = part.bytes;
    else fields.emplace_back(part.name, field_of_part(part, faults));
  }
  faults.raise();
  sent.form = read_described<DrakeForm>(fields, {}, stop);
  return sent;
}

PictureRequest drake_picture(const DrakeForm& form, const DrakeQuery& query, const std::string& id,
                             const SharedModel& model) {
  PictureRequest picture = query;
  const IntegratorName integrator = integrator_of(form, query);
  picture.scene = sensor_scene(form, integrator, id, model);
  picture.along = {id, model};
  picture.width = form.width;
  picture.height = form.height;
  if (form.image_type != SensorImage::depth) return picture;
  picture.format = Format::tiff;
  picture.depth_range = {*form.min_depth, *form.max_depth};
  return picture;
}

}  // namespace tia::server
