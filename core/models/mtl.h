// MTL: the materials of OBJ files.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// The most materials that MTL files may have together.
inline constexpr std::size_t most_mtl_materials = 16'384;

/// Appends the file's materials, with the pictures and textures that they use, to the model. Kd is
/// the base colour, Ke what shines, Ni the ior, Pr Pm Ps Pc Pcr as their names say; without Pr the
/// roughness is (2 / (Ns + 2))^(1/4). With illum 4, 6, 7 or 9 transmission is 1 - d, else alpha is
/// d. Numbers and colours are linear as they stand; what lies outside its range is taken as the
/// nearest in it, with a warning. A picture's number is a factor, 1 where it is not said. norm is a
/// normal map; map_d makes alpha_mode blend. Ka, Ks, Tf and map_Ka are passed over, the rest, such
/// as heights (bump), with a warning. Names of statements are taken in letters of any case.
/// `alone`: whether no other file came with the OBJ file: what is missing is a warning then.
/// Errors: as faults with the file's pointer, "/PATH", and the line.
/// Cost: linear in the file; each new name of a picture is looked for among all files.
/// Source: Wavefront, "MTL material format" (1995); for the exponent Walter, Marschner, Li and
/// Torrance, "Microfacet models for refraction through rough surfaces" (2007), section 5.2.
void read_mtl(const ModelFile& file, const ModelFiles& files, bool alone, Faults& faults,
              Model& model);

}  // namespace tia
