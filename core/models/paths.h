// The names of files that came packed together, as paths that mean the same whoever packed them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/errors.h"

namespace tia {

/// The most bytes that the name of a packed file may have.
inline constexpr std::size_t longest_path = 1024;

/// The path that a packed file's name means: its parts, one '/' between them, without those that
/// are empty or ".". A '\' is read as '/', for packers of Windows write it so.
/// Returns: nothing, and one fault at "/NAME", where the name is absolute, begins with a drive's
/// letter, has a part "..", a control character or no part, is not UTF-8 or too long.
std::optional<std::string> clean_path(std::string_view name, Faults& faults);

/// Whether a clean path is of what macOS puts beside files: in a folder __MACOSX, or .DS_Store.
bool is_clutter(std::string_view path);

}  // namespace tia
