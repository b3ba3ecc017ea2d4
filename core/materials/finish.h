// Finish: the material of the slides, with POV-Ray's names.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/materials/shading_parameters.h"
#include "core/materials/texture.h"

namespace tia {

/// Finish: the parameters of a material, named as in POV-Ray. What they do is defined in whitted.h.
struct Finish {
  static constexpr std::string_view type = "finish";
  Color color{1, 1, 1};
  double ambient = 0, diffuse = 1, brilliance = 1;
  double specular = 0, roughness = 0.05;
  double reflection = 0, transmission = 0, ior = 1.5;
  bool fresnel = false;
  Color absorption{}, emission{};
  std::optional<Texture> texture{};  ///< replaces the colour

  template <class Visitor>
  static void fields(Visitor&& visit) {
    const auto share = [&](const char* name, double Finish::*field, const char* about) {
      visit(name, field, Spec{.about = about, .min = 0, .max = 1});
    };
    visit("color", &Finish::color, Spec{.about = "the surface's linear RGB", .max = 1e6});
    share("ambient", &Finish::ambient, "share of the scene's ambient_light that it sends back");
    share("diffuse", &Finish::diffuse, "share of the light that is scattered");
    visit("brilliance", &Finish::brilliance,
          Spec{.about = "exponent of n.l: how fast scattered light fades as it slants",
               .min = 0,
               .max = 1000});
    share("specular", &Finish::specular, "brightness of the highlight (Phong's)");
    visit("roughness", &Finish::roughness,
          Spec{.about = "width of the highlight: 1 over its exponent", .min = 1e-5, .max = 1});
    share("reflection", &Finish::reflection, "share of what a mirror there would show");
    share("transmission", &Finish::transmission, "share of the light that goes through");
    visit("ior", &Finish::ior, Spec{.about = "index of refraction inside", .min = 0.1, .max = 10});
    visit("fresnel", &Finish::fresnel,
          Spec{.about = "whether what goes through is parted into mirrored and refracted light by "
                        "Fresnel's equations"});
    visit("absorption", &Finish::absorption,
          Spec{.about = "what a unit of length inside absorbs: it leaves exp(-absorption * length)",
               .max = 1e6});
    visit("emission", &Finish::emission,
          Spec{.about =
                   "light of its own; a luminous sphere is a light too, and by path all that "
                   "glows: of spheres, discs, triangles, meshes, boxes and cylinders it asks "
                   "points for light, 32768 areas of a scene at most; the rest it meets by chance",
               .max = 1e6});
    visit("texture", &Finish::texture, Spec{.about = "what gives each point its colour instead"});
  }
  bool operator==(const Finish&) const = default;
};

/// Its shading parameters, without the texture, for ambient light of that linear RGB.
ShadingParameters shading_of(const Finish& finish, const Vec3d& ambient_light);
inline const Texture* texture_of(const Finish& finish) {
  return finish.texture ? &*finish.texture : nullptr;
}

}  // namespace tia
