// THE LIST of lights. A new kind is one file beside this one, with its description and the form
// that is sampled (light_sample.h), and one entry here. What else it must or may have: kinds.h.
#pragma once

#include <variant>

#include "core/input/errors.h"
#include "core/lights/directional.h"
#include "core/lights/kinds.h"
#include "core/lights/point.h"
#include "core/lights/quad_light.h"
#include "core/lights/sky.h"
#include "core/lights/sky_image.h"
#include "core/lights/sphere_light.h"
#include "core/lights/spot.h"
#include "core/lights/sun.h"

namespace tia {

/// LightList: checks each kind of the list against IsLight, by itself, so that the compiler names
/// the one that lacks something.
template <IsLight Kind>
using ListedLight = Kind;
template <class... Kinds>
using LightList = std::variant<ListedLight<Kinds>...>;

/// Light: a kind, and the fields that all kinds share. What it sends is color * intensity, linear
/// RGB.
struct Light {
  static constexpr std::string_view schema_name = "light";
  using Kinds = LightList<PointLight, DirectionalLight, SpotLight, SphereLight, QuadLight, SkyLight,
                          SunLight, SkyImageLight>;
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
  /// Adds the faults that its kind finds, with pointers relative to the light.
  void check_kind(Faults& faults) const;
  /// A fade_distance of a light that is infinitely far.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Light&) const = default;

  /// The name of its kind.
  std::string_view type() const;
  /// Whether it has a surface that rays can hit.
  bool seen() const;
  bool movable() const;
  /// The name of the field that it lacks and needs to shine; null where it lacks none.
  const char* awaited() const;
  /// Its middle; none where it is infinitely far, or still awaits one.
  std::optional<Vec3d> place() const;
  /// Moves its middle to `to`. A directional light then shines from `to` towards the target.
  /// Domain: a movable one.
  void move_to(const Vec3d& to, const Vec3d& target);
};

// Where a scene has no movable light, a key adds one of the first kind.
static_assert(MovableLight<std::variant_alternative_t<0, Light::Kinds>>);

/// LightForm: any light made ready.
using LightForm = FormsOf<Light::Kinds>;

}  // namespace tia
