// THE LIST of lights. A new kind is one file beside this one and one entry here: its description,
// and a form that tells what comes in from it (incoming.h). What else it must or may bring:
// kinds.h.
#pragma once

#include <variant>

#include "core/input/errors.h"
#include "core/lights/directional.h"
#include "core/lights/kinds.h"
#include "core/lights/point.h"
#include "core/lights/quad_light.h"
#include "core/lights/sky.h"
#include "core/lights/sphere_light.h"
#include "core/lights/spot.h"

namespace tia {

/// LightList: checks every kind once, where it is listed.
template <IsLight... Kinds>
using LightList = std::variant<Kinds...>;

/// Light: a kind and what all kinds share. It sends color * intensity.
struct Light {
  static constexpr std::string_view schema_name = "light";
  using Kinds =
      LightList<PointLight, DirectionalLight, SpotLight, SphereLight, QuadLight, SkyLight>;
  Kinds kind;
  Color color{1, 1, 1};
  double intensity = 1;
  std::optional<double> fade_distance{};  ///< none: the light does not fade
  double fade_power = 2;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Light::kind, Spec{.about = "the kind of light", .required = true});
    visit("color", &Light::color, Spec{.about = "linear RGB", .max = 1e6});
    visit("intensity", &Light::intensity,
          Spec{.about = "factor on the colour", .min = 0, .max = 1e6});
    visit("fade_distance", &Light::fade_distance,
          Spec{.about = "where the light is as bright as it is without fading: its factor is "
                        "2 / (1 + (d / fade_distance)^fade_power)",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("fade_power", &Light::fade_power,
          Spec{.about = "how fast it fades", .min = 0, .max = 100});
  }
  /// What its kind finds wrong with it, at places relative to the light.
  void check_kind(Faults& faults) const;
  /// Fading of what has no distance.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Light&) const = default;

  /// The name of its kind.
  std::string_view type() const;
  /// Whether rays meet it.
  bool seen() const;
  bool movable() const;
  /// The field that it needs to shine and does not have yet, else null.
  const char* awaited() const;
  /// Its middle, if it has one and that is known.
  std::optional<Vec3d> place() const;
  /// Puts its middle there; what has none shines from there towards the target.
  /// Domain: a movable one.
  void move_to(const Vec3d& to, const Vec3d& target);
};

// A key puts a light of the first kind where a scene has none that moves.
static_assert(MovableLight<std::variant_alternative_t<0, Light::Kinds>>);

/// LightForm: any light made ready.
using LightForm = FormsOf<Light::Kinds>;

}  // namespace tia
