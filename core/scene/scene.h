// The scene as plain data: what the JSON says, nothing computed. compile() makes a World of it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/film/tone.h"
#include "core/input/codec.h"
#include "core/input/shared_list.h"
#include "core/input/shared_value.h"
#include "core/lights/light.h"
#include "core/scene/animation.h"
#include "core/scene/backdrop.h"
#include "core/scene/camera.h"
#include "core/scene/fog.h"
#include "core/scene/integrators.h"
#include "core/scene/object.h"
#include "core/scene/physics.h"
#include "core/scene/shadow_ground.h"
#include "core/scene/sheet.h"

namespace tia {

/// KeyBinding: where a key puts the key light, or else a JSON merge patch of the scene (RFC 7396).
using KeyBinding = std::variant<Vec3d, SharedValue>;

struct SceneOptions {
  static constexpr std::string_view schema_name = "options";
  static constexpr double last_seed = 9007199254740991;  // 2^53 - 1
  static constexpr int deepest = 64;
  static constexpr int most_of_noise = 4096;
  static constexpr int usual_blur_steps = 8, most_blur_steps = 256;
  static constexpr double most_stops = 32, coldest_white = 1000, hottest_white = 25000;
  IntegratorName integrator = IntegratorName::whitted;
  Transfer transfer = Transfer::srgb;
  double exposure = 0;
  std::optional<double> white_balance_kelvin;  ///< none: off
  std::optional<int> samples;                  ///< none: the integrator's
  std::optional<int> blur_steps;               ///< none: 8, at most as many as samples
  std::optional<double> threshold;             ///< none: off
  std::optional<double> noise;                 ///< none: off
  std::optional<int> max_depth;                ///< none: the integrator's
  bool transparent_shadows = false;
  std::optional<double> ao_radius;  ///< none: infinite
  std::optional<double> clamp;      ///< none: off
  std::int64_t seed = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("integrator", &SceneOptions::integrator, Spec{.about = "how light is gathered"});
    visit("transfer", &SceneOptions::transfer,
          Spec{.about = "curve from linear light to stored codes; aces and agx show light of any "
                        "brightness"});
    visit("exposure", &SceneOptions::exposure,
          Spec{.about = "light is shown 2^exposure times as bright",
               .unit = "stops",
               .min = -most_stops,
               .max = most_stops});
    visit(
        "white_balance_kelvin", &SceneOptions::white_balance_kelvin,
        Spec{.about = "the white that is shown neutral: a black body's, from 5000 K on daylight's; "
                      "else sRGB's own",
             .unit = "K",
             .min = coldest_white,
             .max = hottest_white});
    visit("samples", &SceneOptions::samples,
          Spec{.about = "rays a pixel; 1 goes through its centre", .min = 1, .max = 65536});
    visit("blur_steps", &SceneOptions::blur_steps,
          Spec{.about = "into how many strata the open time of an animation's shutter is parted: "
                        "sample s is of stratum s mod blur_steps; else 8, at most one a sample",
               .min = 1,
               .max = most_blur_steps});
    visit("threshold", &SceneOptions::threshold,
          Spec{.about = "more rays where a pixel's own disagree: the standard error that its mean "
                        "may keep; 0 is off",
               .min = 0,
               .max = 1});
    visit(
        "noise", &SceneOptions::noise,
        Spec{.about = "where rays are chance: a pixel has samples until the standard error of what "
                      "is shown, in 0 to 1, is below this, and at most as many as samples says, "
                      "else 4096; 0 is off",
             .min = 0,
             .max = 1});
    visit("max_depth", &SceneOptions::max_depth,
          Spec{.about =
                   "how often light is mirrored, refracted or, by path, scattered on its way; 0 is "
                   "never; else 5, by path 16",
               .min = 0,
               .max = deepest});
    visit("transparent_shadows", &SceneOptions::transparent_shadows,
          Spec{.about = "whether light goes straight through what transmits, each surface taking "
                        "its share"});
    visit("ao_radius", &SceneOptions::ao_radius,
          Spec{.about = "how far ambient_occlusion looks for what hides the sky; else however far",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("clamp", &SceneOptions::clamp,
          Spec{.about = "the most that a channel of one of path's samples may be; what is brighter "
                        "is darkened, its colour kept, and the picture is no longer the true one, "
                        "which the header Tia-Biased says; else there is no such bound",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("seed", &SceneOptions::seed,
          Spec{.about = "the random stream", .min = 0, .max = last_seed});
  }
  Tone tone() const { return {transfer, exposure, white_balance_kelvin}; }
  void show_by(const Tone& tone) {
    transfer = tone.transfer;
    exposure = tone.exposure;
    white_balance_kelvin = tone.white_balance_kelvin;
  }
  /// The samples where nothing is said of them.
  int usual_samples() const {
    return noise.value_or(0) > 0 ? most_of_noise : row_of(integrator).samples;
  }
  /// noise with threshold, or without chance; more blur_steps than samples.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const SceneOptions&) const = default;
};

struct Scene {
  static constexpr std::string_view schema_name = "scene";
  std::string title, description;
  Camera camera;
  Color background{};
  std::optional<Backdrop> backdrop;           ///< none: lights and background are seen
  std::optional<ShadowGround> shadow_ground;  ///< before the backdrop
  std::optional<Sheet> sheet;                 ///< none: one view, the camera's
  Color ambient_light{1, 1, 1};
  std::optional<Fog> fog;
  std::map<std::string, Material> materials;
  SharedList<Object> objects;
  std::vector<Light> lights;
  std::optional<Light> key_light;
  std::map<std::string, KeyBinding> keys;
  std::optional<Animation> animation;  ///< none: nothing moves
  std::optional<Physics> physics;      ///< none: nothing falls
  SceneOptions options;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("title", &Scene::title, Spec{.about = "what the picture shows"});
    visit("description", &Scene::description, Spec{.about = "what to look at"});
    visit("camera", &Scene::camera, Spec{.about = "where the eye is and what it sees"});
    visit("background", &Scene::background,
          Spec{.about = "linear RGB of rays that hit nothing", .max = 1e6});
    visit(
        "backdrop", &Scene::backdrop,
        Spec{.about = "what the picture shows where no object is, in place of the background, the "
                      "sky and the lights, which are then seen in mirrors alone: linear RGB, or "
                      "transparent, for which a PNG has alpha: the share of the samples that "
                      "meet an object",
             .max = 1e6});
    visit(
        "shadow_ground", &Scene::shadow_ground,
        Spec{.about = "a plane of which the picture shows nothing but the shadows on it, before a "
                      "backdrop"});
    visit("sheet", &Scene::sheet, Spec{.about = "several views instead of the camera's"});
    visit("ambient_light", &Scene::ambient_light,
          Spec{.about = "linear RGB of the light from everywhere", .max = 1e6});
    visit("fog", &Scene::fog, Spec{.about = "what fills the air and scatters light, by path"});
    visit("materials", &Scene::materials, Spec{.about = "materials by name"});
    visit("objects", &Scene::objects, Spec{.about = "what can be hit"});
    visit("lights", &Scene::lights, Spec{.about = "what sends light"});
    visit("key_light", &Scene::key_light, Spec{.about = "the light that keys move"});
    visit("keys", &Scene::keys, Spec{.about = "what each key does"});
    visit("animation", &Scene::animation,
          Spec{.about = "what changes in time; without one a picture is of the time 0"});
    visit("physics", &Scene::physics,
          Spec{.about = "which objects are bodies that fall and collide; their motion is found "
                        "first, and becomes tracks of the animation"});
    visit("options", &Scene::options, Spec{.about = "how the picture is made"});
  }
  /// Names that point nowhere, lights without a place, more copies than can be told apart.
  void check_links(const Place& at, Faults& faults) const;
  bool operator==(const Scene&) const;

 private:
  void check_material_names(const std::vector<Object>& objects, const Place& at,
                            Faults& faults) const;
  void check_material_name(const MaterialRef& material, const Place& at, Faults& faults) const;
};
extern template struct FieldsCodec<Scene>;

template <>
struct Codec<KeyBinding> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   KeyBinding& out);
  static Value write(const KeyBinding& v);
  static Value schema(const Spec&, Definitions& named);
};

}  // namespace tia
