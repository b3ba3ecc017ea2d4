// The first roots of eight polynomials, isolated by their signs in Bernstein's form.
#pragma once

#include <span>

#include "core/math/octet.h"

namespace tia {

/// FirstRoots: for each lane what of [0, 1] holds exactly one root, the first; or that there is no
/// root; or that rounding leaves it open.
struct FirstRoots {
  Octet from{0.0}, to{1.0};  ///< of the isolated: the polynomial has other signs at both ends
  Octet guess{0.0};          ///< the isolated root, roughly
  unsigned isolated = 0;     ///< lanes, as bits
  unsigned falls = 0;        ///< of these, those above 0 before their root
  unsigned unsure = 0;
};

/// Of the lanes in `wanted` as bits, of polynomials sum b_j binomial(n, j) s^j (1 - s)^(n - j), b
/// their n + 1 coefficients, which are spoilt; `noise` is what any of them may be off by.
///
/// A polynomial is within the hull of its coefficients: where all have one sign, it has no root;
/// where they change theirs once, exactly one (Descartes' rule). Else it is parted.
/// Domain: 1 <= n <= 64. Lanes with NaN come out as unsure.
/// Source: Lane, Riesenfeld, "Bounds on a Polynomial", BIT 21 (1981); Farin, Curves and Surfaces
/// for CAGD (2002), ch. 5: de Casteljau's subdivision.
FirstRoots first_roots(std::span<Octet> b, const Octet& noise, unsigned wanted);

}  // namespace tia
