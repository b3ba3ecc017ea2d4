#include "core/shapes/bounds.h"

#include "core/input/codec.h"

namespace tia {

void Bounds::check(const Place& at, Faults& faults) const {
  constexpr const char* spellings = "min and max, or center and radius";
  const auto missing = [&](const char* field) {
    faults.add({FaultKind::missing, at.at(field).pointer(), std::nullopt, spellings});
  };
  const bool box = min || max, ball = center || radius;
  if (box && ball) {
    faults.add({FaultKind::conflict, at.at(center ? "center" : "radius").pointer(),
                center ? write_value(*center) : write_value(*radius), spellings});
  } else if (ball) {
    if (!center) missing("center");
    if (!radius) missing("radius");
  } else {
    if (!min) missing("min");
    if (!max) missing("max");
    if (min && max) Box{*min, *max}.check(at, faults);
  }
}

Chord chord(const std::optional<Region>& bounds, const Line& line) {
  if (!bounds) return Chord::everything();
  Chord found;
  crossings(*bounds, line, [&](double t, int element) {
    (found.in.t == Aabb::far ? found.in : found.out) = {t, element + 1};
  });
  return found;
}

}  // namespace tia
