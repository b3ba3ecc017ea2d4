#include "core/materials/bsdf.h"

namespace tia {

using detail::grey;
using detail::over;

namespace {

constexpr float inverse_pi = 0.318309886F;
constexpr float uniform_pdf = 0.159154943F;  // of a hemisphere

template <class Real>
Vec3<Real> up() {
  return {Real(0), Real(0), Real(1)};
}

}  // namespace

// ---- light from wi
// -------------------------------------------------------------------------------

template <class Real>
typename Bsdf<Real>::Here Bsdf<Real>::scatters() const {
  const Real zero(0);
  return here_ && (matt_ + sheen_ + below_ > zero || (facets_ > zero && rough_) ||
                   (coat_ > zero && coat_rough_));
}

template <class Real>
BsdfValue<Real> Bsdf<Real>::value(const V& wi) const {
  const V w = local(wi);
  const Real side = dot(ng_, wi), zero(0);
  const Here above = here_ && w.z > zero && side > zero;
  const Here below = passes_ && w.z < zero && side < zero;
  BsdfValue<Real> sum{grey(zero), zero};
  if (any(above)) add_reflected(w, above, sum);
  if (any(below)) add_passed(w, below, sum);
  if (bends_) add_bent_coat(to_coat(w), here_ && side > zero, sum);
  sum.pdf = over(sum.pdf, all_);
  return sum;
}

// What the ground, and facets again and again, reflect of light from there, in the shading frame.
template <class Real>
[[gnu::always_inline]] inline typename Bsdf<Real>::V Bsdf<Real>::scattered_evenly(
    const V& wi) const {
  const Real zero(0), one(1), even = wi.z * Real(inverse_pi);
  V f = ground_;
  if (has_facets_) {
    const SchlickAlbedo<Real> at = albedo(wi);
    const Real lost = one - at.a - at.b;
    f = f * (grey(one) - layer(at)) + again_ * lost;
    if (const Here glass = passes_ && rough_; any(glass)) {
      const Real own = select(p_.thin, lost, one - albedos_.of_glass(wi, index_));
      f = f + grey(select(glass, up_ * own, zero));
    }
  }
  return f * (even * cover_);
}

template <class Real>
typename Bsdf<Real>::Here Bsdf<Real>::is_matt(const V& wi) const {
  const V w = local(wi), all = value(wi).f_cos, matt = scattered_evenly(w);
  return here_ && w.z > Real(0) && Real(2) * (matt.x + matt.y + matt.z) >= all.x + all.y + all.z;
}

template <class Real>
void Bsdf<Real>::add_reflected(const V& wi, Here here, BsdfValue<Real>& sum) const {
  const Real zero(0), mu = wi.z, even = mu * Real(inverse_pi);
  V f = scattered_evenly(wi);
  Real pdf = matt_ * even;
  Here coat = coat_rough_ && coat_ > zero;
  if (bends_) coat = coat && !bent_;
  V h{};
  Real c{};
  if (any(rough_ || coat)) {
    h = normalize(wo_ + wi);
    c = dot(wo_, h);
  }
  if (any(rough_)) {
    const Fresnel at_h = fresnel(c);
    const Real density = ggx().density(h) / (Real(4) * wo_.z);
    const V facets = at_h.reflected * (cover_ * density * ggx().visible(wo_, wi));
    f = f + select(rough_, facets, grey(zero));
    const Real drawn = facets_ * density * ggx().visible(wo_) * at_h.reflected_share();
    pdf = pdf + select(rough_, drawn, zero);
  }
  if (any(coat)) {
    const Real density = coat_ggx().density(h) / (Real(4) * wo_.z);
    f = f + grey(select(coat, coat_fresnel(c) * density * coat_ggx().visible(wo_, wi), zero));
    pdf = pdf + select(coat, coat_ * density * coat_ggx().visible(wo_), zero);
  }
  if (const Here cloth = sheen_ > zero; any(cloth)) {
    f = f + p_.sheen * select(cloth, sheen_cos(wo_, wi, p_.sheen_alpha) * coat_cover_, zero);
    pdf = pdf + sheen_ * Real(uniform_pdf);
  }
  sum.f_cos = select(here, f, sum.f_cos);
  sum.pdf = select(here, pdf, sum.pdf);
}

// For wi in the coat's frame: what it shows may lie below the horizon of the normal under it.
template <class Real>
void Bsdf<Real>::add_bent_coat(const V& wi, Here lit, BsdfValue<Real>& sum) const {
  const Real zero(0);
  const Here coat = lit && bent_ && coat_rough_ && coat_ > zero && wi.z > zero;
  if (!any(coat)) return;
  const V h = normalize(coat_wo_ + wi);
  const Real c = dot(coat_wo_, h), density = coat_ggx().density(h) / (Real(4) * coat_wo_.z);
  const Real f = coat_fresnel(c) * density * coat_ggx().visible(coat_wo_, wi);
  sum.f_cos = sum.f_cos + grey(select(coat, f, zero));
  sum.pdf = sum.pdf + select(coat, coat_ * density * coat_ggx().visible(coat_wo_), zero);
}

template <class Real>
void Bsdf<Real>::add_passed(const V& wi, Here here, BsdfValue<Real>& sum) const {
  const Here rough = here && rough_;
  if (!any(rough)) return;
  const Real zero(0), one(1), even = -wi.z * Real(inverse_pi), inverse = one / eta_;
  const V over_pane{wi.x, wi.y, -wi.z};
  // Half between the two sides, by their indices, as Snell's law has it.
  V h = normalize(select(p_.thin, wo_ + over_pane, wo_ + wi * eta_));
  h = select(h.z < zero, -h, h);
  const Real c = dot(wo_, h), c_t = dot(wi, h), parted = c_t + c * inverse;
  const Fresnel at_h = fresnel(c);
  const Real jacobian =
      select(p_.thin, Real(0.25F) / max_of(c, Real(1e-6F)), -c_t / (parted * parted));
  const Real density = ggx().density(h) * c / wo_.z * jacobian;
  const Here meets = rough && c > zero && (p_.thin || c_t < zero);
  const SchlickAlbedo<Real> of_pane = albedo(over_pane);
  const Real at_i = select(p_.thin, one - of_pane.a - of_pane.b,
                           one - albedos_.of_glass(over_pane, one / index_));
  const V evenly = down_ * (at_i * even);
  const V facets = at_h.passed * (density * ggx().visible(wo_, wi));
  const V f = (evenly + select(meets, facets, grey(zero))) * (cover_ * inverse * inverse);
  const Real drawn = facets_ * density * ggx().visible(wo_) * (one - at_h.reflected_share());
  sum.f_cos = select(rough, f, sum.f_cos);
  sum.pdf = select(rough, below_ * even + select(meets, drawn, zero), sum.pdf);
}

// ---- a direction drawn
// ----------------------------------------------------------------------------

template <class Real>
typename Bsdf<Real>::V Bsdf<Real>::mirrored(const V& wo, const V& h) {
  const Real c = dot(wo, h);
  return h * (c + c) - wo;
}

template <class Real>
void Bsdf<Real>::draw_coat(Here here, const Real& u, const Real& v, Drawn& drawn) const {
  const V h = any(here && coat_rough_)
                  ? select(coat_rough_, coat_ggx().sample(coat_wo_, u, v), up<Real>())
                  : up<Real>();
  const V w = mirrored(coat_wo_, h);
  drawn.w = select(here, bends_ ? select(bent_, from_coat(w), w) : w, drawn.w);
  drawn.weight = select(here, grey(coat_fresnel(coat_wo_.z) * over(all_, coat_)), drawn.weight);
  drawn.single = drawn.single || (here && !coat_rough_);
}

template <class Real>
void Bsdf<Real>::draw_facet(Here here, const Real& choice, const Real& u, const Real& v,
                            Drawn& drawn) const {
  const V h =
      any(here && rough_) ? select(rough_, ggx().sample(wo_, u, v), up<Real>()) : up<Real>();
  const Real c = dot(wo_, h), inverse = Real(1) / eta_;
  const Fresnel at_h = fresnel(c);
  const Real reflected = at_h.reflected_share(), chance = over(all_, facets_) * cover_;
  const V w = mirrored(wo_, h);
  const Here passing = here && !(choice < reflected);
  drawn.w = select(here, w, drawn.w);
  drawn.weight = select(here, at_h.reflected * over(chance, reflected), drawn.weight);
  drawn.single = drawn.single || (here && !rough_);
  drawn.passing = drawn.passing || passing;
  if (!any(passing)) return;
  const V pane{w.x, w.y, -w.z};
  const V refracted_w = refracted(wo_, h, c, eta_, at_h.cos_t);
  drawn.w = select(passing, select(p_.thin, pane, refracted_w), drawn.w);
  const Real passed = over(chance, Real(1) - reflected) * inverse * inverse;
  drawn.weight = select(passing, at_h.passed * passed, drawn.weight);
}

template <class Real>
BsdfSample<Real> Bsdf<Real>::sample(const Real& lobe, const Real& u, const Real& v) const {
  const Real zero(0), x = lobe * all_;
  const Here some = here_ && all_ > zero, coat = some && x < coat_;
  const Here facet = some && !coat && x < coat_ + facets_;
  const Here below = some && !coat && !facet && x < coat_ + facets_ + below_;
  const Here sheen = some && !coat && !facet && !below && x < coat_ + facets_ + below_ + sheen_;
  Drawn drawn{up<Real>(), grey(zero)};
  drawn.passing = below;
  if (const Here even = some && !coat && !facet; any(even)) {
    const V w = square_to_cosine_hemisphere(up<Real>(), u, v);
    drawn.w = select(below, {w.x, w.y, -w.z}, w);
  }
  if (any(sheen)) drawn.w = select(sheen, square_to_uniform_hemisphere(u, v), drawn.w);
  if (any(coat)) draw_coat(coat, u, v, drawn);
  if (any(facet)) draw_facet(facet, over(x - coat_, facets_), u, v, drawn);

  BsdfSample<Real> one{some, normalize(world(drawn.w)), drawn.weight};
  one.transmitted = drawn.passing;
  // No light passes an opaque surface whose interpolated normal leans over too far.
  const Real side = dot(ng_, one.wi);
  const Real height = bends_ ? select(coat && bent_, dot(coat_n_, drawn.w), drawn.w.z) : drawn.w.z;
  one.here = some && ((drawn.passing && side < zero && height < zero) ||
                      (!drawn.passing && side > zero && height > zero));
  const Here spread = one.here && !drawn.single;
  if (!any(spread)) return one;
  const BsdfValue<Real> whole = value(one.wi);
  const Here found = spread && whole.pdf > zero;
  one.pdf = select(found, whole.pdf, zero);
  one.weight =
      select(spread, whole.f_cos * (Real(1) / select(found, whole.pdf, Real(1))), one.weight);
  one.here = one.here && (found || drawn.single);
  return one;
}

template class Bsdf<Wide>;
template class Bsdf<float>;
template class Bsdf<double>;

}  // namespace tia
