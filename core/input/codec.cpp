#include "core/input/codec.h"

#include <cmath>

namespace tia::detail {

std::optional<double> read_number(const Value& value, const Place& at, const Spec& spec,
                                  bool integer, Faults& faults) {
  constexpr double exact = 9007199254740991;  // 2^53 - 1: beyond it integers are not exact
  const auto* number = value.as<double>();
  if (number == nullptr || (integer && *number != std::trunc(*number))) {
    wrong_type(value, at, range_text(spec, integer), faults);
    return std::nullopt;
  }
  if (!in_range(*number, spec) || !std::isfinite(*number) ||
      (integer && std::fabs(*number) > exact)) {
    faults.add({FaultKind::out_of_range, at.pointer(), value, range_text(spec, integer)});
    return std::nullopt;
  }
  return *number;
}

Value::Object number_schema(const Spec& spec, bool integer) {
  Value::Object schema{{"type", integer ? "integer" : "number"}};
  if (std::isfinite(spec.min))
    schema.emplace_back(spec.open_min ? "exclusiveMinimum" : "minimum", spec.min);
  if (std::isfinite(spec.max)) schema.emplace_back("maximum", spec.max);
  return schema;
}

}  // namespace tia::detail
