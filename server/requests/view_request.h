// What a request says of the scene and of the eye: the parameters that /render and /explain share.
#pragma once

#include <any>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/models/kept_model.h"
#include "core/render/gaze.h"
#include "core/scene/scene.h"
#include "server/requests/camera_patch.h"
#include "server/requests/moment.h"

namespace tia::server {

/// ModelAlong: a model that came with a request, and that nobody keeps.
struct ModelAlong {
  std::string id;
  SharedModel model;
};

/// ViewRequest: the parameters, in one table for query, JSON body and command line.
struct ViewRequest : Moment {
  static constexpr double most_px = 16'777'216;
  std::variant<std::string, Scene> scene = "thesis";
  std::optional<std::string> key;
  std::optional<Vec3d> light;
  std::optional<CameraPatch> camera;
  int width = 640, height = 480;
  ModelAlong along{};  ///< no parameter; its id is of use to this request alone

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using V = ViewRequest;
    visit("scene", &V::scene, Spec{.about = "a scene's name, a kept scene's id, or a whole scene"});
    visit("key", &V::key, Spec{.about = "the key that is pressed: it moves the scene's light"});
    visit("light", &V::light,
          Spec{.about = "where to put the scene's key light", .min = -1e9, .max = 1e9});
    visit("width", &V::width,
          Spec{.about = "the picture's width", .unit = "pixels", .min = 1, .max = most_px});
    visit("height", &V::height,
          Spec{.about = "the picture's height", .unit = "pixels", .min = 1, .max = most_px});
    visit("camera", &V::camera, Spec{.about = "what replaces fields of the scene's camera"});
    Moment::fields(visit);
  }
  /// key with light, time with frame.
  void check(const Place& at, Faults& faults) const;
};

/// TraceRequest: what besides decides a pixel's light.
struct TraceRequest : ViewRequest {
  std::optional<IntegratorName> integrator;
  std::optional<int> samples, blur_steps;
  std::optional<double> threshold;
  std::optional<int> max_depth;
  std::optional<double> ao_radius;
  std::optional<std::int64_t> seed;
  std::optional<std::array<double, 2>> gaze;
  std::optional<std::int64_t> gaze_rays;
  std::optional<Acuity> acuity;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using T = TraceRequest;
    ViewRequest::fields(visit);
    visit(
        "integrator", &T::integrator,
        Spec{.about = "how light is gathered; else as the scene says, whose samples, threshold and "
                      "max_depth are no other's that gathers it by chance"});
    visit("samples", &T::samples,
          Spec{.about = "rays a pixel; 1 goes through its centre; else as the scene says",
               .min = 1,
               .max = 65536});
    visit("blur_steps", &T::blur_steps,
          Spec{.about = "where the animation has a shutter: how many times of its being open the "
                        "samples are of, sample s of number s mod blur_steps; at most as many as "
                        "samples; else as the scene says",
               .min = 1,
               .max = SceneOptions::most_blur_steps});
    visit("threshold", &T::threshold,
          Spec{.about = "more rays where a pixel's own disagree: the standard error that its mean "
                        "may keep; 0 is off; else as the scene says",
               .min = 0,
               .max = 1});
    visit("max_depth", &T::max_depth,
          Spec{.about =
                   "how often light is mirrored, refracted or, by path, scattered on its way; 0 is "
                   "never; else as the scene says",
               .min = 0,
               .max = SceneOptions::deepest});
    visit("ao_radius", &T::ao_radius,
          Spec{.about = "how far ambient_occlusion looks for what hides the sky; else as the scene "
                        "says",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("seed", &T::seed,
          Spec{.about = "the random stream; else the scene's",
               .min = 0,
               .max = SceneOptions::last_seed});
    visit("gaze", &T::gaze,
          Spec{.about = "x,y: the picture is for an eye that looks there, which may be outside of "
                        "it; what it sees as sharply is traced pixel by pixel, the rest is filled "
                        "from rays as far apart as it can tell",
               .unit = "pixels",
               .min = -most_px,
               .max = most_px});
    visit(
        "gaze_rays", &T::gaze_rays,
        Spec{.about = "the most rays that the eye sends out for a gaze, of the whole picture: the "
                      "smallest slope of the acuity is taken that keeps to it",
             .min = 1,
             .max = 9007199254740991});
    visit("acuity", &T::acuity, Spec{.about = "of a gaze: how fine a detail is seen beside it"});
  }
};

/// Replaces an option by what is asked for: `place` points to a T or to an optional one, else to
/// what no request replaces.
template <class Asked>
void replace_option(const std::any&, const Asked&) {}
template <class T>
void replace_option(const std::any& place, const std::optional<T>& asked) {
  if (!asked) return;
  if (auto* const option = std::any_cast<T*>(&place)) **option = *asked;
  else if (auto* const may_be = std::any_cast<std::optional<T>*>(&place)) **may_be = asked;
}

/// How features are shown: what are no colours in one way, colours encoded and no more.
inline Tone encoding_alone(const SceneOptions& options) {
  const bool is_linear = options.transfer == Transfer::linear;
  const bool is_color = display_of(options.integrator) == FeatureDisplay::light;
  return {is_color && is_linear ? Transfer::linear : Transfer::srgb};
}

/// The scene's options, with what the request says in place of those of the same name; without
/// what has no effect then. How many rays a scene wants for its own integrator, and how deep they
/// go, says nothing of another whose rays are chance: that one has its own numbers.
template <class Request>
SceneOptions options_in_effect(SceneOptions options, const Request& asked) {
  if (asked.integrator && *asked.integrator != options.integrator) {
    options.noise = std::nullopt;
    if (row_of(*asked.integrator).is_chance())
      options.samples = options.max_depth = std::nullopt, options.threshold = std::nullopt;
  }
  // The two exclude each other, and the request's word is the later one.
  if (asked.threshold.value_or(0) > 0) options.noise = std::nullopt;
  if constexpr (requires { asked.noise; })
    if (asked.noise.value_or(0) > 0) options.threshold = std::nullopt;
  std::map<std::string_view, std::any> places;  // of the options, by name
  SceneOptions::fields([&](std::string_view name, auto option, const Spec&) {
    places.emplace(name, &(options.*option));
  });
  Request::fields([&](std::string_view parameter, auto member, const Spec&) {
    const auto place = places.find(parameter);
    if (place != places.end()) replace_option(place->second, asked.*member);
  });
  if (!averages(options.integrator)) options.samples = options.threshold = std::nullopt;
  if (options.noise == 0) options.noise = std::nullopt;
  if (options.samples == options.usual_samples()) options.samples = std::nullopt;
  if (options.max_depth == row_of(options.integrator).max_depth) options.max_depth = std::nullopt;
  if (options.threshold == 0) options.threshold = std::nullopt;
  if (options.integrator != IntegratorName::ambient_occlusion) options.ao_radius = std::nullopt;
  if (options.integrator != IntegratorName::path) options.clamp = std::nullopt;
  if (!gathers_light(options.integrator)) options.show_by(encoding_alone(options));
  return options;
}

}  // namespace tia::server
