// The language of formulas in scenes: numbers, names, + - * / ^, parentheses and functions. A text
// is read from left to right with two stacks (Dijkstra 1961, the shunting yard), never recursively.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/formulas/program.h"
#include "core/input/errors.h"

namespace tia {

/// What a formula may be: its length in bytes, what is open at once, and what one evaluation costs
/// in units of an addition.
inline constexpr std::size_t most_formula_bytes = 4096;
inline constexpr std::size_t most_formula_depth = 100;
inline constexpr int most_formula_cost = 4000;

/// Names of a formula: its variables, in the order of the program's, and numbers by name.
struct FormulaNames {
  std::vector<std::string_view> variables;
  std::map<std::string, double> parameters;
  /// The terms that the variables stand for; none: the program's own.
  std::vector<int> terms = {};
};

/// Reads a formula into the builder. `^` binds tightest, above unary minus, and to the right;
/// a number to a whole constant power of at most 256 is that product, to any other power defined
/// from 0 up.
/// Returns: its term, or -1 and a fault at the place, with the column (from 1, in bytes), what
/// stands there and what was expected.
int read_formula(const std::string& text, const FormulaNames& names, const Place& at,
                 ProgramBuilder& builder, Faults& faults);

/// Faults of parameters whose names a formula cannot say, or that mean something else in it.
void check_parameters(const FormulaNames& names, const Place& at, Faults& faults);

/// The program of formulas that have been checked, all in one. Domain: no faults.
Program program_of(const std::vector<std::string_view>& texts, const FormulaNames& names);

}  // namespace tia
