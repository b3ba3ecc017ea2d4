// PrincipledForm: a principled material, prepared for shading at points where its numbers differ.
#pragma once

#include <vector>

#include "core/materials/alpha_mode.h"
#include "core/materials/number_texture.h"
#include "core/materials/shading_parameters.h"

namespace tia {

/// PrincipledNumbers: those of its numbers that may be textured, at a point.
struct PrincipledNumbers {
  double metallic = 0, roughness = 0, specular = 0, transmission = 0;
  double clearcoat = 0, clearcoat_roughness = 0, sheen_roughness = 0, anisotropy = 0;
  double alpha = 1;
};

struct PrincipledForm {
  struct Textured {
    double PrincipledNumbers::*number;
    NumberTextureForm texture;
  };
  ShadingParameters rest;  ///< all that the numbers have no say in
  Vec3d base{}, layer{};   ///< the base colour; f0 at specular 1
  AlphaUse alpha{};
  PrincipledNumbers numbers;  ///< those of textures are the middle of their range
  std::vector<Textured> textured;
};
/// What it owns on the heap, pictures in full. Space/units: bytes.
std::size_t heap_bytes(const PrincipledForm& form);

/// Whether one of its textures is looked up by surface coordinates.
bool wants_uv(const PrincipledForm& form);
/// Space/units, Domain: as color_at's.
PrincipledNumbers numbers_at(const PrincipledForm& form, const Vec3d& p, const Vec2d& uv,
                             double blur);
/// The share of rays that meets it where it has these numbers.
double alpha_at(const PrincipledForm& form, const PrincipledNumbers& at);
/// The shading parameters where it has these numbers, without the texture of its base colour.
/// Source: Khronos, glTF 2.0 (2021), appendix B, and its extensions KHR_materials_*.
ShadingParameters shading_at(const PrincipledForm& form, const PrincipledNumbers& at);

}  // namespace tia
