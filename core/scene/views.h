// The views of a camera's picture: one, or its display's.
#pragma once

#include "core/scene/camera.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// Whether the picture has several views, or one that is mixed of several.
inline bool has_display(const Camera& camera) { return camera.display.has_value(); }

/// Those of a picture whose views have that size. Domain: a camera that its check has passed.
ViewGrid views_of(const Camera& camera, int width, int height);

}  // namespace tia
