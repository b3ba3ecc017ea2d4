// Symbol: a number that is written into a program instead of being computed, so that formulas in
// C++ read like those of numbers.
#pragma once

#include "core/formulas/program.h"
#include "core/math/vec3.h"

namespace tia {

/// Symbol. Its builder outlives it.
struct Symbol {
  ProgramBuilder* builder = nullptr;
  int number = 0;

  friend Symbol operator+(const Symbol& a, const Symbol& b) { return a.with(Op::add, b); }
  friend Symbol operator-(const Symbol& a, const Symbol& b) { return a.with(Op::subtract, b); }
  friend Symbol operator*(const Symbol& a, const Symbol& b) { return a.with(Op::multiply, b); }
  friend Symbol operator-(const Symbol& a) {
    return {a.builder, a.builder->operation(Op::negate, a.number)};
  }
  friend Symbol operator+(const Symbol& a, double b) { return b == 0 ? a : a + a.constant(b); }
  friend Symbol operator-(const Symbol& a, double b) { return a + -b; }
  friend Symbol operator*(const Symbol& a, double b) { return b == 1 ? a : a * a.constant(b); }

  friend Symbol abs(const Symbol& a) {
    return {a.builder, a.builder->operation(Op::abs, a.number)};
  }
  friend Symbol lesser(const Symbol& a, const Symbol& b) { return a.with(Op::min, b); }
  friend Symbol greater(const Symbol& a, const Symbol& b) { return a.with(Op::max, b); }
  friend Symbol lesser(const Symbol& a, double b) { return lesser(a, a.constant(b)); }
  friend Symbol greater(const Symbol& a, double b) { return greater(a, a.constant(b)); }
  friend Symbol hypot(const Symbol& a, const Symbol& b) { return a.with(Op::hypot, b); }

  Symbol constant(double value) const { return {builder, builder->constant(value)}; }

 private:
  Symbol with(Op op, const Symbol& b) const {
    return {builder, builder->operation(op, number, b.number)};
  }
};

/// SymbolPoint: a point of space in a program.
struct SymbolPoint {
  Symbol x, y, z;

  friend SymbolPoint operator-(const SymbolPoint& p, const Vec3d& v) {
    return {p.x - v.x, p.y - v.y, p.z - v.z};
  }
};
/// Of a point and a vector of numbers; what is 0 leaves no term.
inline Symbol dot(const SymbolPoint& p, const Vec3d& v) {
  Symbol sum = p.x.constant(0);
  bool empty = true;
  const auto add = [&](const Symbol& each, double factor) {
    if (factor == 0) return;
    sum = empty ? each * factor : sum + each * factor;
    empty = false;
  };
  add(p.x, v.x);
  add(p.y, v.y);
  add(p.z, v.z);
  return sum;
}
inline Symbol length(const SymbolPoint& p) { return hypot(hypot(p.x, p.y), p.z); }

}  // namespace tia
