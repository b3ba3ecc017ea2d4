// The files of materials that an OBJ file names.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// ObjLibraries: reads each file once, however often it is named.
class ObjLibraries {
 public:
  /// The most statements that may come, and names in one.
  static constexpr std::size_t most = 64;

  ObjLibraries(const ModelFiles& files, Faults& faults, Model& model)
      : files_(files), faults_(faults), model_(model) {}

  /// What stands after `mtllib`: one name, which may have blanks, or several.
  void read(std::string_view names, std::size_t line);
  /// Whether one did not come.
  bool lacks_one() const { return lacks_one_; }

 private:
  bool read_one(std::string_view name, std::size_t line);
  void refuse(std::string_view names, std::size_t line);
  void miss(std::string_view name, std::size_t line);

  const ModelFiles& files_;
  Faults& faults_;
  Model& model_;
  std::set<std::string, std::less<>> named_;
  std::set<const ModelFile*> read_;
  bool lacks_one_ = false;
};

}  // namespace tia
