// Program: a formula as a flat list of instructions, evaluated on numbers, intervals and duals.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/formulas/dual.h"
#include "core/parallel/per_thread.h"

namespace tia {

enum class Op : std::uint8_t {
  constant,
  variable,
  add,
  subtract,
  multiply,
  divide,
  negate,
  whole_power,  ///< to a constant whole number
  pow,
  sqrt,
  abs,
  min,
  max,
  floor,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sinh,
  cosh,
  tanh,
  sincos,  ///< of programs only: both of one term
  hypot    ///< sqrt(a^2 + b^2), whose slopes are bounded where both are 0; of distances only
};

/// What an operation takes, in units of an addition, roughly.
int cost_of(Op op);

/// Instruction: slots[to] = op(slots[a], slots[b]); of a sincos the cosine goes to slots[b].
struct Instruction {
  Op op = Op::constant;
  std::uint16_t to = 0, a = 0, b = 0;
  int whole = 0;      ///< the exponent, the variable's number
  double number = 0;  ///< the constant
};

/// Program. Its results stay in their slots.
struct Program {
  std::vector<Instruction> instructions;
  std::vector<std::uint16_t> results;
  std::size_t slots = 0;
  int cost = 0;
};

namespace detail {

template <class T>
T operated(const Instruction& i, const T& a, const T& b, WhereOf<T>& where) {
  switch (i.op) {
    case Op::constant: return T(i.number);
    case Op::variable: break;
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return quotient(a, b, where);
    case Op::negate: return -a;
    case Op::whole_power: return whole_power(a, i.whole);
    case Op::pow: return pow_of(a, b, where);
    case Op::sqrt: return sqrt_of(a, where);
    case Op::abs: return abs_of(a);
    case Op::min: return lesser(a, b);
    case Op::max: return greater(a, b);
    case Op::floor: return floor_of(a, where);
    case Op::exp: return exp_of(a);
    case Op::log: return log_of(a, where);
    case Op::sin: return sincos_of(a).sine;
    case Op::cos: return sincos_of(a).cosine;
    case Op::sincos: break;
    case Op::tan: return tan_of(a, where);
    case Op::asin: return asin_of(a, where);
    case Op::acos: return acos_of(a, where);
    case Op::atan: return atan_of(a);
    case Op::atan2: return atan2_of(a, b, where);
    case Op::sinh: return sinh_of(a);
    case Op::cosh: return cosh_of(a);
    case Op::tanh: return tanh_of(a);
    case Op::hypot: return hypot_of(a, b);
  }
  return a;
}

}  // namespace detail

/// Computes the program's results at a point or over a box. Returns: its slots, good until this
/// thread's next run of the same scalar.
template <class T>
const T* run(const Program& program, const T* variables, WhereOf<T>& where) {
  auto& scratch = per_thread<std::vector<T>, struct Slots>();
  if (scratch.size() < program.slots) scratch.resize(program.slots);
  T* const slots = scratch.data();
  for (const Instruction& i : program.instructions) {
    if (i.op == Op::variable) {
      slots[i.to] = variables[i.whole];
    } else if (i.op == Op::sincos) {
      const SineCosine<T> both = sincos_of(slots[i.a]);
      slots[i.to] = both.sine;
      slots[i.b] = both.cosine;
    } else {
      slots[i.to] = detail::operated(i, slots[i.a], slots[i.b], where);
    }
  }
  return slots;
}
/// The first result.
template <class T>
T evaluate(const Program& program, const T* variables, WhereOf<T>& where) {
  return run(program, variables, where)[program.results.front()];
}
template <class T>
T evaluate(const Program& program, const T* variables) {
  WhereOf<T> where;
  return evaluate(program, variables, where);
}

/// ProgramBuilder: makes a program term by term. A term is a number; like terms are one, and what
/// has only constants is computed once.
class ProgramBuilder {
 public:
  int constant(double number);
  int variable(int number);
  /// Domain: an operation of one term, or of two.
  int operation(Op op, int a, int b = -1);
  int whole_power(int a, int exponent);
  /// a^b, by multiplying where b is a small whole number.
  int power(int a, int b);

  int cost() const { return cost_; }
  /// What the results need, in few slots. Domain: at most 2^15 terms.
  Program program(const std::vector<int>& results) const;

 private:
  struct Term {
    Op op;
    int a, b, whole;
    double number;
    auto key() const { return std::tuple(op, a, b, whole, number); }
  };
  class Writer;
  int add(const Term& term);
  std::vector<Term> needed(const std::vector<int>& results, std::vector<int>& renumbered) const;

  std::vector<Term> terms_;
  std::map<std::tuple<Op, int, int, int, double>, int> known_;
  int cost_ = 0;
};

}  // namespace tia
