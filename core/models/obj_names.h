// Files that OBJ and MTL files name.
#pragma once

#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// ObjNaming: where a file is named.
struct ObjNaming {
  std::string_view name;
  const ModelFile& in;
  std::size_t line = 0;
};

/// The file of that name, or null; where there is none, of the name with '/' for each '\'.
const ModelFile* find_obj_file(const ModelFiles& files, const ObjNaming& naming);

/// Tells that a named file did not come: a warning where the OBJ file came alone, else a fault.
void tell_missing_obj_file(const ModelFiles& files, bool alone, const ObjNaming& naming,
                           Faults& faults, Model& model);

/// The pointer to a file that came with the main one: "/PATH"; "" of the main one, whose lines
/// need none.
std::string obj_pointer(const ModelFiles& files, const ModelFile& file);

}  // namespace tia
