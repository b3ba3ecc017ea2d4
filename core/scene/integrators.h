// THE LIST of integrators. A new one is one entry here, its name and its row, and one file in
// core/integrators, which defines what comes along a ray (integrator.h).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "core/film/display.h"
#include "core/input/value_codecs.h"

namespace tia {

/// How light is gathered along a ray.
enum class IntegratorName {
  thesis,
  whitted,
  normal,
  depth,
  albedo,
  object,
  shadow,
  cost,
  ambient_occlusion,
  path,
  planar_depth,
  label
};

/// Rules: how far light is followed, and how lights and shadows are simplified or left out.
struct Rules {
  int max_depth = std::numeric_limits<int>::max();  ///< how often it may be mirrored or refracted
  bool area_lights = true;  ///< whether lights are sampled over their area, else at their middle
  bool transparent_shadows = true;  ///< whether they are, where the world has them
  /// How far ambient_occlusion looks for what hides the sky. Space/units: scene units.
  double ao_radius = std::numeric_limits<double>::infinity();
  /// The most that a channel of a sample of path may be.
  double clamp = std::numeric_limits<double>::infinity();
};

/// What an integrator's numbers are: light that comes along the ray, or what it finds of surfaces.
enum class Gathers { light, features };

/// IntegratorRow: all there is to say of an integrator but what it computes.
struct IntegratorRow {
  IntegratorName name;
  std::string_view text;  ///< its name in JSON
  const char* about;      ///< a sentence, for people
  Gathers gathers = Gathers::light;
  FeatureDisplay display = FeatureDisplay::light;  ///< what its numbers mean to the eye
  bool averages = true;  ///< whether a pixel may have the mean of several rays' numbers
  int channels = 3;      ///< how many numbers a ray finds: three, or one that all three show
  float nothing = 0;  ///< what it is where a picture has no ray, as where a feature is of nothing
  /// The rays of a pixel where nothing is said of them: several where what one finds is chance.
  int samples = 1;
  int max_depth = 5;  ///< where nothing is said of it
  /// Whether it is whitted, within `most`: then /explain tells its tree of rays, and a few plain
  /// balls are traced without a tree over them.
  bool is_whitted = false;
  Rules most = {};

  constexpr bool gathers_light() const { return gathers == Gathers::light; }
  /// Whether what a ray finds is chance, also where it meets the same.
  constexpr bool is_chance() const { return samples != 1; }
};

inline constexpr std::array integrators = std::to_array<IntegratorRow>({
    {.name = IntegratorName::thesis,
     .text = "thesis",
     .about = "what the lights' middles give the nearest surface, and shadows: whitted without "
              "mirrors, glass and soft shadows",
     .is_whitted = true,
     .most = {0, false, false}},
    {.name = IntegratorName::whitted,
     .text = "whitted",
     .about = "what the lights give the nearest surface, and what its mirror and its glass show, "
              "traced the same way",
     .is_whitted = true},
    {.name = IntegratorName::normal,
     .text = "normal",
     .about = "which way the surface faces: the shading normal, towards the viewer",
     .gathers = Gathers::features,
     .display = FeatureDisplay::normal},
    {.name = IntegratorName::depth,
     .text = "depth",
     .about = "how far away the surface is along the ray",
     .gathers = Gathers::features,
     .display = FeatureDisplay::depth,
     .channels = 1,
     .nothing = std::numeric_limits<float>::infinity()},
    {.name = IntegratorName::albedo,
     .text = "albedo",
     .about = "the surface's colour times what it scatters, without light or shadow",
     .gathers = Gathers::features},
    {.name = IntegratorName::object,
     .text = "object",
     .about = "the number of the object in the scene, from 1",
     .gathers = Gathers::features,
     .display = FeatureDisplay::number,
     .averages = false,
     .channels = 1},
    {.name = IntegratorName::shadow,
     .text = "shadow",
     .about = "the share of the lights that the surface sees",
     .gathers = Gathers::features,
     .display = FeatureDisplay::share,
     .channels = 1,
     .nothing = 1},
    {.name = IntegratorName::cost,
     .text = "cost",
     .about = "how many tests of boxes and surfaces the ray takes",
     .gathers = Gathers::features,
     .display = FeatureDisplay::cost,
     .channels = 1},
    {.name = IntegratorName::ambient_occlusion,
     .text = "ambient_occlusion",
     .about = "how much of the sky over the surface is free, by the cosine: folds and corners are "
              "dark",
     .samples = 32},
    {.name = IntegratorName::path,
     .text = "path",
     .about = "light as it really goes: from surface to surface, until it is absorbed",
     .samples = 64,
     .max_depth = 16},
    {.name = IntegratorName::planar_depth,
     .text = "planar_depth",
     .about =
         "how far away the surface is along the view's axis: its distance from the eye's plane; of "
         "what looks through no plane, along the ray",
     .gathers = Gathers::features,
     .display = FeatureDisplay::depth,
     .channels = 1,
     .nothing = std::numeric_limits<float>::infinity()},
    {.name = IntegratorName::label,
     .text = "label",
     .about = "the material's base_color or color as it is told, without texture, light or curve, "
              "for masks; white where nothing is",
     .gathers = Gathers::features,
     .display = FeatureDisplay::share,
     .averages = false,
     .nothing = 1},
});

constexpr const IntegratorRow& row_of(IntegratorName name) {
  return integrators[static_cast<std::size_t>(name)];
}
static_assert(
    [] {
      for (std::size_t i = 0; i < integrators.size(); ++i)
        if (static_cast<std::size_t>(integrators[i].name) != i) return false;
      return true;
    }(),
    "the rows stand in the order of the names, one a name");

template <>
struct Names<IntegratorName> {
  static constexpr auto names = [] {
    std::array<std::string_view, integrators.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = integrators[i].text;
    return all;
  }();
};

/// Its schema says of each name what it is, and by the annotation `x-gathers` whether it gathers
/// "light" or "features", by `x-samples` how many rays a pixel has and by `x-max-depth` how often
/// light turns on its way where nothing is said, if not 1 and 5.
template <>
struct Codec<IntegratorName> : NamesCodec<IntegratorName> {
  static Value schema(const Spec&);
};

/// How an integrator's numbers are shown, and whether a pixel's may be averaged.
constexpr FeatureDisplay display_of(IntegratorName name) { return row_of(name).display; }
constexpr bool averages(IntegratorName name) { return row_of(name).averages; }
/// Whether it gathers light, else numbers of the surfaces.
constexpr bool gathers_light(IntegratorName name) { return row_of(name).gathers_light(); }
/// The rules of one, of which these are asked.
constexpr Rules rules_of(IntegratorName name, const Rules& asked) {
  Rules rules = row_of(name).most;
  rules.max_depth = rules.max_depth < asked.max_depth ? rules.max_depth : asked.max_depth;
  rules.ao_radius = asked.ao_radius;
  rules.clamp = asked.clamp;
  return rules;
}

/// The names of those that /explain tells of: "thesis or whitted or path".
std::string explained_names();
/// The names of those whose rays are chance.
std::string chance_names();

}  // namespace tia
