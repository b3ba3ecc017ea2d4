// How far the reading of an OBJ file has come, and what is told of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/obj_lines.h"

namespace tia {

/// ObjReading: the present line, and faults and warnings at it.
class ObjReading {
 public:
  ObjReading(ModelBytes file, const ModelLimits& limits, Faults& faults, Model& model)
      : limits_(limits), faults_(faults), model_(model), lines_(file) {}

  /// Goes on to the next line. Returns: whether there is one, and it is wanted.
  bool next() { return !stopped_ && !faults_.full() && lines_.next(); }
  std::string_view line() const { return lines_.line(); }
  std::size_t number() const { return lines_.number(); }
  const ModelLimits& limits() const { return limits_; }
  std::size_t faults() const { return faults_.count(); }

  /// Makes room in a list that has none for a row of so many numbers: for what the rest of the file
  /// adds to it if all its lines are like this one. So no list is copied again and again, and room
  /// that stays empty costs addresses only.
  template <class List>
  void make_room(std::size_t row, List& list) const {
    constexpr std::size_t short_list = 1 << 14;
    if (list.capacity() - list.size() >= row || list.size() < short_list) return;
    const std::size_t rows = lines_.left() / (line().size() + 1) + 1;
    list.reserve(std::max(2 * list.size(), list.size() + row * rows));
  }
  void fault(FaultKind kind, std::string_view got, std::string allowed) {
    faults_.add(obj_fault(kind, number(), got, std::move(allowed)));
  }
  /// A limit is passed: reading ends.
  void stop(std::string_view got, std::uint64_t most, const std::string& what) {
    fault(FaultKind::limit, got, "at most " + std::to_string(most) + " " + what);
    stopped_ = true;
  }
  /// The first time that there is one of that kind.
  void warn_once(std::string_view kind, const std::string& text) {
    if (warned_.size() == Model::most_warnings || !warned_.emplace(kind).second) return;
    model_.warn({"", number(), text});
  }

 private:
  const ModelLimits& limits_;
  Faults& faults_;
  Model& model_;
  ObjLines lines_;
  std::set<std::string, std::less<>> warned_;
  bool stopped_ = false;
};

}  // namespace tia
