#include "core/models/obj_libraries.h"

#include <vector>

#include "core/models/mtl.h"
#include "core/models/obj_lines.h"
#include "core/models/obj_names.h"

namespace tia {

void ObjLibraries::read(std::string_view names, std::size_t line) {
  if (names.empty() || !named_.emplace(names).second) return;
  if (named_.size() > most) return refuse(names, line);
  if (read_one(names, line)) return;
  std::vector<std::string_view> missing;
  std::size_t words = 0;
  for (ObjWords left(names); !left.empty();) {
    if (++words > most) return refuse(names, line);
    if (const std::string_view name = left.take(); !read_one(name, line)) missing.push_back(name);
  }
  if (missing.size() == words) return miss(names, line);  // it may well be one name
  for (const std::string_view name : missing) miss(name, line);
}

void ObjLibraries::refuse(std::string_view names, std::size_t line) {
  faults_.add(obj_fault(FaultKind::limit, line, names,
                        "at most " + std::to_string(most) + " names after mtllib"));
}

bool ObjLibraries::read_one(std::string_view name, std::size_t line) {
  const ModelFile* file = find_obj_file(files_, {name, files_.main_file(), line});
  if (file == nullptr) return false;
  if (read_.insert(file).second) read_mtl(*file, files_, files_.all.size() == 1, faults_, model_);
  return true;
}

void ObjLibraries::miss(std::string_view name, std::size_t line) {
  lacks_one_ = true;
  tell_missing_obj_file(files_, files_.all.size() == 1, {name, files_.main_file(), line}, faults_,
                        model_);
}

}  // namespace tia
