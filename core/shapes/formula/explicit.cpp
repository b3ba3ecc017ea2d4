#include "core/shapes/formula/explicit.h"

#include "core/formulas/parse.h"

namespace tia {
namespace {

// z is a number of its own, which the formula itself must not name.
constexpr int variable_z = 2;
FormulaNames names_of(const Explicit& graph) { return {{"x", "y"}, graph.parameters}; }

}  // namespace

void Explicit::check(const Place& at, Faults& faults) const {
  check_formulas({{"z", z}}, names_of(*this), at, faults);
}

IsosurfaceForm prepare(const Explicit& graph) {
  ProgramBuilder builder;
  Faults faults;
  const int height = read_formula(graph.z, names_of(graph), {}, builder, faults);
  faults.raise();
  const int f = builder.operation(Op::subtract, builder.variable(variable_z), height);
  return isosurface_form(builder.program({f}), prepare(graph.bounds));
}

}  // namespace tia
