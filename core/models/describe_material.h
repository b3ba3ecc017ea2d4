// What was read of a model, in the words of scenes.
#pragma once

#include "core/input/value.h"
#include "core/models/model.h"

namespace tia {

/// A material as a `principled` object with its name: {"name": "Body", "type": "principled", ...}.
/// Left out is what it shares with a principled of no members; `thin` also where it does not
/// transmit. A texture NAME_texture is {"texture": number, "uv_set": 1, "offset": [u, v],
/// "rotation": radians, "scale": [u, v], "strength": 1}, without what is 0 or 1 by default.
/// Domain: a material of that model.
Value material_value(const Model& model, const ModelMaterial& material);

}  // namespace tia
