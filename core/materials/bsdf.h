// How a surface scatters light: the sum of its lobes, which are facets that reflect or let pass,
// the matt ground below them, a coat and a sheen above them.
#pragma once

#include "core/materials/bsdf_shares.h"
#include "core/materials/sheen.h"

namespace tia {

/// BsdfValue: what a direction's light gives the viewer, and how likely sample() draws it.
template <class Real>
struct BsdfValue {
  Vec3<Real> f_cos;    ///< f |n.wi|
  Real pdf = Real(0);  ///< by solid angle
};

/// BsdfSample: a direction from which light comes to the surface and goes on to the viewer.
/// Space/units: world space; wi points away from the surface.
template <class Real>
struct BsdfSample {
  Mask<Real> here;  ///< where there is one; elsewhere the surface absorbs
  Vec3<Real> wi;
  Vec3<Real> weight;         ///< f |n.wi| / pdf: what it counts
  Real pdf = Real(0);        ///< by solid angle; 0: of a smooth surface, which has one direction
  Mask<Real> transmitted{};  ///< where it lies behind the surface
};

/// Bsdf: the scattering of the surfaces that a packet has hit. Radiance is what it scatters: light
/// that passes into a medium of index eta is compressed by 1/eta^2. What facets lose by shadowing
/// each other is given back evenly (Kulla, Conty 2017), so that white bodies lose nothing, within
/// 1 %, and with grain within 3 %, of glass from inside 8 %; and but for coat and sheen, which
/// darken what lies below them by what the viewer sees of them, as in glTF 2.0, appendix B, it is
/// reciprocal.
template <class Real>
class Bsdf : BsdfShares<Real> {
  using Shares = BsdfShares<Real>;
  using typename Shares::Fresnel;
  using typename Shares::Here;
  using typename Shares::V;

 public:
  /// Domain: unit wo, towards the viewer; unit n and ng, the shading and the geometric normal, ng
  /// on the side of wo; eta: the index of refraction behind the surface over that before it.
  /// `frames`: how coat and grain lie; null: as the surface and the horizontal do.
  Bsdf(const BsdfParameters<Real>& parameters, const V& wo, const V& n, const V& ng,
       const Real& eta, Here here, const LayerFrames<Real>* frames = nullptr)
      : Shares(parameters, wo, n, ng, eta, here, frames) {}

  /// Where it scatters light into more than single directions.
  Here scatters() const;
  /// All lobes' value for light from wi, but for those that have a single direction.
  BsdfValue<Real> value(const V& wi) const;
  /// Where the matt ground scatters more of the light from wi than facets, coat and sheen together.
  Here is_matt(const V& wi) const;
  /// A direction, for a number that chooses the lobe and a point of the unit square.
  BsdfSample<Real> sample(const Real& lobe, const Real& u, const Real& v) const;
  /// The index of refraction behind the surface over that before it; a pane's is 1.
  const Real& eta() const { return eta_; }

 private:
  using Shares::again_;
  using Shares::albedo;
  using Shares::albedos_;
  using Shares::all_;
  using Shares::below_;
  using Shares::bends_;
  using Shares::bent_;
  using Shares::coat_;
  using Shares::coat_cover_;
  using Shares::coat_fresnel;
  using Shares::coat_n_;
  using Shares::coat_rough_;
  using Shares::coat_wo_;
  using Shares::cover_;
  using Shares::down_;
  using Shares::eta_;
  using Shares::facets_;
  using Shares::fresnel;
  using Shares::from_coat;
  using Shares::ground_;
  using Shares::has_facets_;
  using Shares::here_;
  using Shares::index_;
  using Shares::layer;
  using Shares::local;
  using Shares::matt_;
  using Shares::ng_;
  using Shares::p_;
  using Shares::passes_;
  using Shares::rough_;
  using Shares::sheen_;
  using Shares::to_coat;
  using Shares::up_;
  using Shares::wo_;
  using Shares::world;

  const Ggx<Real>& ggx() const { return albedos_.ggx; }
  Ggx<Real> coat_ggx() const { return {p_.coat_alpha, p_.coat_alpha}; }
  static V mirrored(const V& wo, const V& h);
  V scattered_evenly(const V& wi) const;
  void add_reflected(const V& wi, Here here, BsdfValue<Real>& sum) const;
  void add_passed(const V& wi, Here here, BsdfValue<Real>& sum) const;
  void add_bent_coat(const V& wi, Here lit, BsdfValue<Real>& sum) const;
  /// What sample() has drawn in the shading frame, and its weight where it is a single direction.
  struct Drawn {
    V w, weight;
    Here single{}, passing{};
  };
  void draw_coat(Here here, const Real& u, const Real& v, Drawn& drawn) const;
  void draw_facet(Here here, const Real& choice, const Real& u, const Real& v, Drawn& drawn) const;
};

}  // namespace tia
