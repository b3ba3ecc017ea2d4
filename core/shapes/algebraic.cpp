#include "core/shapes/algebraic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/math/roots.h"

namespace tia {
namespace {

constexpr std::size_t most_coefficients = most_algebraic_degree + 1;

// The terms with like powers added up, without those that are 0, the highest powers first.
std::vector<AlgebraicTerm> collected(std::vector<AlgebraicTerm> terms) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](const auto& a, const auto& b) { return a.powers > b.powers; });
  std::vector<AlgebraicTerm> sums;
  for (const AlgebraicTerm& term : terms) {
    if (!sums.empty() && sums.back().powers == term.powers)
      sums.back().coefficient += term.coefficient;
    else sums.push_back(term);
  }
  std::erase_if(sums, [](const auto& sum) { return sum.coefficient == 0; });
  return sums;
}

// ---- Horner's rule in three variables, one within the other ---------------------------------

// The sum of the terms from `at` on that share their powers before `axis`, less those powers; `at`
// goes past them. A Sum is made of a number, adds another and multiplies by a coordinate.
template <class Sum, std::size_t axis, class Point>
Sum nested_sum(const AlgebraicTerm*& at, const AlgebraicTerm* end, const Point& point) {
  if constexpr (axis == 3) {
    return Sum((at++)->coefficient);
  } else {
    const auto& first = at->powers;
    const auto shares = [&](const AlgebraicTerm& term) {
      return std::equal(first.begin(), first.begin() + axis, term.powers.begin());
    };
    Sum sum(0);
    for (int power = first[axis];; --power) {
      if (at != end && at->powers[axis] == power && shares(*at))
        sum.add(nested_sum<Sum, axis + 1>(at, end, point));
      if (power == 0) return sum;
      sum.multiply(point, axis);
    }
  }
}
template <class Sum, class Point>
Sum sum_at(const std::vector<AlgebraicTerm>& terms, const Point& point) {
  if (terms.empty()) return Sum(0);
  const AlgebraicTerm* at = terms.data();
  return nested_sum<Sum, 0>(at, at + terms.size(), point);
}

double component(const Vec3d& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// ValueAndGradient: a Sum at one point.
struct ValueAndGradient {
  double value;
  std::array<double, 3> gradient{};

  explicit ValueAndGradient(double number) : value(number) {}
  void add(const ValueAndGradient& other) {
    value += other.value;
    for (std::size_t i = 0; i < 3; ++i) gradient[i] += other.gradient[i];
  }
  void multiply(const Vec3d& p, std::size_t axis) {
    const double by = component(p, axis);
    for (double& each : gradient) each *= by;
    gradient[axis] += value;
    value *= by;
  }
};

// AlongLine: a Sum at origin + s direction, a polynomial in s; and the same with every number
// replaced by its magnitude, which says how much its coefficients are rounded.
class AlongLine {
 public:
  explicit AlongLine(double number) : count_(1) {
    value_[0] = number;
    magnitude_[0] = std::fabs(number);
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

  std::size_t count_;
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
  found.count = real_roots(c, -1, 1, found.t);
  const double first = value_at(c, -1);
  found.starts_inside = first < 0;
  if (first == 0 && found.count > 0) {
    // The first root is the end itself: what follows it is the other side.
    const double next = found.count > 1 ? found.t[1] : 1;
    found.starts_inside = !(value_at(c, (found.t[0] + next) / 2) < 0);
  }
  for (int i = 0; i < found.count; ++i) {
    double& t = found.t[static_cast<std::size_t>(i)];
    t = start + t * reach;
  }
}

bool finite(std::span<const double> c) {
  return std::all_of(c.begin(), c.end(), [](double each) { return std::isfinite(each); });
}

void find_everywhere(const AlgebraicForm& algebraic, const Line& line, AlgebraicRoots& found) {
  auto sum = sum_at<AlongLine>(algebraic.terms, line);
  const auto c = sum.coefficients();
  if (!finite(c)) return;
  const int exponent = root_bound_exponent(c);
  std::array<double, most_coefficients> scaled;
  rescale(c, exponent, scaled);
  find({scaled.data(), c.size()}, 0, std::ldexp(1.0, exponent), found);
}

void find_within(const AlgebraicForm& algebraic, const Line& line, AlgebraicRoots& found) {
  const double in = found.within.in.t, out = found.within.out.t;
  const double start = (in + out) / 2, reach = (out - in) / 2;
  auto sum = sum_at<AlongLine>(algebraic.terms, Line{line.at(start), line.direction * reach});
  const auto c = sum.coefficients();
  if (!finite(c)) return;
  find(c, start, reach, found);
  // Rounding must not put a root outside the bounds.
  for (int i = 0; i < found.count; ++i) {
    double& t = found.t[static_cast<std::size_t>(i)];
    t = std::clamp(t, in, out);
  }
}

}  // namespace

void Algebraic::check(const Place& at, Faults& faults) const {
  const Place all = at.at("terms");
  for (std::size_t i = 0; i < terms.size() && !faults.full(); ++i)
    if (terms[i].degree() > most_algebraic_degree)
      faults.add({FaultKind::out_of_range, all.at(i).pointer(), write_value(terms[i]),
                  "a total degree of at most " + std::to_string(most_algebraic_degree)});
  const auto sums = collected(terms);
  if (std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.degree() == 0; }))
    faults.add({FaultKind::out_of_range, all.pointer(), write_value(terms),
                "more than a constant: a term with x, y or z that no others cancel"});
}

AlgebraicForm prepare(const Algebraic& algebraic) {
  AlgebraicForm form{collected(algebraic.terms), {}};
  if (algebraic.bounds) form.region = prepare(*algebraic.bounds);
  return form;
}

AlgebraicRoots roots(const AlgebraicForm& algebraic, const Line& line) {
  AlgebraicRoots found;
  found.within = chord(algebraic.region, line);
  if (!algebraic.region) find_everywhere(algebraic, line, found);
  else if (!found.within.empty()) find_within(algebraic, line, found);
  return found;
}

Vec3d normal(const AlgebraicForm& algebraic, const Vec3d& p, int element) {
  if (element > 0) return normal(*algebraic.region, p, element - 1);
  const auto g = sum_at<ValueAndGradient>(algebraic.terms, p).gradient;
  const double steepest = std::max({std::fabs(g[0]), std::fabs(g[1]), std::fabs(g[2])});
  return steepest > 0 && std::isfinite(steepest) ? unit({g[0], g[1], g[2]}) : Vec3d{0, 1, 0};
}

Vec2d uv(const AlgebraicForm& algebraic, const Vec3d& p, int element) {
  if (element > 0) return uv(*algebraic.region, p, element - 1);
  return longitude_latitude(algebraic.region ? p - bounds(*algebraic.region).center() : p);
}

}  // namespace tia
