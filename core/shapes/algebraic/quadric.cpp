#include "core/shapes/algebraic/quadric.h"

#include <algorithm>
#include <limits>

#include "core/input/codec.h"
#include "core/math/roots.h"

namespace tia {
namespace {

// Sum: what is no more than the rounding of its terms counts as 0. So a line along a cylinder or
// along a cone's side has no far second root, which rounding alone would make.
class Sum {
 public:
  void add(double term) {
    value_ += term;
    terms_ += std::fabs(term);
  }
  double value() const {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    return std::fabs(value_) <= rounding * terms_ ? 0 : value_;
  }

 private:
  double value_ = 0, terms_ = 0;
};

using Ten = std::array<double, 10>;

// The terms of the symmetric bilinear form that is the second-degree part where v = w.
void add_bilinear(const Ten& k, const Vec3d& v, const Vec3d& w, Sum& sum) {
  sum.add(k[0] * v.x * w.x);
  sum.add(k[1] * v.y * w.y);
  sum.add(k[2] * v.z * w.z);
  sum.add(k[3] / 2 * v.x * w.y);
  sum.add(k[3] / 2 * v.y * w.x);
  sum.add(k[4] / 2 * v.x * w.z);
  sum.add(k[4] / 2 * v.z * w.x);
  sum.add(k[5] / 2 * v.y * w.z);
  sum.add(k[5] / 2 * v.z * w.y);
}

double second_degree(const Ten& k, const Vec3d& d) {
  Sum sum;
  add_bilinear(k, d, d, sum);
  return sum.value();
}

double half_slope(const Ten& k, const Vec3d& o, const Vec3d& d) {
  Sum sum;
  add_bilinear(k, o, d, sum);
  sum.add(k[6] * d.x / 2);
  sum.add(k[7] * d.y / 2);
  sum.add(k[8] * d.z / 2);
  return sum.value();
}

// Half the gradient of the second-degree part.
Vec3d half_gradient(const Ten& k, const Vec3d& v) {
  return {k[0] * v.x + (k[3] * v.y + k[4] * v.z) / 2, k[1] * v.y + (k[3] * v.x + k[5] * v.z) / 2,
          k[2] * v.z + (k[4] * v.x + k[5] * v.y) / 2};
}

double value_at(const Ten& k, const Vec3d& p) {
  return dot(half_gradient(k, p) + Vec3d{k[6], k[7], k[8]}, p) + k[9];
}

}  // namespace

void Quadric::check(const Place& at, Faults& faults) const {
  const auto zero = [](double c) { return c == 0; };
  if (std::all_of(coefficients.begin(), coefficients.end() - 1, zero))
    faults.add({FaultKind::out_of_range, at.at("coefficients").pointer(), write_value(coefficients),
                "more than a constant: one of the first nine other than 0"});
}

QuadricForm prepare(const Quadric& quadric) {
  QuadricForm form{quadric.coefficients, {}};
  double largest = 0;
  for (const double c : form.coefficients) largest = std::max(largest, std::fabs(c));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (double& c : form.coefficients) c = std::ldexp(c, -exponent);
  if (quadric.bounds) form.region = prepare(*quadric.bounds);
  return form;
}

QuadricSpans spans_of(const QuadricForm& quadric, const Line& line) {
  constexpr double far = Aabb::far;
  const auto& k = quadric.coefficients;
  const double a = second_degree(k, line.direction);
  const double b = half_slope(k, line.origin, line.direction);
  const double c = value_at(k, line.origin);
  const QuadraticRoots roots = quadratic_roots(a, b, c);
  if (!std::isfinite(a + b + c)) return {};
  if (roots.count == 2) {
    if (a > 0) return {1, {roots.t0, roots.t1}};
    return {2, {-far, roots.t0, roots.t1, far}};
  }
  if (roots.count == 1) {
    if (b > 0) return {1, {-far, roots.t0}};
    return {1, {roots.t0, far}};
  }
  if (a < 0 || (a == 0 && c < 0)) return {1, {-far, far}};
  return {};
}

Vec3d normal(const QuadricForm& quadric, const Vec3d& p, int element) {
  if (element > 0) return normal(*quadric.region, p, element - 1);
  const auto& k = quadric.coefficients;
  const Vec3d gradient = half_gradient(k, p) * 2.0 + Vec3d{k[6], k[7], k[8]};
  return gradient == Vec3d{0, 0, 0} ? Vec3d{0, 1, 0} : unit(gradient);
}

Vec2d uv(const QuadricForm& quadric, const Vec3d& p, int element) {
  if (element > 0) return uv(*quadric.region, p, element - 1);
  return longitude_latitude(quadric.region ? p - bounds(*quadric.region).center() : p);
}

}  // namespace tia
