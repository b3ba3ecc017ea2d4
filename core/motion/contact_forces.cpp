#include "core/motion/contact_forces.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

// Enlarges the diagonal so that contacts that depend on each other leave something to divide by.
constexpr double stiffening = 1e-13;

double product_with(const ContactMatrix& m, std::size_t row, const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t j = 0; j < m.size; ++j) sum += m.at(row, j) * x[j];
  return sum;
}

// The contact outside of `chosen` that gives way fastest, or m.size.
std::size_t fastest(const ContactMatrix& m, std::span<const double> b,
                    const std::vector<double>& forces, const std::vector<std::size_t>& chosen,
                    double slack) {
  std::size_t worst = m.size;
  double least = -slack;
  for (std::size_t i = 0; i < m.size; ++i) {
    if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
    const double rate = product_with(m, i, forces) + b[i];
    if (rate < least) least = rate, worst = i;
  }
  return worst;
}

// Goes from the forces towards the wanted ones as far as all stay above 0, and drops those that are
// 0 there. Returns: whether none was.
bool step_towards(const std::vector<double>& wanted, std::vector<double>& forces,
                  std::vector<std::size_t>& chosen) {
  double share = 1;
  for (const std::size_t i : chosen)
    if (wanted[i] <= 0) share = std::min(share, forces[i] / (forces[i] - wanted[i]));
  if (!(share < 1)) {
    forces = wanted;
    return true;
  }
  for (const std::size_t i : chosen) {
    const bool stops = wanted[i] <= 0 && forces[i] / (forces[i] - wanted[i]) <= share;
    forces[i] = stops ? 0 : forces[i] + share * (wanted[i] - forces[i]);
  }
  std::erase_if(chosen, [&](std::size_t i) { return !(forces[i] > 0); });
  return false;
}

// From a guess: all that pull are let go, and all that give way press, at once, as long as they
// become fewer. Returns: whether none is left.
bool swaps_end(const ContactMatrix& m, std::span<const double> b, double slack,
               std::vector<std::size_t>& chosen, std::vector<double>& forces) {
  constexpr int most_failures = 4;
  std::size_t fewest = m.size + 1;
  for (int failures = 0; failures < most_failures;) {
    forces = solve_chosen(m, b, chosen);
    std::vector<std::size_t> next;
    std::size_t wrong = 0;
    for (std::size_t i = 0, k = 0; i < m.size; ++i) {
      const bool presses = k < chosen.size() && chosen[k] == i;
      k += presses ? 1 : 0;
      const bool swaps = presses ? !(forces[i] > 0) : product_with(m, i, forces) + b[i] < -slack;
      wrong += swaps ? 1 : 0;
      if (presses != swaps) next.push_back(i);
    }
    if (wrong == 0) return true;
    if (wrong < fewest) fewest = wrong;
    else ++failures;
    chosen = std::move(next);
  }
  return false;
}

}  // namespace

// The upper factor of the chosen rows, made row by row, and the right side with it.
std::vector<double> solve_chosen(const ContactMatrix& m, std::span<const double> b,
                                 const std::vector<std::size_t>& chosen) {
  const std::size_t n = chosen.size();
  ContactMatrix upper(n);
  std::vector<double> y(n), x(m.size);
  for (std::size_t i = 0; i < n; ++i) {
    y[i] = -b[chosen[i]];
    for (std::size_t j = i; j < n; ++j) upper.at(i, j) = m.at(chosen[i], chosen[j]);
    upper.at(i, i) *= 1 + stiffening;
  }
  for (std::size_t k = 0; k < n; ++k) {
    double* const row = &upper.at(k, 0);
    const double least = stiffening * m.at(chosen[k], chosen[k]);
    row[k] = std::sqrt(std::max(row[k], least));
    for (std::size_t j = k + 1; j < n; ++j) row[j] /= row[k];
    y[k] /= row[k];
    for (std::size_t i = k + 1; i < n; ++i) {
      double* const below = &upper.at(i, 0);
      const double share = row[i];
      if (share == 0) continue;
      for (std::size_t j = i; j < n; ++j) below[j] -= share * row[j];
      y[i] -= share * y[k];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = y[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= upper.at(i, k) * x[chosen[k]];
    x[chosen[i]] = sum / upper.at(i, i);
  }
  return x;
}

std::vector<double> nonnegative_forces(const ContactMatrix& m, std::span<const double> b,
                                       double slack, std::vector<std::size_t> chosen) {
  std::vector<double> forces;
  if (swaps_end(m, b, slack, chosen, forces)) return forces;
  forces.assign(m.size, 0);
  chosen.clear();
  for (std::size_t round = 0; round < 4 * m.size + 8; ++round) {
    const std::size_t next = fastest(m, b, forces, chosen, slack);
    if (next == m.size) break;
    chosen.push_back(next);
    while (!chosen.empty() && !step_towards(solve_chosen(m, b, chosen), forces, chosen)) {
    }
  }
  return forces;
}

}  // namespace tia
