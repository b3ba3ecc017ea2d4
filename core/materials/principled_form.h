// PrincipledForm: a principled material, prepared for shading at points where its numbers differ.
#pragma once

#include <memory>
#include <vector>

#include "core/materials/alpha_mode.h"
#include "core/materials/number_texture.h"
#include "core/materials/principled_maps.h"
#include "core/materials/shading_parameters.h"

namespace tia {

struct PrincipledForm {
  struct Textured {
    double PrincipledNumbers::*number;
    NumberTextureForm texture;
  };
  ShadingParameters rest;  ///< all that the numbers have no say in
  Vec3d base{}, layer{};   ///< the base colour; f0 at specular 1, before it is bounded by 1
  AlphaUse alpha{};
  PrincipledNumbers numbers;  ///< those of textures are the middle of their range
  std::vector<Textured> textured;
  std::shared_ptr<const PrincipledMaps> maps;  ///< null: none
};
/// Whether all points have the same numbers.
inline bool is_even(const PrincipledForm& form) { return form.textured.empty() && !form.maps; }
/// What it owns on the heap, pictures of textures in full; without its maps, which are shared.
/// Space/units: bytes.
std::size_t heap_bytes(const PrincipledForm& form);

/// Whether one of its textures is looked up by surface coordinates.
bool wants_uv(const PrincipledForm& form);
/// Space/units, Domain: as color_at's.
PrincipledNumbers numbers_at(const PrincipledForm& form, TextureReader& reader);
/// The share of rays that meets it where it has these numbers.
double alpha_at(const PrincipledForm& form, const PrincipledNumbers& at);
/// The shading parameters where it has these numbers, without the texture of its base colour.
/// Source: Khronos, glTF 2.0 (2021), appendix B, and its extensions KHR_materials_*.
ShadingParameters shading_at(const PrincipledForm& form, const PrincipledNumbers& at);

/// VaryingShading: those of them that the numbers have a say in, but for the BSDF's.
struct VaryingShading {
  Vec3d albedo, ambient, emission;
  double reflection, transmission, opacity;
};
VaryingShading varying_at(const PrincipledForm& form, const PrincipledNumbers& at);
/// Its BSDF there.
BsdfParameters<double> bsdf_at(const PrincipledForm& form, const PrincipledNumbers& at);

}  // namespace tia
