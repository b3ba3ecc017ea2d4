// What a rough surface's facets send on by a single scattering, whether they are round or
// stretched.
#pragma once

#include "core/materials/grain_albedo.h"

namespace tia {

/// FacetAlbedo: along a direction w in the facets' frame, and in the mean, by the cosine.
template <class Real>
struct FacetAlbedo {
  Ggx<Real> ggx;
  Real root;  ///< of round facets' alpha
  /// Where they are stretched, of what Schlick's and Fresnel's equations divide; that is left out
  /// where nobody asks, for it takes long.
  Mask<Real> grained{}, grained_glass{};

  SchlickAlbedo<Real> along(const Vec3<Real>& w) const {
    const SchlickAlbedo<Real> round = schlick_albedo(w.z, root);
    return any(grained) ? chosen(grain_albedo(ggx, w), round) : round;
  }
  SchlickAlbedo<Real> mean() const {
    using std::sqrt;
    const SchlickAlbedo<Real> round = mean_schlick_albedo(root);
    if (!any(grained)) return round;
    return chosen(mean_grain_albedo(sqrt(ggx.alpha_x), sqrt(ggx.alpha_y)), round);
  }
  /// A dielectric's, to either side.
  Real of_glass(const Vec3<Real>& w, const Real& eta) const {
    const Real round = glass_albedo(w.z, root, eta);
    return any(grained_glass) ? select(grained_glass, grain_glass_albedo(ggx, w, eta), round)
                              : round;
  }
  Real mean_of_glass(const Real& eta) const {
    using std::sqrt;
    const Real round = mean_glass_albedo(root, eta);
    if (!any(grained_glass)) return round;
    return select(grained_glass, mean_grain_glass_albedo(sqrt(ggx.alpha_x), sqrt(ggx.alpha_y), eta),
                  round);
  }

 private:
  SchlickAlbedo<Real> chosen(const SchlickAlbedo<Real>& grain,
                             const SchlickAlbedo<Real>& round) const {
    return {select(grained, grain.a, round.a), select(grained, grain.b, round.b)};
  }
};

}  // namespace tia
