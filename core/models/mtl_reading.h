// How far the reading of an MTL file has come, and what is told of it.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/obj_lines.h"
#include "core/models/obj_names.h"

namespace tia {

/// MtlReading: the present line, and faults and warnings at it.
class MtlReading {
 public:
  MtlReading(const ModelFile& file, const ModelFiles& files, bool alone, Faults& faults,
             Model& model)
      : file_(file),
        files_(files),
        alone_(alone),
        faults_(faults),
        model_(model),
        lines_(file.bytes),
        pointer_(obj_pointer(files, file)) {}

  /// Goes on to the next line. Returns: whether there is one, and it is wanted.
  bool next() { return !stopped_ && !faults_.full() && lines_.next(); }
  std::string_view line() const { return lines_.line(); }
  Model& model() { return model_; }

  void fault(FaultKind kind, std::string_view got, std::string allowed) {
    faults_.add(obj_fault(kind, lines_.number(), got, std::move(allowed), pointer_));
  }
  /// A limit is passed: reading ends.
  void stop(std::string_view got, std::size_t most, const std::string& what) {
    fault(FaultKind::limit, got, "at most " + std::to_string(most) + " " + what);
    stopped_ = true;
  }
  void warn(std::string text) { model_.warn({pointer_, lines_.number(), std::move(text)}); }
  /// The first time that there is one of that kind.
  void warn_once(std::string_view kind, const std::string& text) {
    if (warned_.size() < Model::most_warnings && warned_.emplace(kind).second) warn(text);
  }
  /// The file of that name; null, and told, where it did not come.
  const ModelFile* find(std::string_view name) {
    const ObjNaming naming{name, file_, lines_.number()};
    const ModelFile* found = find_obj_file(files_, naming);
    if (found == nullptr) tell_missing_obj_file(files_, alone_, naming, faults_, model_);
    return found;
  }

 private:
  const ModelFile& file_;
  const ModelFiles& files_;
  bool alone_;
  Faults& faults_;
  Model& model_;
  ObjLines lines_;
  std::string pointer_;
  std::set<std::string, std::less<>> warned_;
  bool stopped_ = false;
};

}  // namespace tia
