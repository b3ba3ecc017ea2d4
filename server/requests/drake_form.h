// The form that Drake's RenderEngineGltfClient sends: a glTF file and the sensor that sees it.
// Source: Drake, "glTF Render Client-Server API", 2022 to 2024.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/models/kept_model.h"
#include "core/models/model_files.h"
#include "server/http/message.h"
#include "server/requests/picture_request.h"

namespace tia::server {

/// What the sensor measures.
enum class SensorImage { color, depth, label };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::SensorImage> {
  static constexpr std::array<std::string_view, 3> names{"color", "depth", "label"};
};

namespace tia::server {

/// DrakeForm: the fields of the form. Space/units: pixels, metres, radians.
struct DrakeForm {
  static constexpr std::string_view schema_name = "drake_form";
  std::string scene;  ///< stands for the file, whose bytes are not copied here
  std::optional<std::string> scene_sha256, submit;
  SensorImage image_type = SensorImage::color;
  int width = 0, height = 0;
  double near = 0, far = 0, focal_x = 0, focal_y = 0, center_x = 0, center_y = 0;
  std::optional<double> fov_x, fov_y, min_depth, max_depth;

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// Planes and depths in the wrong order, depths with what is no depth, and the other way round.
  void check(const Place& at, Faults& faults) const;
};

template <class Visitor>
void DrakeForm::fields(Visitor&& visit) {
  using F = DrakeForm;
  constexpr double most = 1e9;
  const auto number = [&](const char* name, auto member, Spec spec) {
    spec.max = most;
    visit(name, member, spec);
  };
  const auto size = [&](const char* name, auto member, const char* about) {
    number(name, member, Spec{.about = about, .min = 0, .open_min = true, .required = true});
  };
  visit("scene", &F::scene,
        Spec{.about = "glTF, all that it names in data URIs: its first camera's node is the "
                      "sensor's place",
             .required = true});
  visit("scene_sha256", &F::scene_sha256,
        Spec{.about = "where it is 64 hexadecimal digits, the scene's SHA-256"});
  visit("image_type", &F::image_type,
        Spec{.about = "color: RGB in PNG, in a headlight, over 204,229,255; depth: metres along "
                      "the view's axis in TIFF; label: round(255 baseColorFactor) in PNG, white "
                      "where nothing is",
             .required = true});
  for (const auto& [name, member] : {std::pair("width", &F::width), {"height", &F::height}})
    visit(name, member,
          Spec{.about = "the picture's",
               .unit = "pixels",
               .min = 1,
               .max = ViewRequest::most_px,
               .required = true});
  size("near", &F::near, "what is nearer along the view's axis is not seen");
  size("far", &F::far, "what is farther along the view's axis is not seen");
  size("focal_x", &F::focal_x, "focal length, in pixels' widths");
  size("focal_y", &F::focal_y, "focal length, in pixels' heights");
  for (const auto& [name, member] :
       {std::pair("center_x", &F::center_x), {"center_y", &F::center_y}})
    number(name, member,
           Spec{.about = "where the axis meets the picture, from its top left corner",
                .unit = "pixels",
                .min = -most,
                .required = true});
  for (const auto& [name, member] : {std::pair("fov_x", &F::fov_x), {"fov_y", &F::fov_y}})
    number(name, member,
           Spec{.about = "passed over: the focal lengths say it", .unit = "radians", .min = 0});
  number("min_depth", &F::min_depth, Spec{.about = "depth: what is nearer is 0", .min = 0});
  number("max_depth", &F::max_depth, Spec{.about = "depth: what is farther is infinite", .min = 0});
  visit("submit", &F::submit, Spec{.about = "passed over"});
}

/// DrakeQuery: what of /render's parameters may stand in the query beside a form.
struct DrakeQuery : PictureRequest {
  static constexpr std::string_view schema_name = "drake_query";

  template <class Visitor>
  static void fields(Visitor&& visit);
};

/// Whether it is the form that says what this parameter of /render does.
bool drake_form_tells(std::string_view parameter);

/// Visitor: hands fields on but for those that the form says.
template <class Visitor>
struct DrakeQueryFields {
  Visitor& visit;

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) const {
    if (drake_form_tells(name)) return;
    Member DrakeQuery::*const own = member;
    visit(name, own, spec);
  }
};
template <class Visitor>
void DrakeQuery::fields(Visitor&& visit) {
  PictureRequest::fields(DrakeQueryFields<std::remove_reference_t<Visitor>>{visit});
}

/// SentForm: what a body holds; the scene's bytes are in it.
struct SentForm {
  DrakeForm form;
  ModelBytes scene;
};
/// Errors: InputError: malformed as parse_multipart(), of a field that comes twice or is no UTF-8;
/// faults of its fields at their names; Stopped. Domain: `body` outlives it.
SentForm read_drake_form(std::string_view body, std::string_view boundary,
                         const std::stop_token& stop = {});

/// The media type of its picture.
constexpr std::string_view media_type_of(SensorImage image) {
  return media_type_of(image == SensorImage::depth ? Format::tiff : Format::png);
}

/// What the form asks for of a model of that id, with what the query says; by path where it does
/// not say how light is gathered.
/// Errors: InputError: conflict at /integrator of what is no light with an image_type that is; at
/// /scene where it shows no camera or is too far away; at /focal_x where no such view can be.
PictureRequest drake_picture(const DrakeForm& form, const DrakeQuery& query, const std::string& id,
                             const SharedModel& model);

}  // namespace tia::server
