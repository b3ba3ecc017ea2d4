// A finish as a physical material: what it scatters of the light that comes from one direction into
// another one, and directions drawn by that.
#pragma once

#include "core/integrators/finishes.h"
#include "core/math/warp.h"

namespace tia {

/// BsdfSample: a direction from which light comes to the surface and goes on to the viewer.
/// Space/units: world space; wi points away from the surface.
template <class Real>
struct BsdfSample {
  Mask<Real> here;  ///< where there is one; elsewhere the surface absorbs
  Vec3<Real> wi;
  Vec3<Real> weight;   ///< f |n.wi| / pdf: what it counts
  Real pdf = Real(0);  ///< by solid angle; 0: of a mirror or glass, which have one direction each
  Mask<Real> transmitted{};  ///< where it lies behind the surface
};

/// FinishBsdf: a Lambertian, a mirror and a smooth dielectric, whose shares add up to 1 at most:
/// the Lambertian's albedo is color * diffuse * (1 - transmission - reflection), the mirror's
/// share is `reflection`, the dielectric's `transmission`, which Fresnel's equations divide where
/// the finish says `fresnel`. Ambient light, brilliance and highlights are not physical.
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., ch. 9.
template <class Real>
class FinishBsdf {
  using V = Vec3<Real>;

 public:
  /// Domain: the surface that the ray's lanes `isect.here` have hit; the transitions as in
  /// split_specular().
  FinishBsdf(const V& direction, const Hit<Real>& hit,
             const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
             const Finishes<Real>& finish, const MediumTransition<Real>* transitions)
      : here_(isect.here), direction_(direction), ng_(isect.at.ng) {
    // An interpolated normal may face away from the viewer.
    n_ = select(dot(isect.at.n, direction) < Real(0), isect.at.n, ng_);
    const Real zero(0), one(1);
    split_ =
        split_specular(direction, n_, hit.instance, here_, isect.at.front, finish, transitions);
    const Real most = max_of(one, finish.transmission + finish.reflection);
    mirrored_ = (split_.reflection + finish.transmission * finish.reflection) / most;
    refracted_ = split_.refraction / most;
    const Real kept = max_of(zero, one - finish.transmission - finish.reflection);
    const auto albedo = [&](const Real& own) { return min_of(own, one) * kept; };
    albedo_ = {albedo(isect.albedo.x), albedo(isect.albedo.y), albedo(isect.albedo.z)};
    scattered_ = max_of(max_of(albedo_.x, albedo_.y), albedo_.z);
    sum_ = scattered_ + mirrored_ + refracted_;
  }

  /// Where it scatters light into more than single directions.
  Mask<Real> scatters() const { return here_ && scattered_ > Real(0); }
  /// f |n.wi|, without mirror and glass.
  V eval(const V& wi) const { return albedo_ * (cosine(wi) * Real(inverse_pi)); }
  /// The density of sample() by solid angle, of directions that are neither mirror's nor glass's.
  Real pdf(const V& wi) const {
    return select(scatters(), cosine(wi) * Real(inverse_pi) * scattered_ / sum_, Real(0));
  }
  /// One of the three, by its share, for a number and a point of the unit square.
  BsdfSample<Real> sample(const Real& lobe, const Real& u, const Real& v) const {
    const Real zero(0), x = lobe * sum_;
    const Mask<Real> glass = here_ && refracted_ > zero && !(x < scattered_ + mirrored_);
    const Mask<Real> mirror = here_ && !glass && mirrored_ > zero && !(x < scattered_);
    const Mask<Real> matt = scatters() && !glass && !mirror;
    BsdfSample<Real> one{glass || mirror || matt, reflect(direction_, n_), {sum_, sum_, sum_}};
    if (any(matt)) {
      one.wi = select(matt, square_to_cosine_hemisphere(n_, u, v), one.wi);
      one.weight = select(matt, albedo_ * (sum_ / scattered_), one.weight);
      one.pdf = select(matt, pdf(one.wi), zero);
    }
    if (any(glass)) {
      // Radiance is compressed into the narrower cone of the denser medium.
      const Real weight = sum_ * (split_.eta * split_.eta);
      one.wi = select(glass, split_.refracted.wt, one.wi);
      one.weight = select(glass, {weight, weight, weight}, one.weight);
    }
    one.transmitted = glass;
    // No light passes an opaque surface whose interpolated normal leans over too far.
    one.here = one.here && (glass || dot(ng_, one.wi) > zero);
    return one;
  }
  /// The medium behind it, and the index of refraction before it over that of the medium.
  const Medium<Real>& medium_t() const { return split_.medium_t; }
  const Real& eta() const { return split_.eta; }

 private:
  static constexpr float inverse_pi = 0.318309886F;
  Real cosine(const V& wi) const {
    const Real c = dot(n_, wi);
    return select(here_ && c > Real(0) && dot(ng_, wi) > Real(0), c, Real(0));
  }

  Mask<Real> here_;
  V direction_, n_, ng_, albedo_;
  SpecularSplit<Real> split_;
  Real scattered_, mirrored_, refracted_, sum_;
};

}  // namespace tia
