#include "core/formulas/names.h"

#include <algorithm>
#include <array>

#include "core/formulas/tokens.h"

namespace tia {
namespace {

// THE LIST of functions.
constexpr std::array functions{
    FormulaFunction{"sqrt", Op::sqrt, 1},   FormulaFunction{"abs", Op::abs, 1},
    FormulaFunction{"min", Op::min, 2},     FormulaFunction{"max", Op::max, 2},
    FormulaFunction{"floor", Op::floor, 1}, FormulaFunction{"exp", Op::exp, 1},
    FormulaFunction{"log", Op::log, 1},     FormulaFunction{"sin", Op::sin, 1},
    FormulaFunction{"cos", Op::cos, 1},     FormulaFunction{"tan", Op::tan, 1},
    FormulaFunction{"asin", Op::asin, 1},   FormulaFunction{"acos", Op::acos, 1},
    FormulaFunction{"atan", Op::atan, 1},   FormulaFunction{"atan2", Op::atan2, 2},
    FormulaFunction{"sinh", Op::sinh, 1},   FormulaFunction{"cosh", Op::cosh, 1},
    FormulaFunction{"tanh", Op::tanh, 1},
};

}  // namespace

const FormulaFunction* function_of(std::string_view name) {
  const auto found = std::ranges::find(functions, name, &FormulaFunction::name);
  return found == functions.end() ? nullptr : &*found;
}

std::vector<std::string_view> FormulaNames::known() const {
  std::vector<std::string_view> all = variables;
  for (const auto& [name, value] : parameters) all.push_back(name);
  all.push_back("pi");
  for (const FormulaFunction& each : functions) all.push_back(each.name);
  return all;
}

void check_parameters(const FormulaNames& names, const Place& at, Faults& faults) {
  for (const auto& [name, value] : names.parameters) {
    std::string_view wrong;
    if (!is_name(name)) wrong = "a name: a letter, then letters, digits and _";
    const auto& own = names.variables;
    if (name == "pi" || function_of(name) != nullptr ||
        std::find(own.begin(), own.end(), name) != own.end())
      wrong = "a name that means nothing else in formulas";
    if (!wrong.empty())
      faults.add({FaultKind::out_of_range, at.at(name).pointer(), Value(name), std::string(wrong)});
  }
}

}  // namespace tia
