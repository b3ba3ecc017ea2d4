// A model in words and numbers: what GET /models/{id} and `tia model` tell of it.
#pragma once

#include "core/input/value.h"
#include "core/models/model.h"

namespace tia {

/// format, generator, copyright, up, bounds, vertices, triangles, points, nodes, materials,
/// textures, cameras, lights, animations, variants, extensions, warnings; texts that are empty are
/// left out. Numbers of things are the file's, however often they are placed.
/// Space/units: bounds are of the scene that the file shows, before any animation, in its own axes.
Value description_of(const Model& model);

}  // namespace tia
