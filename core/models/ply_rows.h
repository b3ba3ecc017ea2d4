// The rows of a PLY file's element: what of them is wanted, as numbers and one list.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/ply_header.h"
#include "core/models/ply_source.h"

namespace tia {

/// PlyPlan: where the values of each property go.
struct PlyPlan {
  static constexpr std::size_t slots = 12;
  static constexpr std::size_t skipped = slots, list = slots + 1;  ///< instead of a slot

  std::vector<std::size_t> to;  ///< a slot, `skipped`, or `list`, which one property at most has
  std::uint64_t most_listed = std::numeric_limits<std::uint64_t>::max();

  explicit PlyPlan(const PlyElement& element) : to(element.properties.size(), skipped) {}
};

/// PlyRow: what of a row is wanted.
struct PlyRow {
  std::array<double, PlyPlan::slots> numbers{};
  std::vector<double> list;
};

/// PlyPlace: a row, for what is told of it.
struct PlyPlace {
  const PlyElement* element = nullptr;
  std::uint64_t index = 0;
  std::optional<std::size_t> line;

  /// "vertex 7", counted from 0.
  std::string name() const {
    return excerpt_of(element->name, longest_name) + " " + std::to_string(index);
  }
  Fault fault(FaultKind kind, std::optional<Value> got, const std::string& allowed) const {
    return {kind, "", std::move(got), allowed + ", in " + name(), "", std::nullopt, line};
  }
};

/// Warns of the properties that go nowhere.
void warn_of_skipped(const PlyElement& element, const PlyPlan& plan, Model& model);

/// The property's number, of a property that is no list; none where there is none of that name.
std::optional<std::size_t> ply_number(const PlyElement& element, std::string_view name);

/// PlyRows: reads an element's rows.
template <class Source>
class PlyRows {
 public:
  PlyRows(Source& source, const PlyElement& element, const PlyPlan& plan)
      : source_(source), element_(element), plan_(plan) {}

  /// Gives each row and its place to `take`, until that returns false. Returns: whether all came.
  /// Errors: those of the encoding, as a fault.
  template <class Take>
  bool read(Faults& faults, Take take) {
    PlyRow row;
    for (std::uint64_t i = 0; i < element_.count && !faults.full(); ++i) {
      const bool whole = read(row);
      const PlyPlace place{&element_, i, source_.line()};
      if (!whole) faults.add(place.fault(trouble_.kind, trouble_.got, trouble_.allowed));
      if (!whole || !take(std::as_const(row), place)) return false;
    }
    return !faults.full();
  }

 private:
  bool read(PlyRow& row) {
    if (!source_.begin_row()) return failed();
    for (std::size_t i = 0; i < plan_.to.size(); ++i) {
      const PlyProperty& property = element_.properties[i];
      const std::size_t to = plan_.to[i];
      if (property.count) {
        if (!read_list(property, to == PlyPlan::list, row.list)) return false;
        continue;
      }
      double skipped = 0;
      if (!source_.read(property.type, to < PlyPlan::slots ? row.numbers[to] : skipped))
        return failed();
    }
    return source_.end_row() || failed();
  }
  bool read_list(const PlyProperty& property, bool wanted, std::vector<double>& list) {
    double counted = 0;
    if (!source_.read(*property.count, counted)) return failed();
    if (counted < 0) return failed(FaultKind::malformed, counted, "a list's count, 0 or more");
    const auto count = static_cast<std::uint64_t>(counted);
    // Where so many numbers cannot follow, skipping them tells why.
    if (!wanted || !source_.has(property.type, count))
      return source_.skip(property.type, count) || failed();
    if (count > plan_.most_listed)
      return failed(FaultKind::limit, counted,
                    "at most " + std::to_string(plan_.most_listed) + " corners");
    list.resize(count);
    for (double& number : list)
      if (!source_.read(property.type, number)) return failed();
    return true;
  }
  bool failed() {
    trouble_ = source_.trouble();
    return false;
  }
  bool failed(FaultKind kind, double got, std::string allowed) {
    trouble_ = {kind, Value(got), std::move(allowed)};
    return false;
  }

  Source& source_;
  const PlyElement& element_;
  const PlyPlan& plan_;
  PlyTrouble trouble_;
};

}  // namespace tia
