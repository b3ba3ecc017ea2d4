// Path tracing: light as it really goes, with all that surfaces send to each other.
#include <optional>

#include "core/integrators/integrator.h"
#include "core/integrators/light_sampling.h"
#include "core/integrators/scatterers.h"
#include "core/materials/spectrum.h"
#include "core/math/sobol.h"
#include "core/math/unit_lanes.h"
#include "core/scene/scene.h"

namespace tia {
namespace {

/// PathTracer: the light along camera rays, estimated by one path each: at every vertex one point
/// of one light is asked for, and one direction, drawn by the surface, goes on. What both can find,
/// the light of a luminous surface, is weighted by the power heuristic.
/// Source: Kajiya, "The rendering equation" (1986); Veach, "Robust Monte Carlo methods for light
/// transport simulation" (1997), ch. 8 to 10.
template <class Real>
class PathTracer {
  using V = Vec3<Real>;
  using Surface = SurfaceInteraction<SurfacePoint<Real>, Real>;

 public:
  PathTracer(WorldView& world_view, const SamplerState<Real>& sampler_state)
      : world_view_(world_view), sampler_state_(sampler_state), lights_(world_view.world) {}

  V trace(Ray<Real> ray, Mask<Real> active) {
    const int max_depth = std::min(world_view_.rules.max_depth, SceneOptions::deepest);
    for (int depth = 0; any(active); ++depth) {
      count_rays(depth, active);
      const Hit<Real> hit = world_view_.closest(ray, active);
      const Surface isect = surfaces(world_view_, ray, hit, active);
      beta_ = beta_ * transmittance_of(absorption_, hit.t);
      add_emitted(ray, hit, isect, active);
      active = isect.here;
      if (depth == max_depth || !any(active)) break;
      auto materials = scatterers(world_view_.world, hit, isect);
      if (any(disperses(materials, isect.here))) disperse(materials, isect.here);
      const auto behind = boundary(materials, isect, hit, last_);
      const Bsdf<Real> bsdf(materials.bsdf, -ray.direction, isect.at.n, isect.at.ng, behind.eta,
                            isect.here);
      const Numbers numbers = draw(depth);
      add_direct(isect, bsdf, behind, numbers);
      const BsdfSample<Real> next = bsdf.sample(numbers.lobe, numbers.u, numbers.v);
      active = next.here && survives(depth, bsdf, next, numbers);
      const Mask<Real> enters = next.transmitted && !materials.bsdf.thin;
      if (any(enters)) pass(hit, isect, materials, behind, enters, depth);
      pdf_ = next.pdf;
      from_ = isect.at.p;
      from_n_ = isect.at.ng;
      transmitted_ = next.transmitted;
      ray = off(isect, next.wi, next.transmitted);
    }
    return light_;
  }

 private:
  // What a matt surface sends on counts as reflected.
  void count_rays(int depth, Mask<Real> active) {
    const int refracted = depth == 0 ? 0 : count(active && transmitted_);
    world_view_.rays.count(RayKind::refraction, refracted);
    world_view_.rays.count(depth == 0 ? RayKind::primary : RayKind::reflection,
                           count(active) - refracted);
  }

  // ---- numbers at random ------------------------------------------------------------------------

  struct Numbers {
    Real light, light_u, light_v, lobe, u, v, roulette;
  };
  // Two blocks of four dimensions for each vertex.
  Numbers draw(int depth) const {
    constexpr std::uint32_t of_paths = 0x20000000;  // no other integrator's
    const std::uint32_t block = of_paths + 2 * static_cast<std::uint32_t>(depth);
    const auto words = [&](std::uint32_t of) {
      return sobol_words(sampler_state_.x, sampler_state_.y, sampler_state_.sample, of,
                         sampler_state_.key);
    };
    const auto first = words(block), second = words(block + 1);
    const auto units = [](const auto& each) { return unit_lanes<Real>(each); };
    return {units(first.c),  units(first.a),  units(first.b), units(first.d),
            units(second.a), units(second.b), units(second.c)};
  }

  // ---- wavelengths ------------------------------------------------------------------------------

  static Mask<Real> disperses(const Scatterers<Real>& materials, Mask<Real> here) {
    return here && !materials.bsdf.thin && materials.bsdf.glass > Real(0) &&
           materials.bsdf.dispersion > Real(0);
  }
  // A path that meets glass which parts colours is of a single wavelength from there on.
  void disperse(Scatterers<Real>& materials, Mask<Real> here) {
    constexpr std::uint32_t of_waves = 0x1FFFFFFF;
    const Mask<Real> parted = disperses(materials, here), fresh = parted && !(wave_ > Real(0));
    if (any(fresh)) {
      const auto words = sobol_words(sampler_state_.x, sampler_state_.y, sampler_state_.sample,
                                     of_waves, sampler_state_.key);
      const Real u = unit_lanes<Real>(words.a);
      wave_ = select(fresh, Real(shortest_wave) + u * Real(longest_wave - shortest_wave), wave_);
      beta_ = select(fresh, beta_ * wave_color(wave_), beta_);
    }
    auto& [bsdf, inside, object] = materials;
    inside.ior = select(parted, ior_at(bsdf.ior, bsdf.dispersion, wave_), inside.ior);
  }

  // ---- light ------------------------------------------------------------------------------------

  void add(Mask<Real> here, const V& radiance) {
    const V none{Real(0), Real(0), Real(0)};
    light_ = light_ + select(here, beta_ * radiance, none);
  }
  static Mask<Real> shines(const V& light) {
    return light.x > Real(0) || light.y > Real(0) || light.z > Real(0);
  }
  static Mask<Real> is_finite(const V& light) {
    return light.x < Real(infinity) && light.y < Real(infinity) && light.z < Real(infinity);
  }

  // What the ray finds: what is infinitely far, or what the surface sends out by itself.
  void add_emitted(const Ray<Real>& ray, const Hit<Real>& hit, const Surface& isect,
                   Mask<Real> active) {
    if (const Mask<Real> missed = active && !isect.here; any(missed)) {
      add(missed, lift<Real>(world_view_.world.background));
      lights_.beyond(ray.direction, missed,
                     [&](const V& radiance, const Real& pdf, Mask<Real> here) {
                       add(here, radiance * drawn_weight(here, [&](auto) { return pdf; }));
                     });
    }
    const Mask<Real> luminous = isect.here && shines(isect.emission);
    if (!any(luminous)) return;
    const Real weight = drawn_weight(luminous, [&](Mask<Real> rivals) {
      return lights_.pdf(from_, from_n_, hit, isect.at.p, rivals);
    });
    add(luminous, isect.emission * weight);
  }
  // The weight of light that the surface's direction has found, where add_direct() could have asked
  // for it with a density of other_pdf(mask).
  template <class F>
  Real drawn_weight(Mask<Real> here, F other_pdf) const {
    const Mask<Real> rivals = here && pdf_ > Real(0);
    if (!any(rivals)) return Real(1);
    const Real other = other_pdf(rivals) / pdf_;
    return select(rivals, Real(1) / (Real(1) + other * other), Real(1));
  }

  // What one point of one light gives the surface to scatter.
  void add_direct(const Surface& isect, const Bsdf<Real>& bsdf, const MediumBoundary<Real>& behind,
                  const Numbers& numbers) {
    const Mask<Real> here = bsdf.scatters();
    if (!any(here)) return;
    lights_.draw(isect.at.p, isect.at.ng, numbers.light, numbers.light_u, numbers.light_v, here,
                 [&](const LightDraw<Real>& draw, Mask<Real> those) {
                   add_light(draw, isect, bsdf, behind, those);
                 });
  }
  void add_light(const LightDraw<Real>& draw, const Surface& isect, const Bsdf<Real>& bsdf,
                 const MediumBoundary<Real>& behind, Mask<Real> here) {
    world_view_.work.test();
    const BsdfValue<Real> at = bsdf.value(draw.wi);
    const Mask<Real> below = dot(isect.at.ng, draw.wi) < Real(0);
    const V absorption = select(below, behind.absorption, absorption_);
    const V scattered = at.f_cos * draw.light * transmittance_of(absorption, draw.distance);
    const Mask<Real> lit = here && shines(scattered) && is_finite(scattered);
    if (!any(lit)) return;
    world_view_.rays.shadow += count(lit);
    const Mask<Real> dark = hidden(draw, isect, below, lit);
    Real weight = Real(1) / draw.pdf;
    if (!draw.is_delta) {
      const Real other = at.pdf / draw.pdf;
      weight = Real(1) / (draw.pdf * (Real(1) + other * other));
    }
    add(lit && !dark, scattered * weight);
  }
  // The ray starts off the surface and is aimed at the point of the light anew, for else it would
  // meet a near light beside that point, and before it. What is as near to the light as rays start
  // off surfaces is at it: the light itself, or a ceiling that it is part of.
  Mask<Real> hidden(const LightDraw<Real>& draw, const Surface& isect, Mask<Real> below,
                    Mask<Real> lit) {
    const Mask<Real> finite = draw.distance < Real(infinity);
    Ray<Real> ray = off(isect, draw.wi, below);
    const Real span = select(finite, draw.distance, Real(1));
    const V to = isect.at.p + draw.wi * span - ray.origin;
    const Real distance = length(to);
    ray.direction = select(finite, to * (Real(1) / distance), draw.wi);
    const Real reach = distance * Real(1 - 2 * tolerance::ray_offset) - isect.offset;
    return occluded(world_view_.world, ray, select(finite, reach, Real(infinity)), draw.own, lit,
                    world_view_.work);
  }

  // ---- the path goes on -------------------------------------------------------------------------

  // Multiplies the weight of the direction in. From the fifth vertex on paths end by chance, the
  // less they count the sooner. Returns: the lanes that go on.
  Mask<Real> survives(int depth, const Bsdf<Real>& bsdf, const BsdfSample<Real>& next,
                      const Numbers& numbers) {
    beta_ = beta_ * next.weight;
    denser_ = select(next.transmitted, denser_ * (bsdf.eta() * bsdf.eta()), denser_);
    if (depth + 1 < 5) return shines(beta_);
    const Real most = max_of(max_of(beta_.x, beta_.y), beta_.z) * denser_;
    const Real q = min_of(Real(0.95F), most);
    beta_ = beta_ * (Real(1) / q);
    return shines(beta_) && numbers.roulette < q;
  }
  void pass(const Hit<Real>& hit, const Surface& isect, const Scatterers<Real>& materials,
            const MediumBoundary<Real>& behind, Mask<Real> enters, int depth) {
    last_ = &passed_[static_cast<std::size_t>(depth)].emplace(MediumTransition<Real>{
        last_, enters, isect.at.front, materials.object, hit.instance, materials.inside});
    absorption_ = select(enters, behind.absorption, absorption_);
  }
  static Ray<Real> off(const Surface& isect, const V& wi, Mask<Real> below) {
    return {isect.at.p + isect.at.ng * select(below, -isect.offset, isect.offset), wi};
  }

  V light_{Real(0), Real(0), Real(0)}, beta_{Real(1), Real(1), Real(1)};
  V absorption_{Real(0), Real(0), Real(0)};  // of the medium, per scene unit
  Real wave_ = Real(0);                      // in nanometres; 0: white
  V from_{Real(0), Real(0), Real(0)}, from_n_{Real(0), Real(0), Real(0)};  // the last vertex
  Real pdf_ = Real(0);  // of the direction from there; 0: of the camera, of mirrors and of glass
  Mask<Real> transmitted_{};  // whether that direction went through the surface
  Real denser_ = Real(1);  // the square of the index of refraction, over that where the path began
  std::array<std::optional<MediumTransition<Real>>, SceneOptions::deepest> passed_{};
  const MediumTransition<Real>* last_ = nullptr;
  WorldView& world_view_;
  const SamplerState<Real>& sampler_state_;
  const LightSampling<Real> lights_;
};

}  // namespace

template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::path>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                      Mask<Real> active,
                                                      const SamplerState<Real>& sampler_state) {
  return PathTracer<Real>(world_view, sampler_state).trace(ray, active);
}
TIA_INTEGRATOR(path)

}  // namespace tia
