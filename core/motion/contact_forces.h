// Small dense systems of contacts: how hard each presses so that none gives way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tia {

/// A symmetric positive semidefinite matrix: how fast contact i is parted by a unit of force at j.
struct ContactMatrix {
  std::size_t size = 0;
  std::vector<double> entries;

  explicit ContactMatrix(std::size_t n) : size(n), entries(n * n) {}
  double& at(std::size_t i, std::size_t j) { return entries[i * size + j]; }
  double at(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

/// The x of those contacts `chosen` for which (M x + b) is 0 there; x is 0 elsewhere. Contacts that
/// say the same share it.
/// Source: Golub, Van Loan, Matrix Computations (2013), 4.2: Cholesky's factors.
std::vector<double> solve_chosen(const ContactMatrix& m, std::span<const double> b,
                                 const std::vector<std::size_t>& chosen);

/// f >= 0 with a = M f + b >= 0 and f_i a_i = 0, a >= 0 to within `slack`; `chosen`, ascending, is
/// a guess at those that press.
/// Source: Judice, Pires, "A block principal pivoting algorithm for large-scale strictly monotone
/// linear complementarity problems", Computers & Operations Research 21 (1994); where that does
/// not end, Lawson, Hanson, Solving Least Squares Problems (1974), chapter 23, NNLS.
std::vector<double> nonnegative_forces(const ContactMatrix& m, std::span<const double> b,
                                       double slack, std::vector<std::size_t> chosen = {});

}  // namespace tia
