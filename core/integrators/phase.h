// Phase functions: whereto what floats in a medium scatters light.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/warp.h"

namespace tia {

/// HenyeyGreenstein: a phase function of one number, the mean cosine g between the directions
/// before and after. It is its own density. Domain: |g| < 1.
/// Source: Henyey, Greenstein, "Diffuse radiation in the galaxy", Astrophysical Journal 93 (1941).
template <class Real>
struct HenyeyGreenstein {
  Real g;

  /// By solid angle, of a direction at that cosine to the one before.
  Real value(const Real& cosine) const {
    using std::sqrt;
    // 1 + g^2 - 2 g cosine, without its cancellation.
    const Real wide = (Real(1) - g) * (Real(1) - g) + (g + g) * (Real(1) - cosine);
    return lift<Real>(1 / (4 * pi)) * (Real(1) - g * g) / (wide * sqrt(wide));
  }
  /// The direction after `w`, drawn with density value(). Domain: unit w; u, v in [0, 1).
  /// Source: Witt, "Multiple scattering in reflection nebulae I", Astrophysical Journal Supplement
  /// 35 (1977), with g divided out, so that it holds for g = 0, too.
  Vec3<Real> sample(const Vec3<Real>& w, const Real& u, const Real& v) const {
    using std::sqrt;
    const DiscPoint<Real> d = square_to_disc(u, v);
    const Real square = d.x * d.x + d.y * d.y;
    const Real s = Real(1) - (square + square), turned = Real(1) + g * s, half = Real(0.5F);
    const Real cosine =
        (s + half * g * (s * s + Real(3)) + g * g * s + half * (g * g * g) * (s * s - Real(1))) /
        (turned * turned);
    const Real along = max_of(Real(-1), min_of(Real(1), cosine));
    const Real aside = sqrt((Real(1) - along * along) / max_of(square, Real(1e-30F)));
    const auto [x, y] = axes_around(w);
    return x * (d.x * aside) + y * (d.y * aside) + w * along;
  }
};

}  // namespace tia
