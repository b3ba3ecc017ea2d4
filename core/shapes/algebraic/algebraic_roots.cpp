#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/math/roots.h"
#include "core/shapes/algebraic/algebraic.h"

namespace tia {
namespace {

// AlongLine: a Sum at origin + s direction, a polynomial in s; and the same with every number
// replaced by its magnitude, which says how much its coefficients are rounded.
class AlongLine {
 public:
  AlongLine& operator=(double number) {
    count_ = 1;
    value_[0] = number;
    magnitude_[0] = std::fabs(number);
    return *this;
  }
  void add(double number) {
    value_[0] += number;
    magnitude_[0] += std::fabs(number);
  }
  void add(const AlongLine& other) {
    for (; count_ < other.count_; ++count_) value_[count_] = magnitude_[count_] = 0;
    for (std::size_t i = 0; i < other.count_; ++i) {
      value_[i] += other.value_[i];
      magnitude_[i] += other.magnitude_[i];
    }
  }
  void multiply(const Line& line, std::size_t axis) {
    const double o = component(line.origin, axis), d = component(line.direction, axis);
    if (count_ == 1 && value_[0] == 0) return;
    times(value_, o, d);
    times(magnitude_, std::fabs(o), std::fabs(d));
    ++count_;
  }
  // The coefficients; 0 for what is no more than rounding. So a line that meets the surface fewer
  // times than its degree has no far root, which rounding alone would make.
  std::span<const double> coefficients() {
    const double rounding =
        static_cast<double>(count_ + 7) * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < count_; ++i)
      if (std::fabs(value_[i]) <= rounding * magnitude_[i]) value_[i] = 0;
    while (count_ > 1 && value_[count_ - 1] == 0) --count_;
    return {value_.data(), count_};
  }

 private:
  using List = std::array<double, most_coefficients>;
  void times(List& list, double o, double d) const {
    list[count_] = list[count_ - 1] * d;
    for (std::size_t i = count_ - 1; i > 0; --i) list[i] = list[i] * o + list[i - 1] * d;
    list[0] *= o;
  }

  std::size_t count_ = 0;
  List value_, magnitude_;
};

// ---- along the line -------------------------------------------------------------------------

double value_at(std::span<const double> c, double t) {
  double sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
  return sum;
}

// The exponent of a power of two R such that from |t| = R on the first term outweighs all others:
// R is at least 4 M, M the greatest |c[n - k] / c[n]|^(1/k), and 1/4 + 1/16 + ... = 1/3. So all
// roots are within, and both ends have the sign of the line's own ends.
int root_bound_exponent(std::span<const double> c) {
  const int n = static_cast<int>(c.size()) - 1, first = std::ilogb(c.back());
  int most = std::numeric_limits<int>::min();
  for (int k = 1; k <= n; ++k) {
    const double each = c[static_cast<std::size_t>(n - k)];
    if (each == 0) continue;
    const int ratio = std::ilogb(each) + 1 - first;  // |c[n - k] / c[n]| < 2^ratio
    most = std::max(most, ratio / k + 1);
  }
  return most == std::numeric_limits<int>::min() ? 0 : most + 2;
}

// The coefficients for t in units of 2^exponent, over that power's n-th.
void rescale(std::span<const double> c, int exponent, std::span<double> out) {
  const int n = static_cast<int>(c.size()) - 1;
  for (int i = 0; i <= n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out[at] = std::ldexp(c[at], exponent * (i - n));
  }
}

// Sets what there is of c in [-1, 1], in units of `reach` from `start` on.
void find(std::span<const double> c, double start, double reach, AlgebraicRoots& found) {
  found.count = real_roots(c, -1, 1, found.t, found.brackets);
  found.degree = static_cast<int>(c.size()) - 1;
  const double first = value_at(c, -1);
  found.starts_inside = first < 0;
  if (first == 0 && found.count > 0) {
    // The first root is the end itself: what follows it is the other side.
    const double next = found.count > 1 ? found.t[1] : 1;
    found.starts_inside = !(value_at(c, (found.t[0] + next) / 2) < 0);
  }
  found.for_each_t([&](double& t) { t = start + t * reach; });
}

// A step of Newton's or two on the sum itself at the root's point: its digits are then those of the
// terms, whatever their expansion along the line has lost. A root that only touches stays, and so
// does one at which the sum is no more than its own rounding, where a step would not lessen it.
double polished(const AlgebraicForm& algebraic, const Line& line, const RootBracket& bracket,
                double t) {
  if (bracket.low == bracket.high) return t;
  constexpr int most_steps = 3;
  double before = std::numeric_limits<double>::infinity(), last = t;
  for (int i = 0; i < most_steps; ++i) {
    const Vec3d p = line.at(t);
    const auto at =
        algebraic.polynomial.sum<ValueAndSlope<double>>(PointOnLine<double>{p, line.direction});
    if (!(2 * std::fabs(at.value) < before)) return last;
    before = std::fabs(at.value);
    last = t;
    const double next = t - at.value / at.slope;
    if (!(bracket.low < next && next < bracket.high)) return t;
    // The error after a step is about its square: 2^-80, below double's rounding even where the
    // derivative is small.
    const double step = std::fabs(next - t);
    if (step <= 0x1p-40 * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z))) return next;
    t = next;
  }
  return last;
}
void polish(const AlgebraicForm& algebraic, const Line& line, AlgebraicRoots& found) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    found.t[i] = polished(algebraic, line, found.brackets[i], found.t[i]);
}

bool finite(std::span<const double> c) {
  return std::all_of(c.begin(), c.end(), [](double each) { return std::isfinite(each); });
}

void find_everywhere(const AlgebraicForm& algebraic, const Line& line, AlgebraicRoots& found) {
  AlongLine sum;
  algebraic.polynomial.sum(line, sum);
  const auto c = sum.coefficients();
  if (!finite(c)) return;
  const int exponent = root_bound_exponent(c);
  std::array<double, most_coefficients> scaled;
  rescale(c, exponent, scaled);
  find({scaled.data(), c.size()}, 0, std::ldexp(1.0, exponent), found);
  polish(algebraic, line, found);
}

void find_within(const AlgebraicForm& algebraic, const Line& line, AlgebraicRoots& found) {
  const double in = found.within.in.t, out = found.within.out.t;
  const double start = (in + out) / 2, reach = (out - in) / 2;
  AlongLine sum;
  algebraic.polynomial.sum(Line{line.at(start), line.direction * reach}, sum);
  const auto c = sum.coefficients();
  if (!finite(c)) return;
  find(c, start, reach, found);
  polish(algebraic, line, found);
  // Rounding must not put a root outside the bounds.
  found.for_each_t([&](double& t) { t = std::clamp(t, in, out); });
}

}  // namespace

AlgebraicRoots roots(const AlgebraicForm& algebraic, const Line& line) {
  AlgebraicRoots found;
  found.within = chord(algebraic.region, line);
  if (!algebraic.region) find_everywhere(algebraic, line, found);
  else if (!found.within.empty()) find_within(algebraic, line, found);
  return found;
}

}  // namespace tia
