#include "core/shapes/implicit.h"

#include "core/formulas/parse.h"

namespace tia {
namespace {

FormulaNames names_of(const Implicit& implicit) { return {{"x", "y", "z"}, implicit.parameters}; }

}  // namespace

void Implicit::check(const Place& at, Faults& faults) const {
  const FormulaNames names = names_of(*this);
  check_parameters(names, at.at("parameters"), faults);
  ProgramBuilder builder;
  read_formula(f, names, at.at("f"), builder, faults);
}

FieldForm prepare(const Implicit& implicit) {
  return field_form(program_of({implicit.f}, names_of(implicit)), prepare(implicit.bounds));
}

}  // namespace tia
