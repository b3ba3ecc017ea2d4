// Direct light: what comes to a point straight from a light.
#pragma once

#include "core/integrators/optics.h"
#include "core/integrators/world_view.h"
#include "core/math/powers.h"
#include "core/math/sobol.h"
#include "core/math/unit_lanes.h"

namespace tia {

/// Phong: the parameters of the diffuse and the specular term. `exponent` is 1 / roughness.
template <class Real>
struct Phong {
  Real brilliance = Real(1), specular = Real(0), exponent = Real(20);
};

/// DirectLighting: the shares of a light's colour that a point scatters to the viewer, for one
/// light sample or averaged over several. The surface's colour is not in them.
template <class Real>
struct DirectLighting {
  Real diffuse = Real(0);   ///< (n.l)^brilliance, times visibility and strength
  Real specular = Real(0);  ///< specular * (r.l)^exponent, times the same
  Real visible =
      Real(0);  ///< the share of the samples that the point sees; those below its horizon are not
};

/// LightContribution: the direct lighting by all samples of a light, faded.
template <class Real>
struct LightContribution : DirectLighting<Real> {
  LightSample<Real> middle;  ///< the sample at the light's middle
  Real fade = Real(1);       ///< by the distance to the middle, for all samples
};

/// base^exponent in the lanes of `here`. Where the exponent is 1, it is the base to the bit.
template <class Real>
Real raised(const Real& base, const Real& exponent, Mask<Real> here) {
  const Mask<Real> computed = here && !(exponent == Real(1));
  if (!any(computed)) return base;
  return select(computed, pow_of(max_of(base, Real(0)), exponent), base);
}

/// How much a light fades at a distance: a factor. Source: POV-Ray 3.7, fade_distance and
/// fade_power.
template <class Real>
Real fade(const WorldLight& light, const Real& distance) {
  const Real share = distance / lift<Real>(light.fade_distance);
  return Real(2) / (Real(1) + pow_of(share, lift<Real>(light.fade_power)));
}

/// `light * share`, and 0 where light is 0: there `share` may be infinite or NaN, at a distance
/// that overflows float.
template <class Real>
Real faded(const Real& light, const Real& share) {
  return select(light > Real(0), light * share, Real(0));
}

/// The points of a light's samples: all of a pixel's together are Sobol's of the area that a point
/// sees, so that soft shadows are smooth at few.
template <class Real>
auto points_of_light(int number, const RayPath<Real>& path) {
  constexpr std::uint32_t of_lights = 0x80000000;  // blocks from here on are the lights' alone
  const SamplerState<Real>& state = path.sampler_state;
  const std::uint32_t block =
      of_lights | (path.node * 0x01000193U ^ static_cast<std::uint32_t>(number) << 13U);
  return SobolPairs<static_cast<std::size_t>(lanes<Real>)>(state.x, state.y, block, state.key);
}

/// The i-th sample of the light, at its point of those.
template <class Real, class Points>
LightSample<Real> sample_area(const WorldLight& light, int i, const Vec3<Real>& p,
                              const RayPath<Real>& path, const Points& points) {
  const auto [u, v] = points(path.sampler_state.sample * static_cast<std::uint32_t>(light.samples) +
                             static_cast<std::uint32_t>(i));
  const Real at_u = unit_lanes<Real>(u), at_v = unit_lanes<Real>(v);
  return std::visit(
      [&]<class Form>(const Form& form) -> LightSample<Real> {
        if constexpr (AreaForm<Form>) return sample_li(form, p, at_u, at_v);
        else return sample_middle(form, p);
      },
      light.form);
}

/// The direct lighting by one light sample, not faded. Only lanes that have hit something cast
/// shadow rays.
template <class AnyWorldView, class Point, class Real>
DirectLighting<Real> estimate_direct(AnyWorldView& world_view, const WorldLight& light,
                                     const LightSample<Real>& sample,
                                     const SurfaceInteraction<Point, Real>& isect,
                                     const Vec3<Real>& direction, const Phong<Real>& phong) {
  if constexpr (!AnyWorldView::plain)
    world_view.work.test();  // also for lights below the horizon, which take time as well
  const Real n_dot_l = dot(isect.at.n, sample.wi);
  // Infinite or NaN where the distance to the light underflows float.
  const Mask<Real> lit = isect.here && n_dot_l > Real(0) && n_dot_l < Real(infinity);
  if (!any(lit)) return {};
  world_view.rays.shadow += count(lit);
  const Real visible = world_view.visible(isect.shadow_ray(sample.wi), sample.distance, light, lit);
  DirectLighting<Real> direct;
  direct.visible = select(lit, visible, Real(0));
  const Real strength = visible * sample.strength;
  if constexpr (AnyWorldView::plain) {
    direct.diffuse = select(lit, strength * n_dot_l, Real(0));
  } else {
    direct.diffuse = select(lit, strength * raised(n_dot_l, phong.brilliance, lit), Real(0));
    const Mask<Real> shines = lit && strength > Real(0);
    if (any(shines && phong.specular > Real(0))) {
      const Real r_dot_l = dot(reflect(direction, isect.at.n), sample.wi);
      const Mask<Real> shiny = shines && r_dot_l > Real(0);
      direct.specular = select(
          shiny, strength * (phong.specular * raised(r_dot_l, phong.exponent, shiny)), Real(0));
    }
  }
  return direct;
}

/// The mean of the direct lighting by all samples of a light, not faded.
template <class Point, class Real>
DirectLighting<Real> average_direct(WorldView& world_view, int number,
                                    const LightSample<Real>& middle,
                                    const SurfaceInteraction<Point, Real>& isect,
                                    const Vec3<Real>& direction, const Phong<Real>& phong,
                                    const RayPath<Real>& path) {
  const WorldLight& light = world_view.world.lights[static_cast<std::size_t>(number)];
  if (!world_view.rules.area_lights || light.samples == 1)
    return estimate_direct(world_view, light, middle, isect, direction, phong);
  DirectLighting<Real> sum;
  const auto points = points_of_light(number, path);
  for (int i = 0; i < light.samples; ++i) {
    const LightSample<Real> sample = sample_area(light, i, isect.at.p, path, points);
    const DirectLighting<Real> one =
        estimate_direct(world_view, light, sample, isect, direction, phong);
    sum.diffuse = sum.diffuse + one.diffuse;
    sum.specular = sum.specular + one.specular;
    sum.visible = sum.visible + one.visible;
  }
  const Real share(1 / static_cast<float>(light.samples));
  return {sum.diffuse * share, sum.specular * share, sum.visible * share};
}

/// The direct lighting by the light of that number in the world, faded. In a plain world view a
/// light has one sample and does not fade.
template <class AnyWorldView, class Point, class Real>
auto sample_ld(AnyWorldView& world_view, int number, const SurfaceInteraction<Point, Real>& isect,
               const Vec3<Real>& direction, const Phong<Real>& phong, const RayPath<Real>& path) {
  const WorldLight& light = world_view.world.lights[static_cast<std::size_t>(number)];
  if constexpr (AnyWorldView::plain) {
    return estimate_direct(world_view, light, world_view.sample_middle(light, isect.at.p), isect,
                           direction, phong);
  } else {
    const LightSample<Real> middle = world_view.sample_middle(light, isect.at.p);
    LightContribution<Real> direct{
        average_direct(world_view, number, middle, isect, direction, phong, path), middle};
    if (light.fade_distance > 0) {
      direct.fade = fade(light, middle.distance);
      direct.diffuse = faded(direct.diffuse, direct.fade);
      direct.specular = faded(direct.specular, direct.fade);
    }
    return direct;
  }
}

}  // namespace tia
