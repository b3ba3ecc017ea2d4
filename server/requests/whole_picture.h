// How large a picture is of which width and height are one view's, and where its views are.
#pragma once

#include "core/render/window.h"
#include "core/scene/limits.h"
#include "core/scene/scene.h"
#include "core/scene/views.h"
#include "server/requests/picture_request.h"

namespace tia::server {

/// WholePicture: its size, and its views, but of a sheet.
struct WholePicture {
  Window size;
  ViewGrid views;

  /// The number of the first view that has the pixel, -1 where there is none.
  int view_at(int x, int y, int width, int height) const;
};

/// Of views of that size. Errors: InputError: limit where it has too many pixels; out_of_range at
/// /height for squares that are none.
WholePicture whole_picture(const Scene& scene, int width, int height, const Limits& limits);

/// The window that is asked for. Errors: InputError (out_of_range) at /crop where it leaves the
/// picture.
Window window_within(const Window& whole, const PictureRequest& asked);

}  // namespace tia::server
