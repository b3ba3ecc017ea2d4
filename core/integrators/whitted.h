// The slides' integrator (Whitted 1980): at the nearest surface the ambient, diffuse and specular
// light of the lamps that it sees, then what its mirror and its glass show, traced the same way.
// The thesis' integrator is this with its settings fixed: n.l alone, one point a lamp, no depth.
#pragma once

#include "core/integrators/direct.h"
#include "core/integrators/notes.h"

namespace tia {

/// Finishes: what a packet's surfaces do with light besides scattering it, each lane its own.
template <class Real>
struct Finishes {
  Vec3<Real> ambient{};
  Gloss<Real> gloss{};
  Real reflection{}, transmission{}, fresnel{};
  Medium<Real> inside{};
  Real object{};

  void take(const Matter& matter, int number, Mask<Real> here) {
    const auto into = [&](Real& to, double from) { to = select(here, lift<Real>(from), to); };
    ambient = select(here, lift<Real>(matter.ambient), ambient);
    into(gloss.brilliance, matter.brilliance);
    into(gloss.specular, matter.specular);
    into(gloss.exponent, matter.exponent);
    into(reflection, matter.reflection);
    into(transmission, matter.transmission);
    into(fresnel, matter.fresnel ? 1 : 0);
    into(inside.ior, matter.ior);
    inside.absorption = select(here, lift<Real>(matter.absorption), inside.absorption);
    into(object, number);
  }
};

/// `whole`: the slides' integrator, else the thesis'. The taker takes down what is computed.
template <bool whole, class Scope, class Real, class Taker = NoNotes>
class Whitted {
  using V = Vec3<Real>;

 public:
  Whitted(Scope& scope, Taker& taker) : scope_(scope), taker_(taker) {}

  /// Light along rays. Returns: linear RGB, unclamped; meaningless in lanes that are not active.
  /// Source: the slides; Whitted, "An improved illumination model for shaded display" (1980).
  V trace(const Ray<Real>& ray, Mask<Real> active, const Path<Real>& path) {
    const Hit<Real> hit = first_hit(scope_, ray, active, path.kind);
    const auto seen = surfaces(scope_, ray, hit, active);
    taker_.begin(ray, path.depth, hit, seen.at.p, seen.at.n,
                 seen.at.p + seen.at.side() * seen.offset);
    V light = lift<Real>(scope_.world.background);
    if (any(seen.here)) light = select(seen.here, shade(ray, hit, seen, path), light);
    else taker_.term(TermName::background, Real(1), light);
    const V transmittance = left_by(path.medium, hit.t);
    taker_.end(light, transmittance);
    return whole ? light * transmittance : light;
  }

 private:
  template <class Point>
  V shade(const Ray<Real>& ray, const Hit<Real>& hit, const Seen<Point, Real>& seen,
          const Path<Real>& path) {
    if constexpr (!whole) {
      V light = seen.emission;
      taker_.term(TermName::emission, Real(1), light);
      add_lamps(light, ray, seen, {}, Real(1), path);
      return light;
    } else {
      const Finishes<Real> finish = finishes(hit, seen.here);
      const Real keep = Real(1) - finish.transmission;  // of the surface's own light
      V light{Real(0), Real(0), Real(0)};
      add(light, TermName::emission, keep, seen.emission);
      add(light, TermName::ambient, keep,
          seen.tinted ? finish.ambient * seen.tint : finish.ambient);
      add_lamps(light, ray, seen, finish.gloss, keep, path);
      if (path.depth < scope_.max_depth) add_children(light, ray, hit, seen, finish, keep, path);
      return light;
    }
  }

  void add(V& light, TermName name, const Real& weight, const V& value) {
    light = light + value * weight;
    taker_.term(name, weight, value);
  }

  Finishes<Real> finishes(const Hit<Real>& hit, Mask<Real> active) const {
    Finishes<Real> all;
    for_each_winner(hit, active, [&](int part, Mask<Real> here) {
      all.take(scope_.world.matter_of(part), scope_.world.part(part).object, here);
    });
    return all;
  }

  // ---- light straight from the lamps ----------------------------------------------------------

  template <class Point>
  void add_lamps(V& light, const Ray<Real>& ray, const Seen<Point, Real>& seen,
                 const Gloss<Real>& gloss, const Real& keep, const Path<Real>& path) {
    const auto& lamps = scope_.world.lamps;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const int number = static_cast<int>(i);
      const Direct<Real> direct =
          light_from<whole>(scope_, number, seen, ray.direction, gloss, path);
      if constexpr (Taker::taken) taker_.light = note_of(number, seen, direct);
      const V color = lift<Real>(lamps[i].color);
      if (Taker::taken || any(direct.diffuse > Real(0)))
        add(light, TermName::diffuse, keep * direct.diffuse, seen.albedo * color);
      if (any(direct.specular > Real(0)))
        add(light, TermName::specular, keep * direct.specular, color);
    }
    if constexpr (Taker::taken) taker_.light = {};
  }

  template <class Point>
  LampNote note_of(int number, const Seen<Point, Real>& seen, const Direct<Real>& direct) const {
    const Lamp& lamp = scope_.world.lamps[static_cast<std::size_t>(number)];
    const Incoming<Real> from = scope_.from_middle(lamp, seen.at.p);
    const Real faded = lamp.fade_distance > 0 ? fade(lamp, from.distance) : Real(1);
    return {number, from, dot(seen.at.n, from.way), direct.visible, faded};
  }

  // ---- mirrored and refracted light -----------------------------------------------------------

  // Where light goes on from a surface: the weights of both ways, and what is behind it.
  struct Ways {
    Real mirror, glass;
    Refraction<Real> bent;
    Medium<Real> behind;
  };

  Ways ways(const V& direction, const V& n, const Real& copy, Mask<Real> here, Mask<Real> front,
            const Finishes<Real>& finish, const Real& keep, const Path<Real>& path) const {
    Ways ways{select(here, keep * finish.reflection, Real(0)), Real(0), {}, {}};
    const Mask<Real> glass = here && finish.transmission > Real(0);
    if (!any(glass)) return ways;
    const Medium<Real>& inside = finish.inside;
    const auto outside = medium_around(path.through, glass, !front, finish.object, copy);
    const Real before = select(front, outside.ior, inside.ior);
    ways.behind = {select(front, inside.ior, outside.ior),
                   select(front, inside.absorption, outside.absorption)};
    ways.bent = refracted(direction, n, before / ways.behind.ior);
    const Real mirrored = select(finish.fresnel > Real(0),
                                 fresnel(before, ways.behind.ior, ways.bent),
                                 select(ways.bent.total, Real(1), Real(0)));
    ways.mirror = ways.mirror + select(glass, finish.transmission * mirrored, Real(0));
    ways.glass = select(glass, finish.transmission * (Real(1) - mirrored), Real(0));
    return ways;
  }

  void add_children(V& light, const Ray<Real>& ray, const Hit<Real>& hit,
                    const Seen<SurfacePoint<Real>, Real>& seen, const Finishes<Real>& finish,
                    const Real& keep, const Path<Real>& path) {
    // A smooth normal that looks away from the viewer would send rays through the surface.
    const V n = select(dot(seen.at.n, ray.direction) < Real(0), seen.at.n, seen.at.ng);
    const Mask<Real> front = seen.at.front;
    const Ways go =
        ways(ray.direction, n, hit.copy, seen.here, front, finish, keep, path);
    const V aside = seen.at.ng * seen.offset;
    if (const Mask<Real> here = go.mirror > Real(0); any(here)) {
      const Ray<Real> child{seen.at.p + aside, normalize(mirrored(ray.direction, n))};
      add_child(light, TermName::reflection, go.mirror, child, here, path.mirrored());
    }
    if (const Mask<Real> here = go.glass > Real(0); any(here)) {
      const Ray<Real> child{seen.at.p - aside, go.bent.way};
      const Interface<Real> at{path.through,  here,     front,
                               finish.object, hit.copy, finish.inside};
      add_child(light, TermName::refraction, go.glass, child, here,
                path.refracted(at, go.behind));
    }
  }

  void add_child(V& light, TermName name, const Real& weight, const Ray<Real>& ray,
                 Mask<Real> here, const Path<Real>& path) {
    const V none{Real(0), Real(0), Real(0)};
    const V value = select(here, trace(ray, here, path), none);
    light = light + value * weight;
    taker_.child(name, weight, value);
  }

  // What a medium leaves of light on its way. Source: the law of Beer and Lambert.
  V left_by([[maybe_unused]] const Medium<Real>& medium, [[maybe_unused]] const Real& t) const {
    const Real zero(0), one(1);
    if constexpr (whole) {
      const V& a = medium.absorption;
      const auto left = [&](const Real& absorption) {
        const Mask<Real> absorbs = absorption > zero;
        return any(absorbs) ? select(absorbs, exp_of(-absorption * t), one) : one;
      };
      return {left(a.x), left(a.y), left(a.z)};
    }
    return {one, one, one};
  }

  Scope& scope_;
  Taker& taker_;
};

/// The slides' light along camera rays, and the thesis'. The draws tell pixels and sample.
template <class Real>
Vec3<Real> whitted(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active,
                   const Draws<Real>& draws);
template <class Scope, class Real>
Vec3<Real> thesis(Scope& scope, const Ray<Real>& ray, Mask<Real> active,
                  const Draws<Real>& draws) {
  NoNotes notes;
  return Whitted<false, Scope, Real>(scope, notes).trace(ray, active, Path<Real>{draws});
}

/// The whole tree of one camera ray, by the picture's own arithmetic.
std::unique_ptr<RayNode> explain_whitted(WorldScope& scope, const Ray<float>& ray,
                                         const Draws<float>& draws);
std::unique_ptr<RayNode> explain_thesis(WorldScope& scope, const Ray<float>& ray,
                                        const Draws<float>& draws);

}  // namespace tia
