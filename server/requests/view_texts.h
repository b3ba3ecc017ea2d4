// What a picture's file says of its views, to the programs that show such pictures.
#pragma once

#include <string>

#include "server/requests/plan.h"

namespace tia::server {

/// Returns: the PNG file with the text `Tia quilt`, of a quilt; with XMP's GPano, of an
/// equirectangular panorama, or a part of one, whose place is told. Source: Google, "Photo Sphere
/// XMP metadata", 2013; Adobe, "XMP specification", part 3, 1.1.5 (PNG).
std::string with_view_texts(std::string png, const Plan& plan);

/// "attachment; filename=..." of a picture that programs know by its file's name, or of an archive;
/// empty for any other.
std::string disposition_of(const Plan& plan);

}  // namespace tia::server
