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

namespace {

EightChords chords(const Box& box, const Ray<Octet>& line) {
  EightChords held{Octet(-Aabb::far), Octet(Aabb::far)};
  auto meets = line.origin.x == line.origin.x;
  const auto clip = [&](double low, double high, const Octet& o, const Octet& d) {
    const Octet to_low = (Octet(low) - o) / d, to_high = (Octet(high) - o) / d;
    const auto up = d > Octet(0.0), across = d == Octet(0.0);
    const auto within = Octet(low) <= o && o < Octet(high);
    const Octet ever = select(within, Octet(Aabb::far), Octet(-Aabb::far));
    const Octet near = select(across, -ever, select(up, to_low, to_high));
    const Octet far = select(across, ever, select(up, to_high, to_low));
    meets = meets && near <= far;  // no NaN does
    held = {max_of(near, held.in), min_of(far, held.out)};
  };
  const auto& [o, d] = line;
  clip(box.min.x, box.max.x, o.x, d.x);
  clip(box.min.y, box.max.y, o.y, d.y);
  clip(box.min.z, box.max.z, o.z, d.z);
  return {select(meets, held.in, Octet(Aabb::far)), select(meets, held.out, Octet(-Aabb::far))};
}

EightChords chords(const Sphere& sphere, const Ray<Octet>& line) {
  const auto to_center = static_cast<Vec3<Octet>>(sphere.center) - line.origin;
  const Octet middle = dot(to_center, line.direction);
  const auto aside = to_center - line.direction * middle;
  const Octet square = Octet(sphere.radius * sphere.radius) - dot(aside, aside);
  const Octet half = sqrt(square);  // NaN where the line misses
  return {middle - half, middle + half};
}

}  // namespace

EightChords chords(const Region& bounds, const Ray<Octet>& line) {
  return std::visit([&](const auto& kind) { return chords(kind, line); }, bounds.kind);
}

}  // namespace tia
