// LitSpans: where along a line a light shines at all.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>

#include "core/math/vec3.h"

namespace tia {

/// LitSpans: up to two stretches of a line, ascending, outside of which a light gives nothing.
/// Space/units: distances along the line's unit direction.
struct LitSpans {
  struct Span {
    double from, to;
  };
  std::array<Span, 2> spans{};
  std::size_t count = 0;

  static LitSpans whole() {
    LitSpans all;
    all.add(-endless, endless);
    return all;
  }
  /// Adds a stretch behind the others, if it is not empty.
  void add(double from, double to) {
    if (from < to) spans[count++] = {from, to};
  }
  /// Whether all of that stretch is lit, as it is by most lights.
  bool has(double from, double to) const {
    return count == 1 && spans[0].from <= from && to <= spans[0].to;
  }
  const Span* begin() const { return spans.data(); }
  const Span* end() const { return spans.data() + count; }

  static constexpr double endless = std::numeric_limits<double>::infinity();
};

/// The form of a light that leaves part of space dark: `lit_spans(form, origin, direction)` is what
/// it does not leave dark of a line. Domain: a unit direction.
template <class Form>
concept LeavesDark = requires(const Form& form, const Vec3d& p) {
  { lit_spans(form, p, p) } -> std::same_as<LitSpans>;
};

}  // namespace tia
