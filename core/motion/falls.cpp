#include "core/motion/falls.h"

#include <algorithm>

#include "core/math/roots.h"

namespace tia {
namespace {

double value_at(std::span<const double> c, double t) {
  double sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
  return sum;
}

// The fall of a parabola is at its smaller root where it opens upwards, else at its larger one.
Falls falls_of_parabola(double c0, double c1, double c2, double until, GapStart start) {
  Falls falls;
  const bool sinks = c1 < 0 || (c1 == 0 && c2 < 0);
  double t = 0;
  if (c2 >= 0 && (!sinks || start == GapStart::touching)) return falls;
  if (c2 == 0) {
    t = std::max(-c0 / c1, 0.0);
  } else if (c0 <= 0 && sinks) {
    t = 0;
  } else {
    const QuadraticRoots roots = quadratic_roots(c2, c1 / 2, c0);
    if (roots.count == 2) t = c2 > 0 ? roots.t0 : roots.t1;
    else if (c2 < 0) t = std::max(-c1 / (2 * c2), 0.0);  // below 0 even where it is highest
    else return falls;
    if (t < 0) return falls;
  }
  if (t <= until) falls.add(t);
  return falls;
}

// Between two stationary points, where the polynomial falls.
void add_fall(std::span<const double> c, double from, double to, Falls& falls) {
  if (value_at(c, from) <= 0) return falls.add(from);
  std::array<double, Falls::most> roots;
  if (real_roots(c, from, to, roots) > 0) falls.add(roots[0]);
}

}  // namespace

Falls falls_of(std::span<const double> c, double until, GapStart start) {
  while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
  if (c.size() <= 3) {
    const auto at = [&](std::size_t i) { return i < c.size() ? c[i] : 0; };
    return falls_of_parabola(at(0), at(1), at(2), until, start);
  }
  std::array<double, Falls::most + 1> slope;
  for (std::size_t i = 1; i < c.size(); ++i) slope[i - 1] = c[i] * static_cast<double>(i);
  std::array<double, Falls::most + 2> knots;
  const int turns =
      real_roots({slope.data(), c.size() - 1}, 0, until, std::span(knots).subspan(1, Falls::most));
  knots[0] = 0;
  knots[static_cast<std::size_t>(turns) + 1] = until;
  Falls falls;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(turns); ++i) {
    const double from = knots[i], to = knots[i + 1];
    if (!(value_at(c, to) < value_at(c, from)) || value_at(c, to) > 0) continue;
    const bool ignored = start == GapStart::touching && from == 0 && c[2] >= 0;
    if (!ignored) add_fall(c, from, to, falls);
  }
  return falls;
}

}  // namespace tia
