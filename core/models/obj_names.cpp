#include "core/models/obj_names.h"

#include <algorithm>

namespace tia {
namespace {

std::string obj_pointer_of(std::string_view path) { return Place{}.at(path).pointer(); }

}  // namespace

const ModelFile* find_obj_file(const ModelFiles& files, const ObjNaming& naming) {
  const ModelFile* found = files.find(naming.name, naming.in.path);
  if (found != nullptr || naming.name.find('\\') == naming.name.npos) return found;
  std::string name(naming.name);
  std::replace(name.begin(), name.end(), '\\', '/');
  return files.find(name, naming.in.path);
}

void tell_missing_obj_file(const ModelFiles& files, bool alone, const ObjNaming& naming,
                           Faults& faults, Model& model) {
  if (alone) {
    const std::string name = excerpt_of(naming.name, longest_name);
    return model.warn({obj_pointer(files, naming.in), naming.line, name + " did not come"});
  }
  Fault fault{FaultKind::missing, obj_pointer_of(naming.name), Value(naming.name),
              "a file of that name, beside the one that names it"};
  fault.line = naming.line;
  faults.add(std::move(fault));
}

std::string obj_pointer(const ModelFiles& files, const ModelFile& file) {
  return &file == &files.main_file() ? "" : obj_pointer_of(file.path);
}

}  // namespace tia
