// The scene that is a still of a model: a camera that frames it, a studio's light, a ground.
// Whoever calls says which objects the model is.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/models/model.h"
#include "core/scene/backdrop.h"
#include "core/scene/scene.h"
#include "core/scene/still_framing.h"
#include "core/scene/still_studio.h"

namespace tia {

/// What a model stands on.
enum class Ground { shadow, floor, none };
template <>
struct Names<Ground> {
  static constexpr std::array<std::string_view, 3> names{"shadow", "floor", "none"};
};

/// One of a file's cameras: its number in the file, from 0, or its name.
using CameraChoice = std::variant<int, std::string>;
template <>
struct Codec<CameraChoice> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   CameraChoice& out);
  static Value write(const CameraChoice& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

/// StillRequest: how a model is to be shown.
struct StillRequest {
  static constexpr std::string_view schema_name = "still";
  static constexpr double least_fov = 1, most_fov = 170;
  std::array<double, 2> orbit{30, 20};
  double zoom = 1, fov = 30;
  Studio studio = Studio::soft;
  Ground ground = Ground::shadow;
  Backdrop background;
  std::optional<CameraChoice> camera;     ///< none: orbit, zoom and fov
  std::optional<int> turntable, columns;  ///< none: one view; as near to a square as can be

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("orbit", &StillRequest::orbit,
          Spec{.about = "where the eye is: azimuth, 0 from the front (+z), 90 from +x, and "
                        "elevation, -90 to 90",
               .unit = "degrees",
               .min = -360,
               .max = 360});
    visit("zoom", &StillRequest::zoom,
          Spec{.about = "how large; at 1 the model touches a frame 5 % inside the picture",
               .min = 0.1,
               .max = 1000});
    visit("fov", &StillRequest::fov,
          Spec{.about = "vertical field of view, 1 to 170; 0 is parallel",
               .unit = "degrees",
               .min = 0,
               .max = most_fov});
    visit("studio", &StillRequest::studio, Spec{.about = "the light, which turns with the eye"});
    visit("ground", &StillRequest::ground,
          Spec{.about = "what is under its lowest point: shadow is black where light is missing, "
                        "with alpha 1 - E / E0, the irradiance of a black plane there with and "
                        "without the model; floor is a grey plane"});
    visit(
        "background", &StillRequest::background,
        Spec{.about = "linear RGB where the picture shows no object, or transparent", .max = 1e6});
    visit("camera", &StillRequest::camera,
          Spec{.about = "one of the file's own, by its number from 0 or its name, instead of "
                        "orbit, zoom and fov",
               .min = 0,
               .max_bytes = longest_name});
    visit("turntable", &StillRequest::turntable,
          Spec{.about = "so many views at equal azimuths, the first that of orbit, on one sheet, "
                        "row by row, each of width and height: all look at the middle of the box "
                        "around the model, from the distance that the widest needs",
               .min = 1,
               .max = Sheet::most_views});
    visit("columns", &StillRequest::columns,
          Spec{.about = "how many of these are side by side; else as many as make the sheet nearly "
                        "square",
               .min = 1,
               .max = Sheet::most_views});
  }
  /// An elevation beyond the poles, a fov between 0 and 1, a camera with orbit, zoom, fov or
  /// turntable, columns without that or more than its views.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const StillRequest&) const = default;
};

/// The file's camera of that number or, the first, of that name, where a shown node has it, as the
/// object places it. The picture's own aspect holds. Errors: as a fault at that place, else none.
/// Domain: an object of that model whose choice (choice_of) has no fault, and which shows
/// something.
std::optional<Camera> still_camera(const Model& model, const Object& object,
                                   const CameraChoice& choice, const Place& at, Faults& faults);

/// StillBody: what a still shows.
struct StillBody {
  std::vector<Object> objects;   ///< the model
  StillPoints points;            ///< where it is
  std::optional<Camera> camera;  ///< the one that the request chooses; none: it chooses none
};

/// The scene of a still: camera, lights, ground and backdrop, with the objects first; of a
/// turntable the first view's, and a sheet of all. Options but the integrator are at their
/// defaults. Domain: at least one point, a request that its check has passed; aspect: the picture's
/// width over its height.
Scene still_scene(const StillRequest& request, StillBody body, double aspect,
                  IntegratorName integrator = IntegratorName::path);

}  // namespace tia
