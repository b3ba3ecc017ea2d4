#include "core/formulas/program.h"

#include <algorithm>
#include <cmath>

namespace tia {

int cost_of(Op op) {
  switch (op) {
    case Op::constant:
    case Op::variable:
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::negate:
    case Op::abs:
    case Op::min:
    case Op::max:
    case Op::floor: return 1;
    case Op::divide:
    case Op::sqrt:
    case Op::hypot:
    case Op::whole_power: return 4;
    case Op::pow: return 30;
    default: return 10;
  }
}

int ProgramBuilder::add(const Term& term) {
  const auto [found, is_new] = known_.emplace(term.key(), static_cast<int>(terms_.size()));
  if (is_new) {
    terms_.push_back(term);
    cost_ += cost_of(term.op);
  }
  return found->second;
}

int ProgramBuilder::constant(double number) {
  return add({Op::constant, -1, -1, 0, number == 0 ? 0 : number});  // -0 is 0
}
int ProgramBuilder::variable(int number) { return add({Op::variable, -1, -1, number, 0}); }

int ProgramBuilder::operation(Op op, int a, int b) {
  if (op == Op::multiply && a == b) return whole_power(a, 2);
  const auto at = [this](int term) -> const Term& {
    return terms_[static_cast<std::size_t>(term)];
  };
  const Term term{op, a, b, 0, 0};
  if (at(a).op == Op::constant && (b < 0 || at(b).op == Op::constant)) {
    Anywhere where;
    const double known = detail::operated(Instruction{op, 0, 0, 0, 0, 0}, at(a).number,
                                          b < 0 ? 0.0 : at(b).number, where);
    if (std::isfinite(known)) return constant(known);
  }
  return add(term);
}

int ProgramBuilder::whole_power(int a, int exponent) {
  if (exponent == 0) return constant(1);
  if (exponent == 1) return a;
  if (exponent < 0) return operation(Op::divide, constant(1), whole_power(a, -exponent));
  const Term& base = terms_[static_cast<std::size_t>(a)];
  if (base.op == Op::constant) {
    const double known = tia::whole_power(base.number, exponent);
    if (std::isfinite(known)) return constant(known);
  }
  return add({Op::whole_power, a, -1, exponent, 0});
}

int ProgramBuilder::power(int a, int b) {
  constexpr double most = 256;
  const Term& exponent = terms_[static_cast<std::size_t>(b)];
  if (exponent.op == Op::constant && std::fabs(exponent.number) <= most) {
    if (exponent.number == std::floor(exponent.number))
      return whole_power(a, static_cast<int>(exponent.number));
    if (exponent.number == 0.5) return operation(Op::sqrt, a);
  }
  return operation(Op::pow, a, b);
}

// The terms that the results are made of, in order; `renumbered` says which of them each is now.
std::vector<ProgramBuilder::Term> ProgramBuilder::needed(const std::vector<int>& results,
                                                         std::vector<int>& renumbered) const {
  std::vector<bool> used(terms_.size());
  for (const int each : results) used[static_cast<std::size_t>(each)] = true;
  for (std::size_t i = terms_.size(); i-- > 0;) {
    if (!used[i]) continue;
    for (const int each : {terms_[i].a, terms_[i].b})
      if (each >= 0) used[static_cast<std::size_t>(each)] = true;
  }
  std::vector<Term> kept;
  renumbered.assign(terms_.size(), -1);
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<int>(kept.size());
    Term term = terms_[i];
    for (int* each : {&term.a, &term.b})
      if (*each >= 0) *each = renumbered[static_cast<std::size_t>(*each)];
    kept.push_back(term);
  }
  return kept;
}

namespace {
// Hands out slots that are free.
class Slots {
 public:
  std::uint16_t take() {
    if (free_.empty()) return static_cast<std::uint16_t>(count_++);
    const std::uint16_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  void give_back(std::uint16_t slot) { free_.push_back(slot); }
  std::size_t count() const { return count_; }

 private:
  std::vector<std::uint16_t> free_;
  std::size_t count_ = 0;
};
}  // namespace

// Writes instructions, with slots for what is needed later.
class ProgramBuilder::Writer {
 public:
  Writer(const std::vector<Term>& terms, const std::vector<std::size_t>& results)
      : terms_(terms), last_use_(terms.size()), slot_(terms.size()), written_(terms.size()) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (const int each : {terms[i].a, terms[i].b})
        if (each >= 0) last_use_[static_cast<std::size_t>(each)] = i;
      if (is_wave(terms[i].op)) waves_[{terms[i].op, terms[i].a}] = i;
    }
    for (const std::size_t each : results) last_use_[each] = terms.size();  // never
    for (std::size_t i = 0; i < terms.size(); ++i) write(i);
    program_.slots = slots_.count();
    for (const std::size_t each : results) program_.results.push_back(slot_[each]);
  }
  Program take() { return std::move(program_); }

 private:
  static bool is_wave(Op op) { return op == Op::sin || op == Op::cos; }

  void write(std::size_t i) {
    const Term& term = terms_[i];
    if (!written_[i]) {
      if (is_wave(term.op)) write_wave(i);
      else write_alone(i);
    }
    // The operands' slots are free only now: a result is written in parts.
    give_back(term.a, i);
    if (term.b != term.a) give_back(term.b, i);
  }
  void write_alone(std::size_t i) {
    const Term& term = terms_[i];
    take_slot(i);
    add({term.op, slot_[i], slot_of(term.a), slot_of(term.b), term.whole, term.number});
  }
  // Sine and cosine of one term come together.
  void write_wave(std::size_t i) {
    const Term& term = terms_[i];
    const auto other = waves_.find({term.op == Op::sin ? Op::cos : Op::sin, term.a});
    if (other == waves_.end()) return write_alone(i);
    const std::size_t k = other->second;
    take_slot(i);
    take_slot(k);
    const bool sine = term.op == Op::sin;
    add({Op::sincos, slot_[sine ? i : k], slot_of(term.a), slot_[sine ? k : i], 0, 0});
  }
  void take_slot(std::size_t i) {
    slot_[i] = slots_.take();
    written_[i] = true;
  }
  void give_back(int operand, std::size_t i) {
    if (operand >= 0 && last_use_[static_cast<std::size_t>(operand)] == i)
      slots_.give_back(slot_of(operand));
  }
  std::uint16_t slot_of(int operand) const {
    return operand < 0 ? std::uint16_t(0) : slot_[static_cast<std::size_t>(operand)];
  }
  void add(const Instruction& instruction) {
    program_.instructions.push_back(instruction);
    program_.cost += cost_of(instruction.op);
  }

  const std::vector<Term>& terms_;
  std::vector<std::size_t> last_use_;
  std::vector<std::uint16_t> slot_;
  std::vector<bool> written_;
  std::map<std::pair<Op, int>, std::size_t> waves_;
  Slots slots_;
  Program program_;
};

Program ProgramBuilder::program(const std::vector<int>& results) const {
  std::vector<int> renumbered;
  const std::vector<Term> terms = needed(results, renumbered);
  std::vector<std::size_t> places;
  for (const int each : results)
    places.push_back(static_cast<std::size_t>(renumbered[static_cast<std::size_t>(each)]));
  return Writer(terms, places).take();
}

}  // namespace tia
