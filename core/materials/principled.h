// Principled: a physical material, in the words of glTF 2.0.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/input/containers.h"
#include "core/input/fields.h"
#include "core/input/value_codecs.h"
#include "core/materials/alpha_mode.h"
#include "core/materials/number_texture.h"
#include "core/materials/principled_form.h"
#include "core/materials/shading_parameters.h"
#include "core/materials/texture.h"

namespace tia {

/// Metals by name: what a smooth plane of them reflects, straight on.
enum class Metal { gold, copper, silver, aluminium, iron, titanium };
template <>
struct Names<Metal> {
  static constexpr std::array<std::string_view, 6> names{"gold",      "copper", "silver",
                                                         "aluminium", "iron",   "titanium"};
};

/// BaseColor: linear RGB, or what a metal reflects. In JSON a colour, or the metal's name.
using BaseColor = std::variant<Color, Metal>;
template <>
struct Codec<BaseColor> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   BaseColor& out);
  static Value write(const BaseColor& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

/// Principled: metallic-roughness, with what the extensions KHR_materials_ior, specular,
/// transmission, volume, clearcoat, sheen, anisotropy, dispersion and emissive_strength add. How it
/// scatters light is defined in bsdf.h; whitted shows the finish that comes nearest.
struct Principled {
  static constexpr std::string_view type = "principled";
  BaseColor base_color = Color{1, 1, 1};
  NumberOrTexture metallic = 0, roughness = 0.5;
  double ior = 1.5;
  NumberOrTexture specular = 1;
  Color specular_color{1, 1, 1};
  NumberOrTexture transmission = 0;
  Color attenuation_color{1, 1, 1};
  std::optional<double> attenuation_distance{};
  bool thin = false;
  NumberOrTexture clearcoat = 0, clearcoat_roughness = 0;
  Color sheen_color{};
  NumberOrTexture sheen_roughness = 0, anisotropy = 0;
  double anisotropy_rotation = 0, dispersion = 0;
  Color emissive{};
  double emissive_strength = 1, ambient = 0;
  NumberOrTexture alpha = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = true;
  std::optional<Texture> texture{};  ///< replaces the base colour
  /// What a model's file multiplies into that; not in JSON, as what a model shows is not.
  std::shared_ptr<const PrincipledMaps> maps{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using P = Principled;
    const auto share = [&](const char* name, NumberOrTexture P::*field, const char* about) {
      visit(name, field, Spec{.about = about, .min = 0, .max = 1});
    };
    const auto color = [&](const char* name, Color P::*field, const char* about) {
      visit(name, field, Spec{.about = about, .min = 0, .max = 1});
    };
    visit("base_color", &P::base_color,
          Spec{.about = "linear RGB of what is scattered, of metals' mirrors and of what passes "
                        "glass; or a metal's name, for what it reflects, beside metallic 1",
               .min = 0,
               .max = 1});
    share("metallic", &P::metallic, "how far it is a metal");
    share("roughness", &P::roughness, "how rough it is: the root of GGX's alpha");
    visit("ior", &P::ior, Spec{.about = "index of refraction inside", .min = 1, .max = 10});
    share("specular", &P::specular, "strength of the reflection of what is no metal nor glass");
    visit("specular_color", &P::specular_color,
          Spec{.about = "its linear RGB, straight on", .min = 0, .max = 1e6});
    share("transmission", &P::transmission, "how far what is no metal is glass");
    color("attenuation_color", &P::attenuation_color,
          "what is left of white light after attenuation_distance inside");
    visit("attenuation_distance", &P::attenuation_distance,
          Spec{.about = "in scene units; else the inside absorbs nothing",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("thin", &P::thin, Spec{.about = "whether glass is a pane, without an inside"});
    share("clearcoat", &P::clearcoat, "how far a clear layer of index 1.5 covers it");
    share("clearcoat_roughness", &P::clearcoat_roughness, "how rough that is");
    color("sheen_color", &P::sheen_color, "linear RGB of the fibres of cloth, seen at its rims");
    share("sheen_roughness", &P::sheen_roughness, "how far they lean apart");
    share("anisotropy", &P::anisotropy,
          "how much rougher it is along the horizontal than across it; where roughness is 0, lines "
          "as fine as alpha 0.001");
    visit("anisotropy_rotation", &P::anisotropy_rotation,
          Spec{.about = "by which angle, in radians, that direction is turned from the "
                        "horizontal (+y is up), counter-clockwise",
               .min = -1e3,
               .max = 1e3});
    visit("dispersion", &P::dispersion,
          Spec{.about =
                   "how far glass parts colours: 20 over Abbe's number; diamond 0.36, flint 0.55",
               .min = 0,
               .max = 10});
    color("emissive", &P::emissive, "light of its own, which path asks for as a finish's emission");
    visit("emissive_strength", &P::emissive_strength,
          Spec{.about = "what that is multiplied with", .min = 0, .max = 1e6});
    visit("ambient", &P::ambient,
          Spec{.about = "share of the scene's ambient_light that its base colour sends back, by "
                        "whitted",
               .min = 0,
               .max = 1});
    share("alpha", &P::alpha, "how far it covers what is behind it, as alpha_mode says");
    visit(
        "alpha_mode", &P::alpha_mode,
        Spec{.about = "what alpha means: opaque: nothing; mask: nothing is there where it is below "
                      "alpha_cutoff; blend: that share of every ray meets the surface, and the "
                      "rest goes straight on"});
    visit("alpha_cutoff", &P::alpha_cutoff,
          Spec{.about = "from which alpha on mask leaves something there", .min = 0, .max = 1e6});
    visit("double_sided", &P::double_sided,
          Spec{.about = "whether it has a back: else rays of the camera, of mirrors and of glass "
                        "pass through it from behind, unless it transmits light itself"});
    visit("texture", &P::texture, Spec{.about = "what gives each point its base_color instead"});
  }
  bool operator==(const Principled&) const = default;
};

/// For ambient light of that linear RGB.
PrincipledForm prepare(const Principled& principled, const Vec3d& ambient_light = {});
/// Its shading parameters, without textures, for ambient light of that linear RGB.
ShadingParameters shading_of(const Principled& principled, const Vec3d& ambient_light);
inline const Texture* texture_of(const Principled& principled) {
  return principled.texture ? &*principled.texture : nullptr;
}

}  // namespace tia
