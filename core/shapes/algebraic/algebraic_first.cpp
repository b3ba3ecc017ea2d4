// The first crossings of eight lines with an algebraic surface: on its stretch within the bounds
// each line's polynomial is summed in Bernstein's form, whose signs isolate the first root, and
// Newton's steps on the terms themselves find it to the last digits that these have.
#include <bit>
#include <span>

#include "core/math/first_roots.h"
#include "core/shapes/algebraic/algebraic.h"

namespace tia {
namespace {

// Rounded from about 2^53 on.
constexpr auto pascals_triangle() {
  std::array<std::array<double, most_coefficients>, most_coefficients> rows{};
  for (std::size_t n = 0; n < most_coefficients; ++n) {
    rows[n][0] = 1;
    for (std::size_t j = 1; j <= n; ++j) rows[n][j] = rows[n - 1][j - 1] + rows[n - 1][j];
  }
  return rows;
}
constexpr auto binomials = pascals_triangle();

/// Stretches: eight lines from their point at s = 0 to that at s = 1.
struct Stretches {
  Vec3<Octet> from, to;
};

// Bernstein: a Sum along stretches. A polynomial sum b_j binomial(n, j) s^j (1 - s)^(n - j) is held
// as what stands before s^j (1 - s)^(n - j), so that to multiply it by a coordinate, from (1 - s) +
// to s, takes no division and no digits: no coefficient is ever more than the terms at the largest
// coordinates.
class Bernstein {
 public:
  Bernstein& operator=(double number) {
    degree_ = 0;
    scaled_[0] = Octet(number);
    return *this;
  }
  Bernstein& operator=(const Bernstein& other) {
    degree_ = other.degree_;
    for (std::size_t j = 0; j <= degree_; ++j) scaled_[j] = other.scaled_[j];
    return *this;
  }
  // A number is that number times (s + (1 - s))^n.
  void add(double number) {
    const auto& row = binomials[degree_];
    for (std::size_t j = 0; j <= degree_; ++j) scaled_[j] = scaled_[j] + Octet(number * row[j]);
  }
  void add(Bernstein& other) {
    while (degree_ < other.degree_) raise();
    while (other.degree_ < degree_) other.raise();
    for (std::size_t j = 0; j <= degree_; ++j) scaled_[j] = scaled_[j] + other.scaled_[j];
  }
  void multiply(const Stretches& along, std::size_t axis) {
    const Octet from = component(along.from, axis), to = component(along.to, axis);
    scaled_[degree_ + 1] = to * scaled_[degree_];
    for (std::size_t j = degree_; j > 0; --j) scaled_[j] = from * scaled_[j] + to * scaled_[j - 1];
    scaled_[0] = from * scaled_[0];
    ++degree_;
  }
  // The coefficients b_j.
  std::span<Octet> coefficients() {
    for (std::size_t j = 0; j <= degree_; ++j)
      scaled_[j] = scaled_[j] * Octet(1 / binomials[degree_][j]);
    return {scaled_.data(), degree_ + 1};
  }

 private:
  // Times s + (1 - s).
  void raise() {
    scaled_[degree_ + 1] = scaled_[degree_];
    for (std::size_t j = degree_; j > 0; --j) scaled_[j] = scaled_[j] + scaled_[j - 1];
    ++degree_;
  }

  std::size_t degree_ = 0;
  std::array<Octet, most_coefficients> scaled_;
};

// What the coefficients may be off by: each takes part in two roundings a degree, in one a term,
// and in two a degree for each time that it is parted.
Octet noise_of(const NestedPolynomial& polynomial, const Stretches& along) {
  const auto size = [](const Octet& a, const Octet& b) { return max_of(abs_of(a), abs_of(b)); };
  const auto& [a, b] = along;
  const Vec3<Octet> largest{size(a.x, b.x), size(a.y, b.y), size(a.z, b.z)};
  const double roundings = 16.0 + static_cast<double>(polynomial.size()) +
                           128.0 * static_cast<double>(polynomial.degree());
  return polynomial.sum<Magnitude<Octet>>(largest).value * Octet(roundings * 0x1p-53);
}

// The roots in their brackets, by Newton's steps on the terms; halved where these lead out of the
// brackets or come down too slowly.
// Source: Press et al., Numerical Recipes (2007), 9.4, rtsafe.
Octet refined(const NestedPolynomial& polynomial, const Ray<Octet>& line, const FirstRoots& roots,
              Octet low, Octet high, Octet t) {
  constexpr int most_steps = 100;
  const OctetMask falls = mask_of(roots.falls);
  OctetMask fixed = mask_of(~roots.isolated);
  Octet step = high - low;
  for (int i = 0; i < most_steps && bits(fixed) != 0xFF; ++i) {
    const Vec3<Octet> p = line.at(t);
    const auto at = polynomial.sum<ValueAndSlope<Octet>>(PointOnLine<Octet>{p, line.direction});
    const auto early = (at.value > Octet(0.0)) == falls;
    low = select(early, t, low);
    high = select(early, high, t);
    const Octet newton = t - at.value / at.slope;
    const auto good =
        newton > low && newton < high && Octet(2.0) * abs_of(at.value) <= abs_of(step * at.slope);
    const Octet next = select(good, newton, (low + high) * Octet(0.5));
    step = next - t;
    // The error after a step of Newton's is about the step's square: 2^-56 after one of 2^-28,
    // below double's rounding. Bisection has to come down to that itself.
    const Octet size = abs_of(p.x) + abs_of(p.y) + abs_of(p.z);
    const auto there = at.value == Octet(0.0);
    t = select(fixed || there, t, next);
    fixed = fixed || there || abs_of(step) <= size * select(good, Octet(0x1p-28), Octet(0x1p-52));
  }
  return t;
}

FirstCrossing first_of_all(const AlgebraicForm& algebraic, const Line& line, double after,
                           double before) {
  FirstCrossing first;
  crossings(algebraic, line, [&](double t, int element) {
    if (after < t && t < before && t < first.at.t) first.at = {t, element};
  });
  return first;
}

}  // namespace

EightCrossings first_crossings(const AlgebraicForm& algebraic, const EightLines& eight) {
  EightCrossings found;
  unsigned unsure = eight.wanted;
  if (const auto& searched = algebraic.searched()) {
    const EightChords within = chords(*searched, eight.line);
    const Octet start = max_of(eight.after, within.in), end = within.out;
    const unsigned wanted = eight.wanted & bits(start <= end && start <= eight.before);
    if (wanted == 0) return found;
    const Stretches along{eight.line.at(start), eight.line.at(end)};
    Bernstein sum;
    algebraic.polynomial.sum(along, sum);
    const FirstRoots roots =
        first_roots(sum.coefficients(), noise_of(algebraic.polynomial, along), wanted);
    unsure = roots.unsure;
    if (roots.isolated != 0) {
      const auto at = [&](const Octet& share) { return start + share * (end - start); };
      const Octet t = refined(algebraic.polynomial, eight.line, roots, at(roots.from), at(roots.to),
                              at(roots.guess));
      const Octet clipped = min_of(max_of(t, start), end);
      const unsigned hit = roots.isolated & bits(clipped > eight.after);
      unsure |= roots.isolated & ~hit;
      const Octet kept = select(clipped < eight.before && mask_of(hit), clipped, Octet(Aabb::far));
      kept.store_unaligned(found.t.data());
    }
  }
  for (unsigned left = unsure; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const FirstCrossing first =
        first_of_all(algebraic, eight.line_of(i), lane(eight.after, i), lane(eight.before, i));
    found.t[static_cast<std::size_t>(i)] = first.at.t;
    found.element[static_cast<std::size_t>(i)] = first.at.element;
    found.work += work_of(algebraic);
  }
  return found;
}

}  // namespace tia
