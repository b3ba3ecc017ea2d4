// A picture's views as an archive of files.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"
#include "server/requests/plan.h"

namespace tia::server {

/// Returns: a ZIP archive with a PNG of each view, and views.json: {"columns", "rows", "width",
/// "height", "views": [{"file", "column", "row", "eye", "window": {"center", "right", "up"}}]}. The
/// window is what the view sees, from its middle to its edges, in scene units, where it sees
/// through one; of a module's image the eye is the module. What views are mixed to is one file.
/// Domain: the whole picture, of no sheet. Errors: Stopped.
std::string views_archive(const Plan& plan, const Image8& image, const std::stop_token& stop);
std::string views_archive(const Plan& plan, const ImageRgba8& image, const std::stop_token& stop);

}  // namespace tia::server
