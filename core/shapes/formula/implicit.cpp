#include "core/shapes/formula/implicit.h"

#include "core/formulas/parse.h"

namespace tia {
namespace {

FormulaNames names_of(const Implicit& implicit) { return {{"x", "y", "z"}, implicit.parameters}; }

}  // namespace

void Implicit::check(const Place& at, Faults& faults) const {
  check_formulas({{"f", f}}, names_of(*this), at, faults);
}

IsosurfaceForm prepare(const Implicit& implicit) {
  return isosurface_form(program_of({implicit.f}, names_of(implicit)), prepare(implicit.bounds));
}

}  // namespace tia
