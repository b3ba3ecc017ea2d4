// NestedPolynomial: a sum of terms by Horner's rule in three variables, one within the other.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/math/octet.h"
#include "core/shapes/algebraic/algebraic_term.h"
#include "core/shapes/crossing.h"

namespace tia {

/// NestedPolynomial. Its rule is a list of steps on a stack of sums. A Sum is what is assigned a
/// number, adds a number or another Sum, which that may spoil, and is multiplied by a coordinate of
/// a point: a number, a gradient, a polynomial along a line.
class NestedPolynomial {
 public:
  NestedPolynomial() = default;
  /// Domain: terms that are collected.
  explicit NestedPolynomial(const std::vector<AlgebraicTerm>& terms);

  template <class Sum, class Point>
  void sum(const Point& point, Sum& out) const;
  template <class Sum, class Point>
  Sum sum(const Point& point) const {
    Sum out;
    sum(point, out);
    return out;
  }
  int degree() const { return degree_; }
  std::size_t heap() const { return steps_.capacity() * sizeof(Step); }
  std::size_t size() const { return steps_.size(); }

 private:
  struct Step {
    enum Kind : std::uint8_t { begin, times, add_number, add } kind = begin;
    std::uint8_t axis = 0;
    double number = 0;
  };
  const AlgebraicTerm* append(std::size_t axis, const AlgebraicTerm* at, const AlgebraicTerm* end);

  std::vector<Step> steps_;
  int degree_ = 0;
};

// The sum on top of the stack is held apart, in registers where it fits there.
template <class Sum, class Point>
void NestedPolynomial::sum(const Point& point, Sum& out) const {
  Sum waiting[3];
  std::size_t count = 0;
  Sum top;
  top = 0;
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Step::begin:
        if (&step != steps_.data()) waiting[count++] = top;
        top = step.number;
        break;
      case Step::times: top.multiply(point, step.axis); break;
      case Step::add_number: top.add(step.number); break;
      case Step::add: top.add(waiting[--count]); break;
    }
  }
  out = top;
}

template <class Real>
const Real& component(const Vec3<Real>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// ValueAndGradient: a Sum at one point.
template <class Real>
struct ValueAndGradient {
  Real value{};
  std::array<Real, 3> gradient{};

  ValueAndGradient& operator=(double number) {
    value = Real(number);
    gradient.fill(Real(0));
    return *this;
  }
  void add(double number) { value = value + Real(number); }
  void add(const ValueAndGradient& other) {
    value = value + other.value;
    for (std::size_t i = 0; i < 3; ++i) gradient[i] = gradient[i] + other.gradient[i];
  }
  void multiply(const Vec3<Real>& p, std::size_t axis) {
    const Real& by = component(p, axis);
    for (Real& each : gradient) each = each * by;
    gradient[axis] = gradient[axis] + value;
    value = value * by;
  }
};

/// PointOnLine: where a ValueAndSlope is summed.
template <class Real>
struct PointOnLine {
  Vec3<Real> p, direction;
};
/// ValueAndSlope: a Sum at one point of a line, and how it changes along that.
template <class Real>
struct ValueAndSlope {
  Real value{}, slope{};

  ValueAndSlope& operator=(double number) {
    value = Real(number);
    slope = Real(0);
    return *this;
  }
  void add(double number) { value = value + Real(number); }
  void add(const ValueAndSlope& other) {
    value = value + other.value;
    slope = slope + other.slope;
  }
  void multiply(const PointOnLine<Real>& at, std::size_t axis) {
    const Real& by = component(at.p, axis);
    slope = slope * by + value * component(at.direction, axis);
    value = value * by;
  }
};

/// Magnitude: a Sum of the terms' sizes, which says how much they may be rounded.
/// Space/units: points whose coordinates are not below 0.
template <class Real>
struct Magnitude {
  Real value{};

  Magnitude& operator=(double number) {
    value = Real(std::fabs(number));
    return *this;
  }
  void add(double number) { value = value + Real(std::fabs(number)); }
  void add(const Magnitude& other) { value = value + other.value; }
  void multiply(const Vec3<Real>& sizes, std::size_t axis) {
    value = value * component(sizes, axis);
  }
};

}  // namespace tia
