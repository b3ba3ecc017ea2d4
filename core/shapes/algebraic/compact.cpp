#include "core/shapes/algebraic/compact.h"

#include <cmath>

#include "core/math/interval.h"
#include "core/parallel/stopped.h"
#include "core/shapes/algebraic/nested_polynomial.h"

namespace tia {
namespace {

// The sizes of the terms of each degree, summed.
std::array<double, most_coefficients> sizes_of(const std::vector<AlgebraicTerm>& terms) {
  std::array<double, most_coefficients> sizes{};
  for (const AlgebraicTerm& term : terms)
    sizes[static_cast<std::size_t>(term.degree())] += std::fabs(term.coefficient);
  return sizes;
}

// Enclosure: a Sum over a box, or over eight.
template <class S>
struct Enclosure {
  Interval<S> value;

  Enclosure& operator=(double number) {
    value = Interval<S>(number);
    return *this;
  }
  void add(double number) { value = value + Interval<S>(number); }
  void add(const Enclosure& other) { value = value + other.value; }
  void multiply(const Vec3<Interval<S>>& box, std::size_t axis) {
    value = value * component(box, axis);
  }
};

// Proves that a form, a sum of terms of one even degree, is above 0 on the faces of the cube from
// -1 to 1, by intervals over squares.
class Definite {
 public:
  explicit Definite(const std::vector<AlgebraicTerm>& terms) : form_(terms) {}
  /// Returns: what the form is above on all faces; 0 or less where that was not found.
  double least() {
    for (std::size_t axis = 0; axis < 3 && least_ > 0; ++axis) search(axis, 0, 0, 1);
    return least_;
  }

 private:
  // The opposite face has the same values.
  void search(std::size_t axis, double u, double v, double half) {
    constexpr int most_squares = 2048;
    if (!(least_ > 0)) return;
    give_way();
    const Interval<double> one(1.0), a{u - half, u + half}, b{v - half, v + half};
    using Box3 = Vec3<Interval<double>>;
    const Box3 square = axis == 0 ? Box3{one, a, b} : axis == 1 ? Box3{b, one, a} : Box3{a, b, one};
    const Interval<double> range = form_.sum<Enclosure<double>>(square).value;
    if (!(range.hi > 0) || ++squares_ > most_squares) {
      least_ = 0;
    } else if (range.lo > 0 && 2 * range.lo > range.hi) {
      least_ = std::min(least_, range.lo);
    } else {
      const double part = half / 2;
      for (const double du : {-part, part})
        for (const double dv : {-part, part}) search(axis, u + du, v + dv, part);
    }
  }

  NestedPolynomial form_;
  double least_ = Aabb::far;
  int squares_ = 0;
};

// Beyond which size of its largest coordinate least * size^n outweighs all lower terms: by
// Descartes' rule they are equal at one size alone.
double outermost(const std::array<double, most_coefficients>& sizes, int n, double least) {
  const auto outweighed = [&](double size) {
    double sum = 0, power = least;
    for (int k = n - 1; k >= 0; --k) {
      sum += sizes[static_cast<std::size_t>(k)] / power;
      power *= size;
    }
    return sum < size * (1 - 1e-9);  // the margin is far above the rounding of the sum
  };
  double low = 0, high = 0x1p-30;
  while (!outweighed(high) && high < 0x1p30) high *= 2;
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (outweighed(middle) ? high : low) = middle;
  }
  return high;
}

// The box around those of 8 x 8 x 8 parts in which the polynomial may be 0 or less.
Aabb tightened(const NestedPolynomial& polynomial, const Aabb& box) {
  constexpr std::size_t parts = 8;
  std::array<std::array<double, parts + 1>, 3> knots;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double from = component(box.min, axis), to = component(box.max, axis);
    for (std::size_t i = 0; i <= parts; ++i)
      knots[axis][i] = from + (to - from) * (static_cast<double>(i) / parts);
  }
  const auto& [x, y, z] = knots;
  Aabb held;
  for (std::size_t at = 0; at < parts * parts * parts; at += 8) {
    give_way();
    const std::size_t i = at % parts, j = at / parts % parts, k = at / (parts * parts);
    const Vec3<Interval<Octet>> eight{
        {Octet::load_unaligned(&x[i]), Octet::load_unaligned(&x[i + 1])},
        {Octet(y[j]), Octet(y[j + 1])},
        {Octet(z[k]), Octet(z[k + 1])}};
    const unsigned above = bits(polynomial.sum<Enclosure<Octet>>(eight).value.lo > Octet(0.0));
    for (std::size_t n = 0; n < 8; ++n) {
      if ((above >> n & 1) != 0) continue;
      held.min = lower(held.min, {x[i + n], y[j], z[k]});
      held.max = upper(held.max, {x[i + n + 1], y[j + 1], z[k + 1]});
    }
  }
  return held;
}

}  // namespace

std::optional<Box> compact_bounds(const std::vector<AlgebraicTerm>& terms) {
  const auto sizes = sizes_of(terms);
  const int degree = NestedPolynomial(terms).degree();
  if (degree == 0 || degree % 2 != 0) return std::nullopt;
  std::vector<AlgebraicTerm> leading = terms;
  std::erase_if(leading, [&](const AlgebraicTerm& term) { return term.degree() != degree; });
  const double least = Definite(leading).least();
  if (!(least > 0)) return std::nullopt;
  const double size = outermost(sizes, degree, least);
  if (!(size < 0x1p30)) return std::nullopt;
  const NestedPolynomial polynomial(terms);
  Aabb held{{-size, -size, -size}, {size, size, size}};
  for (int round = 0; round < 4; ++round) held = tightened(polynomial, held);
  if (held.empty()) return std::nullopt;
  return Box{held.min, held.max};
}

}  // namespace tia
