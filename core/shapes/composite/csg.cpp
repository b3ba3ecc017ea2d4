#include "core/shapes/composite/csg.h"

#include <cmath>

namespace tia {
namespace {

// Boundaries up to here count as the one at t: `same`, and 2^-40 of t for the rounding of t itself.
double end_of_one(double t, double same) {
  return std::isfinite(t) ? t + same + 0x1p-40 * std::fabs(t) : t;
}

bool keeps(Operation operation, bool in_a, bool in_b) {
  switch (operation) {
    case Operation::union_: return in_a || in_b;
    case Operation::intersection: return in_a && in_b;
    case Operation::difference: break;
  }
  return in_a && !in_b;
}

// A list of boundaries that is walked along the line.
struct Walk {
  const Spans& spans;
  std::size_t next = 0;

  bool done() const { return next == spans.size(); }
  bool inside() const { return next % 2 == 1; }
  const Boundary& boundary() const { return spans[next]; }
  /// Passes all boundaries up to t. Returns: the last of them, or null.
  const Boundary* pass(double t) {
    const Boundary* last = nullptr;
    while (!done() && spans[next].t <= t) last = &spans[next++];
    return last;
  }
};

}  // namespace

void merge(Operation operation, const Spans& a, const Spans& b, double same, Spans& result) {
  result.clear();
  Walk in_a{a}, in_b{b};
  bool inside = false;
  while (!in_a.done() || !in_b.done()) {
    const bool a_first = !in_a.done() && (in_b.done() || in_a.boundary().t <= in_b.boundary().t);
    const double t = a_first ? in_a.boundary().t : in_b.boundary().t;
    const double end = end_of_one(t, same);
    const bool a_before = in_a.inside();
    const Boundary* of_a = in_a.pass(end);
    const Boundary* of_b = in_b.pass(end);
    const bool now = keeps(operation, in_a.inside(), in_b.inside());
    if (now == inside) continue;
    inside = now;
    result.push_back(in_a.inside() != a_before ? *of_a : *of_b);
  }
}

}  // namespace tia
