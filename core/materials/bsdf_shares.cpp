#include "core/materials/bsdf_shares.h"

#include "core/materials/mean_fresnel.h"
#include "core/materials/sheen.h"

#include <tuple>

namespace tia {

using detail::grey;
using detail::over;

namespace {

template <class Real>
Real max3(const Vec3<Real>& v) {
  return max_of(max_of(v.x, v.y), v.z);
}
template <class Real>
Vec3<Real> quotient(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x / b.x, a.y / b.y, a.z / b.z};
}
// What v leaves of 1; never nothing, for it divides.
template <class Real>
Real left_of(const Real& x) {
  return max_of(Real(1) - x, Real(1e-4F));
}
template <class Real>
Vec3<Real> left_of(const Vec3<Real>& v) {
  return {left_of(v.x), left_of(v.y), left_of(v.z)};
}

}  // namespace

template <class Real>
BsdfShares<Real>::BsdfShares(const BsdfParameters<Real>& parameters, const V& wo, const V& n,
                             const V& ng, const Real& eta, Here here,
                             const LayerFrames<Real>* frames)
    : p_(parameters), here_(here), ng_(ng), eta_(eta), index_(eta) {
  passes_ = here_ && p_.glass > Real(0);
  // An interpolated normal may face away from the viewer.
  n_ = select(dot(n, wo) > Real(0), n, ng);
  set_frame(frames);
  wo_ = local(wo);
  wo_.z = max_of(wo_.z, Real(1e-4F));
  coat_wo_ = wo_;
  if (frames != nullptr) set_coat_frame(*frames, wo);
  set_facets(eta);
  set_cover();
  set_ground();
  if (any(passes_)) set_glass();
  all_ = coat_ + facets_ + below_ + sheen_ + matt_;
}

// Facets are stretched along the horizontal, as a turned body's grooves are, or as maps tell.
template <class Real>
void BsdfShares<Real>::set_frame(const LayerFrames<Real>* frames) {
  std::tie(x_, y_) = axes_around(n_);
  const Here grained = here_ && !(p_.alpha_x == p_.alpha_y);
  if (!any(grained)) return;
  const Here leans = grained && n_.x * n_.x + n_.z * n_.z > Real(1e-8F);
  const V across = normalize(select(leans, V{n_.z, Real(0), -n_.x}, x_));
  V along = across * p_.grain_cos + cross(n_, across) * p_.grain_sin;
  if (frames != nullptr) {
    const V told = frames->grain - n_ * dot(n_, frames->grain);
    const Here flat = frames->grained && dot(told, told) > Real(1e-8F);
    along = select(flat, normalize(select(flat, told, along)), along);
  }
  x_ = select(grained, along, x_);
  y_ = select(grained, cross(n_, along), y_);
}

// Like the surface's, the coat's normal may face away from the viewer; then it is the surface's.
template <class Real>
void BsdfShares<Real>::set_coat_frame(const LayerFrames<Real>& frames, const V& wo) {
  bent_ = here_ && frames.coated && p_.coat > Real(0) && dot(frames.coat_n, wo) > Real(0);
  bends_ = any(bent_);
  if (!bends_) return;
  coat_n_ = select(bent_, normalize(local(frames.coat_n)), V{Real(0), Real(0), Real(1)});
  std::tie(coat_x_, coat_y_) = axes_around(coat_n_);
  V own = to_coat(local(wo));
  own.z = max_of(own.z, Real(1e-4F));
  coat_wo_ = select(bent_, own, wo_);
}

template <class Real>
void BsdfShares<Real>::set_facets(const Real& eta) {
  using std::sqrt;
  const Real alpha = sqrt(p_.alpha_x * p_.alpha_y), one(1);
  // Between equal indices light goes straight on, however rough the boundary. Where the surface is
  // a metal or matt too, glass has facets all the same, and they need a half way to tell them by.
  const Here equal = !p_.thin && abs_of(eta - one) < Real(1e-3F);
  const Here unseen = equal && p_.glass > Real(0) && !(p_.matt + p_.metal + p_.mirror > Real(0));
  rough_ = here_ && !unseen && !(alpha < Real(smooth_alpha));
  coat_rough_ = here_ && !(p_.coat_alpha < Real(smooth_alpha));
  p_.alpha_x = select(rough_, p_.alpha_x, one);
  p_.alpha_y = select(rough_, p_.alpha_y, one);
  p_.coat_alpha = select(coat_rough_, p_.coat_alpha, one);
  const Here grained = rough_ && !(p_.alpha_x == p_.alpha_y);
  const Here mirrors = p_.thin || p_.matt + p_.metal + p_.mirror > Real(0);
  albedos_ = {
      {p_.alpha_x, p_.alpha_y}, sqrt(alpha), grained && mirrors, grained && passes_ && !p_.thin};
  eta_ = select(p_.thin, one, select(equal && rough_, Real(1.001F), eta));
  index_ = select(p_.thin, max_of(eta, one / eta), eta_);
  // The shares of a finish may add up to more than 1.
  p_.base = {min_of(p_.base.x, one), min_of(p_.base.y, one), min_of(p_.base.z, one)};
  const Real sum = max3(p_.base) * p_.matt + p_.metal + p_.mirror + p_.glass +
                   select(p_.covers, Real(0), p_.coat);
  const Real scale = one / max_of(sum, one);
  for (Real* share : {&p_.matt, &p_.metal, &p_.mirror, &p_.glass}) *share = *share * scale;
  p_.coat = select(p_.covers, p_.coat, p_.coat * scale);
}

template <class Real>
void BsdfShares<Real>::set_cover() {
  using std::sqrt;
  const Real zero(0), one(1);
  cover_ = coat_cover_ = one;
  coat_ = sheen_ = zero;
  if (any(here_ && p_.coat > zero)) {
    const Real w = schlick_weight(coat_wo_.z);
    SchlickAlbedo<Real> at{one - w, w};
    if (any(coat_rough_)) {
      const SchlickAlbedo<Real> table = schlick_albedo(coat_wo_.z, sqrt(p_.coat_alpha));
      at = {select(coat_rough_, table.a, at.a), select(coat_rough_, table.b, at.b)};
    }
    coat_ = p_.coat * (p_.coat_f0 * at.a + p_.coat_f90 * at.b);
    coat_cover_ = select(p_.covers, one - coat_, one);
  }
  cover_ = coat_cover_;
  const Real sheen = max3(p_.sheen);
  if (!any(here_ && sheen > zero)) return;
  // At the rims the fibres of that model would send on more than they get.
  const Real albedo = sheen_albedo(wo_.z, sqrt(p_.sheen_alpha));
  p_.sheen = p_.sheen * (one / max_of(albedo, one));
  const Real shown = sheen * min_of(albedo, one);
  sheen_ = shown * coat_cover_;
  cover_ = cover_ * (one - shown);
}

template <class Real>
void BsdfShares<Real>::set_ground() {
  const Real one(1), zero(0);
  below_ = up_ = facets_ = zero;
  down_ = again_ = again_layer_ = grey(zero);
  ground_ = p_.base * p_.matt;
  matt_ = cover_ * max3(ground_);
  has_facets_ = any(here_ && p_.metal + p_.mirror + p_.glass + p_.f90 > zero);
  if (!has_facets_) return;
  at_o_ = albedo(wo_);
  SchlickAlbedo<Real> mean{Real(20.0F / 21), Real(1.0F / 21)};
  if (any(rough_)) {
    const SchlickAlbedo<Real> table = albedos_.mean();
    mean = {select(rough_, table.a, mean.a), select(rough_, table.b, mean.b)};
  }
  mean_ = mean.a + mean.b;
  const Real lost = one - at_o_.a - at_o_.b;
  again_layer_ = again(mean_fresnel(p_.f0, p_.f90));
  const V all_again =
      again(mean_fresnel(p_.base, one)) * p_.metal + grey(p_.mirror) + again_layer_ * p_.matt;
  again_ = all_again * (lost / left_of(mean_));
  const V shown = ground_ * (grey(one) - layer(at_o_));
  ground_ = quotient(shown, left_of(layer(mean)));
  matt_ = cover_ * (max3(shown) + max3(all_again) * max_of(lost, zero));
  const V facets = (p_.base * at_o_.a + grey(at_o_.b)) * p_.metal +
                   grey(p_.mirror * (at_o_.a + at_o_.b)) +
                   (p_.f0 * at_o_.a + grey(p_.f90 * at_o_.b)) * p_.matt;
  facets_ = cover_ * max3(facets);
}

// What rough glass loses between its facets goes to either side by shares for which its scattering
// is reciprocal: that of what passes has the factor 1 - Fresnel's mean, whose quotient for the two
// sides is eta squared. Source: Kulla, Conty (2017).
template <class Real>
void BsdfShares<Real>::set_glass() {
  const Real zero(0), one(1);
  const Here rough = passes_ && rough_;
  Real kept = one;
  if (any(rough)) {
    const Here pane = p_.thin;
    const Real own = select(pane, at_o_.a + at_o_.b, albedos_.of_glass(wo_, index_));
    const Real lost = select(rough, max_of(one - own, zero), zero);
    const Real before = left_of(select(pane, mean_, albedos_.mean_of_glass(index_)));
    const Real behind = left_of(select(pane, mean_, albedos_.mean_of_glass(one / index_)));
    const Real fresnel = mean_dielectric(index_);
    const Real through = one - select(pane, of_pane(fresnel), fresnel);
    const Real most = max_of(before, behind), passed = through * behind / most;
    up_ = p_.glass * (one - passed) * lost / before;
    down_ = p_.tint * (p_.glass * through / most * lost);
    kept = one - lost;
    matt_ = matt_ + cover_ * p_.glass * (one - passed) * lost;
    below_ = select(rough, cover_ * p_.glass * max3(p_.tint) * passed * lost, zero);
  }
  const Fresnel at = fresnel(wo_.z);
  const Real smooth = max3(at.reflected) + max3(at.passed);
  facets_ =
      select(passes_, select(rough, facets_ + cover_ * p_.glass * kept, cover_ * smooth), facets_);
}

// Of Schlick's two parts, what facets send on; a smooth surface's in closed form.
template <class Real>
SchlickAlbedo<Real> BsdfShares<Real>::albedo(const V& w) const {
  const Real grazing = schlick_weight(w.z);
  if (!any(rough_)) return {Real(1) - grazing, grazing};
  const SchlickAlbedo<Real> at = albedos_.along(w);
  return {select(rough_, at.a, Real(1) - grazing), select(rough_, at.b, grazing)};
}
// What the layer over the matt ground reflects.
template <class Real>
Vec3<Real> BsdfShares<Real>::layer(const SchlickAlbedo<Real>& at) const {
  return p_.f0 * at.a + grey(p_.f90 * at.b) + again_layer_ * (Real(1) - at.a - at.b);
}
// Of what white facets lose, the share that is reflected in the end where they reflect `each` of
// the light every time. Source: Kulla, Conty (2017).
template <class Real>
Vec3<Real> BsdfShares<Real>::again(const V& each) const {
  return quotient(each * each * mean_, left_of(each * (Real(1) - mean_)));
}
template <class Real>
Real BsdfShares<Real>::coat_fresnel(const Real& c) const {
  return p_.coat * (p_.coat_f0 + (p_.coat_f90 - p_.coat_f0) * schlick_weight(c));
}

template <class Real>
Real BsdfShares<Real>::Fresnel::reflected_share() const {
  const Real r = max3(reflected);
  return over(r, r + max3(passed));
}
template <class Real>
typename BsdfShares<Real>::Fresnel BsdfShares<Real>::fresnel(const Real& c) const {
  const Real w = schlick_weight(c), one(1), zero(0);
  const V sum = (p_.base * (one - w) + grey(w)) * p_.metal + grey(p_.mirror) +
                (p_.f0 * (one - w) + grey(p_.f90 * w)) * p_.matt;
  if (!any(passes_)) return {sum, grey(zero), one};
  const Dielectric<Real> at(c, index_);
  const Real whole = select(p_.fresnel, at.reflected, select(at.total, one, zero));
  const Real share = select(p_.thin, of_pane(whole), whole);
  const Real glass = select(passes_, p_.glass, zero);
  return {sum + grey(glass * share), p_.tint * (glass * (one - share)), at.cos_t};
}

template class BsdfShares<Wide>;
template class BsdfShares<float>;
template class BsdfShares<double>;

}  // namespace tia
