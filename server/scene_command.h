// `tia scene from-geojson FILE -o FILE`: scenes from what is none.
#pragma once

#include <string>

namespace tia::server {

/// Writes the scene of a GeoJSON's buildings (core/scene/footprints.h), canonical, to a file (or
/// "-", standard output). Errors: InputError; std::runtime_error for files.
void footprints_to_file(const std::string& geojson, const std::string& file);

}  // namespace tia::server
