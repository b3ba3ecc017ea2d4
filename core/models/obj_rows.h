// OBJ's statements that list numbers: v, vt and vn.
#pragma once

#include "core/models/obj_content.h"
#include "core/models/obj_lines.h"
#include "core/models/obj_reading.h"

namespace tia {

/// Each appends to the content's lists what the words after the statement's name say. A faulty one
/// takes its place there all the same, so that indices after it mean what they meant.
/// v: x y z, then nothing, w, which is passed over, or r g b, which are sRGB's signals. vt: u, u v
/// or u v w, v upward. vn: x y z.
/// Errors: as faults: malformed, out_of_range, limit.
void read_obj_position(ObjWords words, ObjReading& reading, ObjContent& content);
void read_obj_uv(ObjWords words, ObjReading& reading, ObjContent& content);
void read_obj_normal(ObjWords words, ObjReading& reading, ObjContent& content);

}  // namespace tia
