#include "core/shapes/algebraic/nested_polynomial.h"

namespace tia {

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

NestedPolynomial::NestedPolynomial(const std::vector<AlgebraicTerm>& terms) {
  for (const AlgebraicTerm& term : terms) degree_ = std::max(degree_, term.degree());
  if (!terms.empty()) append(0, terms.data(), terms.data() + terms.size());
  steps_.shrink_to_fit();
}

// The steps of the terms from `at` on that share their powers before `axis`, less those powers.
// Returns: the term after them.
const AlgebraicTerm* NestedPolynomial::append(std::size_t axis, const AlgebraicTerm* at,
                                              const AlgebraicTerm* end) {
  if (axis == 3) {
    steps_.push_back({Step::begin, 0, at->coefficient});
    return at + 1;
  }
  const auto first = at->powers;
  const auto shared = first.begin() + static_cast<std::ptrdiff_t>(axis);
  bool started = false;
  for (int power = first[axis];; --power) {
    if (at != end && at->powers[axis] == power &&
        std::equal(first.begin(), shared, at->powers.begin())) {
      at = append(axis + 1, at, end);
      if (started) {
        if (steps_.back().kind == Step::begin) steps_.back().kind = Step::add_number;
        else steps_.push_back({Step::add});
      }
      started = true;
    }
    if (power == 0) return at;
    steps_.push_back({Step::times, static_cast<std::uint8_t>(axis)});
  }
}

}  // namespace tia
