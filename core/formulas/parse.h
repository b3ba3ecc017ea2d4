// The language of formulas in scenes: numbers, names, + - * / ^, parentheses and functions. A text
// is read from left to right with two stacks (Dijkstra 1961, the shunting yard), never recursively.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formulas/names.h"

namespace tia {

/// What a formula may be: its length in bytes, what is open at once, and what one evaluation costs
/// in units of an addition.
inline constexpr std::size_t most_formula_bytes = 4096;
inline constexpr std::size_t most_formula_depth = 100;
inline constexpr int most_formula_cost = 4000;

/// Reads a formula into the builder. `^` binds tightest, above unary minus, and to the right;
/// a number to a whole constant power of at most 256 is that product, to any other power defined
/// from 0 up.
/// Returns: its term, or -1 and a fault at the place, with the column (from 1, in bytes), what
/// stands there and what was expected.
int read_formula(const std::string& text, const FormulaNames& names, const Place& at,
                 ProgramBuilder& builder, Faults& faults);

/// Faults of an object's formulas, each with the key that it is under, and of its "parameters".
void check_formulas(const std::vector<std::pair<const char*, std::string>>& formulas,
                    const FormulaNames& names, const Place& at, Faults& faults);

/// The program of formulas that have been checked, all in one. Domain: no faults.
Program program_of(const std::vector<std::string_view>& texts, const FormulaNames& names);

}  // namespace tia
