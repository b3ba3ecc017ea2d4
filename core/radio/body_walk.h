// A scene's objects as bodies that radio waves meet.
#pragma once

#include "core/radio/radio_body.h"
#include "core/scene/scene.h"

namespace tia {

/// Domain: a scene that was read and whose models are resolved.
/// Errors: InputError (limit) of more facets than most_facets.
RadioBodies radio_bodies_of(const Scene& scene, const Wave& wave);

}  // namespace tia
