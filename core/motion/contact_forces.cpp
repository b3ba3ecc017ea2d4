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

}  // namespace

std::vector<double> solve_chosen(const ContactMatrix& m, std::span<const double> b,
                                 const std::vector<std::size_t>& chosen) {
  const std::size_t n = chosen.size();
  ContactMatrix factor(n);
  std::vector<double> y(n), x(m.size);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m.at(chosen[i], chosen[j]) * (i == j ? 1 + stiffening : 1);
      for (std::size_t k = 0; k < j; ++k) sum -= factor.at(i, k) * factor.at(j, k);
      if (i == j)
        factor.at(i, i) = std::sqrt(std::max(sum, stiffening * m.at(chosen[i], chosen[i])));
      else factor.at(i, j) = sum / factor.at(j, j);
    }
    double sum = -b[chosen[i]];
    for (std::size_t k = 0; k < i; ++k) sum -= factor.at(i, k) * y[k];
    y[i] = sum / factor.at(i, i);
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = y[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= factor.at(k, i) * x[chosen[k]];
    x[chosen[i]] = sum / factor.at(i, i);
  }
  return x;
}

std::vector<double> nonnegative_forces(const ContactMatrix& m, std::span<const double> b,
                                       double slack) {
  std::vector<double> forces(m.size);
  std::vector<std::size_t> chosen;
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
