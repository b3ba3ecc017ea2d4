#include "core/shapes/algebraic/classics.h"

#include <cmath>
#include <map>
#include <utility>

namespace tia {
namespace {

// Polynomial: in x, y and z, by its coefficients. Sums and products are made in one fixed order.
class Polynomial {
 public:
  Polynomial(double constant) { sums_[{0, 0, 0}] = constant; }
  static Polynomial coordinate(std::size_t axis) {
    Polynomial one(0);
    one.sums_.clear();
    std::array<int, 3> powers{};
    powers[axis] = 1;
    one.sums_[powers] = 1;
    return one;
  }

  Polynomial& operator+=(const Polynomial& other) {
    for (const auto& [powers, coefficient] : other.sums_) sums_[powers] += coefficient;
    return *this;
  }
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a += b * -1.0; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(0);
    for (const auto& [m, of_a] : a.sums_)
      for (const auto& [n, of_b] : b.sums_)
        product.sums_[{m[0] + n[0], m[1] + n[1], m[2] + n[2]}] += of_a * of_b;
    return product;
  }
  std::vector<AlgebraicTerm> terms() const {
    std::vector<AlgebraicTerm> all;
    for (const auto& [powers, coefficient] : sums_) all.push_back({powers, coefficient});
    return all;
  }

 private:
  std::map<std::array<int, 3>, double> sums_;
};

std::array<Polynomial, 3> coordinates() {
  return {Polynomial::coordinate(0), Polynomial::coordinate(1), Polynomial::coordinate(2)};
}

Polynomial square(const Polynomial& a) { return a * a; }
Polynomial cube(const Polynomial& a) { return a * a * a; }

// Source: Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 22.7.4:
// T_n+1(t) = 2 t T_n(t) - T_n-1(t). All coefficients are integers that a double holds.
Polynomial chebyshev(int n, const Polynomial& t) {
  Polynomial before(1), now = t;
  for (int i = 1; i < n; ++i) before = std::exchange(now, 2.0 * t * now - before);
  return now;
}

}  // namespace

std::vector<AlgebraicTerm> Steiner::terms() const {
  const auto [x, y, z] = coordinates();
  return (square(x * y) + square(y * z) + square(z * x) - x * y * z).terms();
}

std::vector<AlgebraicTerm> BarthSextic::terms() const {
  const auto [x, y, z] = coordinates();
  const double p = (1 + std::sqrt(5.0)) / 2;
  const Polynomial x2 = square(x), y2 = square(y), z2 = square(z), p2(p + 1);  // p^2 = p + 1
  const Polynomial planes = (p2 * x2 - y2) * (p2 * y2 - z2) * (p2 * z2 - x2);
  return (4.0 * planes - (1 + 2 * p) * square(x2 + y2 + z2 - 1.0)).terms();
}

std::vector<AlgebraicTerm> Chmutov::terms() const {
  const auto [x, y, z] = coordinates();
  return (chebyshev(order, x) + chebyshev(order, y) + chebyshev(order, z)).terms();
}

std::vector<AlgebraicTerm> Heart::terms() const {
  const auto [x, y, z] = coordinates();
  const Polynomial z3 = cube(z);
  return (cube(square(x) + 2.25 * square(y) + square(z) - 1.0) - square(x) * z3 -
          9.0 / 80 * square(y) * z3)
      .terms();
}

std::vector<AlgebraicTerm> Clebsch::terms() const {
  const auto [x, y, z] = coordinates();
  const Polynomial x2 = square(x), y2 = square(y), z2 = square(z);
  const Polynomial cubes = x * x2 + y * y2 + z * z2;
  const Polynomial mixed = x2 * (y + z) + y2 * (z + x) + z2 * (x + y);
  const Polynomial pairs = x * y + y * z + z * x;
  return (81.0 * cubes - 189.0 * mixed + 54.0 * x * y * z + 126.0 * pairs - 9.0 * (x2 + y2 + z2) -
          9.0 * (x + y + z) + 1.0)
      .terms();
}

std::vector<AlgebraicTerm> Cayley::terms() const {
  const auto [x, y, z] = coordinates();
  return (4.0 * (square(x) + square(y) + square(z)) + 16.0 * x * y * z - 1.0).terms();
}

}  // namespace tia
