#include "core/materials/grain_albedo.h"

namespace tia {
namespace {

// Facets at the points of a spiral of Vogel's over the unit disc, each after a golden angle.
// Source: Vogel, "A better way to construct the sunflower head", Mathematical Biosciences 44
// (1979).
constexpr int facets = 32;
constexpr double golden_cos = -0.7373688780783197, golden_sin = 0.6754902942615238;

// The mean of term(h, w.h), to which w and those that light meets next are less than grazing.
template <class Real, class F>
Real facets_mean(const Ggx<Real>& ggx, const Vec3<Real>& w, F term) {
  Real sum(0);
  double x = 1, y = 0;
  for (int i = 0; i < facets; ++i) {
    const double r = std::sqrt((i + 0.5) / facets);
    const Vec3<Real> h = ggx.seen(w, {lift<Real>(r * x), lift<Real>(r * y)});
    sum = sum + term(h, dot(w, h));
    const double turned = golden_cos * x - golden_sin * y;
    y = golden_sin * x + golden_cos * y, x = turned;
  }
  return sum * Real(1.0F / facets);
}
// In the first of the four quarters, which are alike, so that the same is found from either side of
// the surface.
template <class Real>
Vec3<Real> above(const Vec3<Real>& w) {
  return {abs_of(w.x), abs_of(w.y), max_of(w.z, Real(1e-3F))};
}
// G2 / G1 of light that goes on in that direction, 0 on the other side of the surface.
template <class Real>
Real seen_on(const Ggx<Real>& ggx, const Real& lambda, const Vec3<Real>& to, const Real& height) {
  const Real zero(0), one(1);
  const Vec3<Real> safe{to.x, to.y, max_of(height, Real(1e-6F))};
  return select(height > zero, (one + lambda) / (one + lambda + ggx.lambda(safe)), zero);
}

}  // namespace

template <class Real>
SchlickAlbedo<Real> grain_albedo(const Ggx<Real>& ggx, const Vec3<Real>& w) {
  const Vec3<Real> wo = above(w);
  const Real lambda = ggx.lambda(wo);
  Real b(0);
  const Real all = facets_mean(ggx, wo, [&](const Vec3<Real>& h, const Real& c) {
    const Vec3<Real> wi = h * (c + c) - wo;
    const Real share = seen_on(ggx, lambda, wi, wi.z);
    b = b + share * schlick_weight(c);
    return share;
  });
  b = b * Real(1.0F / facets);
  return {all - b, b};
}

template <class Real>
Real grain_glass_albedo(const Ggx<Real>& ggx, const Vec3<Real>& w, const Real& eta) {
  const Vec3<Real> wo = above(w);
  const Real lambda = ggx.lambda(wo), zero(0), one(1);
  return facets_mean(ggx, wo, [&](const Vec3<Real>& h, const Real& c) {
    const Dielectric<Real> at(c, eta);
    const Vec3<Real> wi = h * (c + c) - wo, wt = refracted(wo, h, c, eta, at.cos_t);
    const Real passed = (one - at.reflected) * seen_on(ggx, lambda, wt, -wt.z);
    return at.reflected * seen_on(ggx, lambda, wi, wi.z) + select(at.total, zero, passed);
  });
}

#define TIA_GRAIN_ALBEDO(Real)                                                    \
  template SchlickAlbedo<Real> grain_albedo(const Ggx<Real>&, const Vec3<Real>&); \
  template Real grain_glass_albedo(const Ggx<Real>&, const Vec3<Real>&, const Real&);
TIA_GRAIN_ALBEDO(Wide)
TIA_GRAIN_ALBEDO(float)
TIA_GRAIN_ALBEDO(double)

}  // namespace tia
