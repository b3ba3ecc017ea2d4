// The corners of OBJ's faces: v, v/vt, v//vn, v/vt/vn.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/input/errors.h"
#include "core/models/obj_lines.h"

namespace tia {

/// ObjCorner: what a corner of a face names, from 0; `none` where it does not.
struct ObjCorner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t position = none, uv = none, normal = none;
};

/// ObjCounts: how many positions, texture coordinates and normals have come so far.
using ObjCounts = std::array<std::size_t, 3>;

/// Takes a word that is a corner. Indices count from 1, and from -1 back from what came last; 1/
/// and 1// are as 1. Domain: some word is left. Returns: why it is none: malformed or out_of_range,
/// then it stays; nothing where it is one.
std::optional<FaultKind> take_obj_corner(ObjWords& words, const ObjCounts& counts,
                                         ObjCorner& corner);

/// What a corner may be, in words.
std::string obj_corner_words(FaultKind kind, const ObjCounts& counts);

}  // namespace tia
