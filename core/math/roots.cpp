#include "core/math/roots.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tia {
namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon() / 2;
using Coefficients = std::span<const double>;

// The last of Newton's steps to a stationary point: what is left goes with its square, and that is
// how much a polynomial differs there from its extremum.
constexpr double knot_unit = 0x1p-30;

struct Sample {
  double value, slope;
};
Sample sample(Coefficients c, double t) {
  Sample s{0, 0};
  for (std::size_t i = c.size(); i-- > 0;) {
    s.slope = s.slope * t + s.value;
    s.value = s.value * t + c[i];
  }
  return s;
}

// How far Horner's value may be off.
// Source: Higham, Accuracy and Stability of Numerical Algorithms (2002), 5.1: gamma_2n p~(|t|).
double rounding_of(Coefficients c, double t) {
  double sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * std::fabs(t) + std::fabs(c[i]);
  return 2 * static_cast<double>(c.size()) * rounding_unit * sum;
}

// The root between a and b, where p changes its sign: Newton's steps, halving the bracket where
// they leave it or come down too slowly.
// Source: Press et al., Numerical Recipes (2007), 9.4, rtsafe.
double root_in_bracket(Coefficients c, double a, double b, double sign_at_b, double tolerance) {
  constexpr int most_steps = 200;
  double t = a + (b - a) / 2, step = b - a;
  for (int i = 0; i < most_steps; ++i) {
    const Sample s = sample(c, t);
    if (s.value == 0) return t;
    (s.value * sign_at_b > 0 ? b : a) = t;
    const double newton = t - s.value / s.slope;
    const bool slow = std::fabs(2 * s.value) > std::fabs(step * s.slope);
    const double next = newton > a && newton < b && !slow ? newton : a + (b - a) / 2;
    step = next - t;
    t = next;
    if (std::fabs(step) <= tolerance) break;
  }
  return t;
}

// Walks over the knots, the interval's ends and the stationary points between them, and gathers the
// roots: a change of sign is one, a run of knots at which p is 0 to rounding is touched.
class Gatherer {
 public:
  Gatherer(Coefficients c, double tolerance, double* out, RootBracket* brackets)
      : c_(c), tolerance_(tolerance), out_(out), brackets_(brackets) {}

  void end(double t) { visit(t, 0); }
  void stationary(double t) { visit(t, rounding_of(c_, t)); }
  int finish() {
    if (in_run_) emit_touching(run_last_);
    return nan_ ? 0 : count_;
  }

 private:
  void visit(double t, double noise) {
    const double value = sample(c_, t).value;
    nan_ = nan_ || std::isnan(value);
    if (std::fabs(value) <= noise) {
      if (!in_run_) run_first_ = t;
      run_last_ = t;
      in_run_ = true;
      return;
    }
    const double sign = value > 0 ? 1 : -1;
    if (sign_ * sign < 0) {
      emit(root_in_bracket(c_, before_, t, sign, tolerance_), {before_, t});
    } else if (in_run_) {
      emit_touching(run_first_);
      if (sign_ != 0) emit_touching(run_last_);
    }
    in_run_ = false;
    sign_ = sign;
    before_ = t;
  }
  void emit(double t, RootBracket bracket) {
    if (brackets_ != nullptr) brackets_[count_] = bracket;
    out_[count_++] = t;
  }
  void emit_touching(double t) { emit(t, {t, t}); }

  Coefficients c_;
  double tolerance_;
  double* out_;
  RootBracket* brackets_;
  int count_ = 0;
  bool nan_ = false, in_run_ = false;
  double run_first_ = 0, run_last_ = 0;  // of the knots since before_ at which p is 0
  double before_ = 0, sign_ = 0;         // the last knot at which it is not, and its sign
};

// The coefficients of the n-th derivative over n!.
Coefficients derivative(Coefficients c, std::size_t n, std::array<double, max_degree + 1>& out) {
  double binomial = 1;
  for (std::size_t i = 0; i + n < c.size(); ++i) {
    out[i] = c[i + n] * binomial;
    binomial = binomial * static_cast<double>(i + 1 + n) / static_cast<double>(i + 1);
  }
  return {out.data(), c.size() - n};
}

// The roots between low and high of a derivative of second degree, which need no isolation.
int second_degree_knots(Coefficients c, double low, double high, double* out) {
  const QuadraticRoots roots = quadratic_roots(c[2], c[1] / 2, c[0]);
  int count = 0;
  if (roots.count > 0 && low < roots.t0 && roots.t0 < high) out[count++] = roots.t0;
  if (roots.count > 1 && low < roots.t1 && roots.t1 < high) out[count++] = roots.t1;
  return count;
}

}  // namespace

int real_roots(Coefficients c, double low, double high, std::span<double> roots,
               std::span<RootBracket> brackets) {
  while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
  if (c.size() < 2) return 0;
  const double size = std::max(std::fabs(low), std::fabs(high));
  std::array<double, max_degree + 1> buffer;
  std::array<double, max_degree> knots;
  int found = 0;
  std::size_t n = c.size() - 1;
  if (n > 2) {
    n -= 2;
    found = second_degree_knots(derivative(c, n, buffer), low, high, knots.data());
  }
  while (n-- > 0) {
    Gatherer gatherer(derivative(c, n, buffer), (n == 0 ? rounding_unit : knot_unit) * size,
                      roots.data(), n == 0 ? brackets.data() : nullptr);
    gatherer.end(low);
    for (int i = 0; i < found; ++i) gatherer.stationary(knots[static_cast<std::size_t>(i)]);
    gatherer.end(high);
    found = gatherer.finish();
    std::copy_n(roots.begin(), found, knots.begin());
  }
  return found;
}

}  // namespace tia
