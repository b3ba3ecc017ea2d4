// Term: a number that is written into a program instead of being computed, so that formulas in C++
// read like those of numbers.
#pragma once

#include "core/formulas/program.h"
#include "core/math/vec3.h"

namespace tia {

/// Term. Its builder outlives it.
struct Term {
  ProgramBuilder* builder = nullptr;
  int number = 0;

  friend Term operator+(const Term& a, const Term& b) { return a.with(Op::add, b); }
  friend Term operator-(const Term& a, const Term& b) { return a.with(Op::subtract, b); }
  friend Term operator*(const Term& a, const Term& b) { return a.with(Op::multiply, b); }
  friend Term operator-(const Term& a) {
    return {a.builder, a.builder->operation(Op::negate, a.number)};
  }
  friend Term operator+(const Term& a, double b) { return b == 0 ? a : a + a.constant(b); }
  friend Term operator-(const Term& a, double b) { return a + -b; }
  friend Term operator*(const Term& a, double b) { return b == 1 ? a : a * a.constant(b); }

  friend Term abs(const Term& a) { return {a.builder, a.builder->operation(Op::abs, a.number)}; }
  friend Term lesser(const Term& a, const Term& b) { return a.with(Op::min, b); }
  friend Term greater(const Term& a, const Term& b) { return a.with(Op::max, b); }
  friend Term lesser(const Term& a, double b) { return lesser(a, a.constant(b)); }
  friend Term greater(const Term& a, double b) { return greater(a, a.constant(b)); }
  friend Term hypot(const Term& a, const Term& b) { return a.with(Op::hypot, b); }

  Term constant(double value) const { return {builder, builder->constant(value)}; }

 private:
  Term with(Op op, const Term& b) const {
    return {builder, builder->operation(op, number, b.number)};
  }
};

/// TermPoint: a point of space in a program.
struct TermPoint {
  Term x, y, z;

  friend TermPoint operator-(const TermPoint& p, const Vec3d& v) {
    return {p.x - v.x, p.y - v.y, p.z - v.z};
  }
};
/// Of a point and a vector of numbers; what is 0 leaves no term.
inline Term dot(const TermPoint& p, const Vec3d& v) {
  Term sum = p.x.constant(0);
  bool empty = true;
  const auto add = [&](const Term& each, double factor) {
    if (factor == 0) return;
    sum = empty ? each * factor : sum + each * factor;
    empty = false;
  };
  add(p.x, v.x);
  add(p.y, v.y);
  add(p.z, v.z);
  return sum;
}
inline Term length(const TermPoint& p) { return hypot(hypot(p.x, p.y), p.z); }

}  // namespace tia
