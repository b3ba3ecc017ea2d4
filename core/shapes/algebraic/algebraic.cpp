#include "core/shapes/algebraic/algebraic.h"

#include <algorithm>
#include <cmath>

#include "core/shapes/algebraic/compact.h"
#include "core/shapes/formula/gradient.h"

namespace tia {

void Algebraic::check(const Place& at, Faults& faults) const {
  const Place all = at.at("terms");
  for (std::size_t i = 0; i < terms.size() && !faults.full(); ++i)
    if (terms[i].degree() > most_algebraic_degree)
      faults.add({FaultKind::out_of_range, all.at(i).pointer(), write_value(terms[i]),
                  "a total degree of at most " + std::to_string(most_algebraic_degree)});
  const auto sums = collected(terms);
  if (std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.degree() == 0; }))
    faults.add({FaultKind::out_of_range, all.pointer(), write_value(terms),
                "more than a constant: a term with x, y or z that no others cancel"});
}

AlgebraicForm prepare(const Algebraic& algebraic) {
  const std::vector<AlgebraicTerm> terms = collected(algebraic.terms);
  AlgebraicForm form{NestedPolynomial(terms), {}, {}};
  if (algebraic.bounds) form.region = prepare(*algebraic.bounds);
  else if (const auto box = compact_bounds(terms)) form.reach = Region{*box};
  return form;
}

Vec3d normal(const AlgebraicForm& algebraic, const Vec3d& p, int element) {
  if (element > 0) return normal(*algebraic.region, p, element - 1);
  return direction_of(algebraic.polynomial.sum<ValueAndGradient<double>>(p).gradient);
}
Vec3<Octet> normals(const AlgebraicForm& algebraic, const Vec3<Octet>& p) {
  return direction_of(algebraic.polynomial.sum<ValueAndGradient<Octet>>(p).gradient);
}

Vec2d uv(const AlgebraicForm& algebraic, const Vec3d& p, int element) {
  if (element > 0) return uv(*algebraic.region, p, element - 1);
  return longitude_latitude(algebraic.region ? p - bounds(*algebraic.region).center() : p);
}

}  // namespace tia
