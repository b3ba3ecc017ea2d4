// Rough surfaces as facets whose normals are distributed by GGX; smooth ones by Fresnel's share.
// Directions are in the shading frame, whose third axis is the normal; wo is above the surface.
#pragma once

#include "core/math/warp.h"
#include "core/math/wide.h"

namespace tia {

/// Below this alpha a surface counts as smooth: it has one reflected and one refracted direction.
inline constexpr float smooth_alpha = 1e-3F;

/// Ggx: the distribution of facets' normals, stretched along the frame's first two axes.
/// Source: Trowbridge, Reitz, "Average irregularity representation of a rough surface for ray
/// reflection" (1975); Heitz, "Understanding the masking-shadowing function in microfacet-based
/// BRDFs", JCGT 3(2) (2014), whose numbers of equations stand below.
template <class Real>
struct Ggx {
  using V = Vec3<Real>;
  Real alpha_x, alpha_y;

  /// D: the density of normals by area and solid angle (85).
  Real density(const V& h) const {
    const Real x = h.x / alpha_x, y = h.y / alpha_y, sum = x * x + y * y + h.z * h.z;
    return Real(0.318309886F) / (alpha_x * alpha_y * sum * sum);
  }
  /// Lambda: how much of the surface hides facets from w, over what shows (86).
  Real lambda(const V& w) const {
    using std::sqrt;
    const Real x = alpha_x * w.x, y = alpha_y * w.y;
    return (sqrt(Real(1) + (x * x + y * y) / (w.z * w.z)) - Real(1)) * Real(0.5F);
  }
  /// The share of facets that w sees (43), and that both see, their heights correlated (99).
  Real visible(const V& w) const { return Real(1) / (Real(1) + lambda(w)); }
  Real visible(const V& wo, const V& wi) const {
    return Real(1) / (Real(1) + lambda(wo) + lambda(wi));
  }
  /// The density of sample(), by solid angle of the normals, over |wo.h|.
  Real visible_density(const V& wo, const V& h) const { return visible(wo) * density(h) / wo.z; }

  /// A normal of those that wo sees, for a point of the unit square.
  /// Source: Dupuy, Benyoub, "Sampling visible GGX normals with spherical caps" (2023), whose
  /// cap's point, by height and angle, is here the disc's point raised onto the sphere.
  V sample(const V& wo, const Real& u, const Real& v) const {
    return seen(wo, square_to_disc(u, v));
  }
  /// The same for a point of the unit disc.
  V seen(const V& wo, const DiscPoint<Real>& d) const {
    using std::sqrt;
    const V stretched = normalize(V{wo.x * alpha_x, wo.y * alpha_y, wo.z});
    const Real below = (d.x * d.x + d.y * d.y) * (Real(1) + stretched.z);  // of the pole
    const Real spread = sqrt((Real(1) + stretched.z) * max_of(Real(2) - below, Real(0)));
    const V cap{d.x * spread + stretched.x, d.y * spread + stretched.y,
                Real(1) - below + stretched.z};
    return normalize(V{cap.x * alpha_x, cap.y * alpha_y, max_of(cap.z, Real(1e-6F))});
  }
};

/// (1 - c)^5. Source: Schlick, "An inexpensive BRDF model for physically-based rendering" (1994).
template <class Real>
Real schlick_weight(const Real& c) {
  const Real away = max_of(Real(1) - c, Real(0)), square = away * away;
  return square * square * away;
}

/// Dielectric: what happens to light that meets a smooth boundary at the cosine c > 0, where eta is
/// the index of refraction behind the boundary over the one before it.
/// Source: Born, Wolf, "Principles of Optics", 1.5.2 (20) and (21), both polarisations averaged.
template <class Real>
struct Dielectric {
  Real reflected;  ///< the share of the light; 1 where all of it is
  Real cos_t;      ///< the cosine of the refracted direction
  Mask<Real> total;

  Dielectric(const Real& c, const Real& eta) {
    using std::sqrt;
    const Real square = Real(1) - (Real(1) - c * c) / (eta * eta);
    total = !(square > Real(0));
    cos_t = sqrt(max_of(square, Real(0)));
    const Real s = (c - eta * cos_t) / (c + eta * cos_t), p = (eta * c - cos_t) / (eta * c + cos_t);
    reflected = select(total, Real(1), (s * s + p * p) * Real(0.5F));
  }
};

/// The refracted direction at a facet of normal h, unit, on the side of wo. Domain: not total.
template <class Real>
Vec3<Real> refracted(const Vec3<Real>& wo, const Vec3<Real>& h, const Real& c, const Real& eta,
                     const Real& cos_t) {
  const Real inverse = Real(1) / eta;
  return h * (c * inverse - cos_t) - wo * inverse;
}

}  // namespace tia
