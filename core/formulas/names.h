// What names mean in a formula: variables, numbers and functions.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/formulas/program.h"
#include "core/input/errors.h"

namespace tia {

/// FormulaFunction: an operation that formulas call by name.
struct FormulaFunction {
  std::string_view name;
  Op op;
  std::size_t arguments;
};
/// Returns: nullptr where no function is called so.
const FormulaFunction* function_of(std::string_view name);

/// Names of a formula: its variables, in the order of the program's, and numbers by name.
struct FormulaNames {
  std::vector<std::string_view> variables;
  std::map<std::string, double> parameters;
  /// The terms that the variables stand for; none: the program's own.
  std::vector<int> terms = {};

  /// All names that mean something in it.
  std::vector<std::string_view> known() const;
};

/// Faults of parameters whose names a formula cannot say, or that mean something else in it.
void check_parameters(const FormulaNames& names, const Place& at, Faults& faults);

}  // namespace tia
