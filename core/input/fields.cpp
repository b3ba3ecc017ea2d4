#include "core/input/fields.h"

#include "core/input/json.h"

namespace tia {

bool in_range(double number, const Spec& spec) {
  if (spec.not_zero && number == 0) return false;
  return (spec.open_min ? number > spec.min : number >= spec.min) && number <= spec.max;
}

std::string about_text(const Spec& spec) {
  return *spec.unit == '\0' ? spec.about : std::string(spec.about) + ", in " + spec.unit;
}

std::string range_text(const Spec& spec, bool integer) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::string text = integer ? "an integer" : "a number";
  if (spec.min > -inf && spec.max < inf) {
    text += spec.open_min ? " above " : " from ";
    text += number_text(spec.min) + (spec.open_min ? ", at most " : " to ") + number_text(spec.max);
  } else if (spec.min > -inf) {
    text += (spec.open_min ? " above " : " not below ") + number_text(spec.min);
  } else if (spec.max < inf) {
    text += " not above " + number_text(spec.max);
  }
  if (spec.not_zero) text += ", not 0";
  if (*spec.unit != '\0') text += std::string(" (") + spec.unit + ")";
  return text;
}

}  // namespace tia
