// Integrals that tests sum up themselves.
#pragma once

namespace tia::test {

// Simpson's rule.
template <class F>
double simpson(double from, double to, int halves, F f) {
  const double h = (to - from) / (2 * halves);
  double sum = f(from) + f(to);
  for (int i = 1; i < 2 * halves; ++i) sum += f(from + i * h) * (i % 2 == 1 ? 4 : 2);
  return sum * h / 3;
}

}  // namespace tia::test
