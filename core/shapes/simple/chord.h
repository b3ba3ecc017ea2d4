// The chord: what something convex holds of a line.
#pragma once

#include "core/shapes/crossing.h"

namespace tia {

/// Chord: the stretch of a line between two crossings. A default one is empty.
struct Chord {
  Crossing in{Aabb::far, 0}, out{-Aabb::far, 0};

  static Chord everything() { return {{-Aabb::far, 0}, {Aabb::far, 0}}; }
  bool empty() const { return !(in.t <= out.t); }
};

/// Calls emit for its ends, unless it is empty.
template <class Emit>
void emit_ends(const Chord& chord, Emit&& emit) {
  if (chord.empty()) return;
  emit(chord.in.t, chord.in.element);
  emit(chord.out.t, chord.out.element);
}

}  // namespace tia
