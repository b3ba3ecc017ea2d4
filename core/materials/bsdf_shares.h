// What a surface sends on of the light that comes towards the viewer, lobe by lobe.
#pragma once

#include "core/materials/albedo_tables.h"
#include "core/materials/bsdf_parameters.h"
#include "core/materials/facet_albedo.h"
#include "core/materials/layer_frames.h"

namespace tia {

namespace detail {

template <class Real>
Vec3<Real> grey(const Real& x) {
  return {x, x, x};
}
/// The quotient, finite also where both are 0.
template <class Real>
Real over(const Real& a, const Real& b) {
  return a / max_of(b, Real(1e-30F));
}

}  // namespace detail

/// BsdfShares: all of a Bsdf that depends on the viewer's direction and not on the light's: the
/// shading frame, the shares of the lobes, and what facets lose by shadowing each other.
template <class Real>
class BsdfShares {
 protected:
  using V = Vec3<Real>;
  using Here = Mask<Real>;

  /// Fresnel: what facets reflect and let pass.
  struct Fresnel {
    V reflected, passed;
    Real cos_t;  // of what passes
    Real reflected_share() const;
  };

  BsdfShares(const BsdfParameters<Real>& parameters, const V& wo, const V& n, const V& ng,
             const Real& eta, Here here, const LayerFrames<Real>* frames);
  V local(const V& w) const { return {dot(x_, w), dot(y_, w), dot(n_, w)}; }
  V world(const V& w) const { return x_ * w.x + y_ * w.y + n_ * w.z; }
  /// The same from the shading frame to the coat's and back, in the lanes of bent_.
  V to_coat(const V& w) const { return {dot(coat_x_, w), dot(coat_y_, w), dot(coat_n_, w)}; }
  V from_coat(const V& w) const { return coat_x_ * w.x + coat_y_ * w.y + coat_n_ * w.z; }
  SchlickAlbedo<Real> albedo(const V& w) const;
  V layer(const SchlickAlbedo<Real>& at) const;
  Real coat_fresnel(const Real& c) const;
  Fresnel fresnel(const Real& c) const;

  BsdfParameters<Real> p_;
  Here here_, rough_{}, coat_rough_{}, passes_{};
  V n_{}, ng_, x_{}, y_{}, wo_{};
  // Where the coat has a normal of its own: its frame in the shading frame, and wo in it. Elsewhere
  // coat_wo_ is wo_, and without any such lane nothing else is set.
  bool bends_ = false;
  Here bent_{};
  V coat_n_{}, coat_x_{}, coat_y_{}, coat_wo_{};
  Real eta_;    // of what passes
  Real index_;  // in Fresnel's equations, which a pane has too
  FacetAlbedo<Real> albedos_{};
  bool has_facets_ = false;  // whether any lane has some
  SchlickAlbedo<Real> at_o_{};
  Real mean_ = Real(1);  // the share that white facets reflect, by the cosine
  // What is scattered evenly, but for the factor of wi: by the ground, by the facets that reflect
  // again, by glass, and by glass to the other side.
  V again_layer_{}, ground_{}, again_{}, down_{};
  Real up_ = Real(0);
  Real cover_ = Real(1), coat_cover_ = Real(1);  // what coat and sheen, and the coat, leave
  Real matt_{}, below_{}, facets_{}, coat_{}, sheen_{}, all_{};  // how likely sample() chooses each

 private:
  void set_frame(const LayerFrames<Real>* frames);
  void set_coat_frame(const LayerFrames<Real>& frames, const V& wo);
  void set_facets(const Real& eta);
  void set_cover();
  void set_ground();
  void set_glass();
  V again(const V& each) const;
};

}  // namespace tia
