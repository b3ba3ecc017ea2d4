// Text -> Scene -> canonical text.
#pragma once

#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace tia {

/// Errors: InputError with every fault of the text at once (up to 20).
Scene read_scene(std::string_view json);

/// Canonical text: RFC 8785, fields at their defaults left out. Equal scenes have equal text.
std::string canonical_text(const Scene& scene);

/// JSON Schema 2020-12 of the scene format, from the fields' descriptions.
std::string scene_schema();

}  // namespace tia
