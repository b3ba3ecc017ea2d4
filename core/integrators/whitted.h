// The slides' integrator (Whitted 1980): at the nearest surface the ambient, diffuse and specular
// light of the lamps that it sees, then what its mirror and its glass show, traced the same way.
// The thesis' integrator is its preset without depth, with one point a lamp.
#pragma once

#include "core/integrators/finishes.h"
#include "core/integrators/notes.h"

namespace tia {

/// The taker takes down what is computed.
template <class Scope, class Real, class Taker = NoNotes>
class Whitted {
  using V = Vec3<Real>;

 public:
  Whitted(Scope& scope, Taker& taker) : scope_(scope), taker_(taker) {}

  /// Light along rays. Returns: linear RGB, unclamped; meaningless in lanes that are not active.
  /// Source: the slides; Whitted, "An improved illumination model for shaded display" (1980).
  V trace(const Ray<Real>& ray, Mask<Real> active, const Path<Real>& path) {
    const Hit<Real> hit = first_hit(scope_, ray, active, path.kind);
    const auto seen = surfaces(scope_, ray, hit, active);
    taker_.begin(ray, path.depth, hit, seen.at.p, seen.at.n);
    V light = lift<Real>(scope_.world.background);
    if (any(seen.here)) light = select(seen.here, shade(ray, hit, seen, path), light);
    else taker_.term(TermName::background, Real(1), light);
    if constexpr (Scope::plain) return light;
    const V transmittance = left_by(path.absorption, hit.t);
    taker_.end(light, transmittance);
    return light * transmittance;
  }

 private:
  // With T the finish's transmission and F Fresnel's share (0, or 1 where light cannot pass):
  //   (1 - T) (emission + ambient * color
  //            + sum over lamps of visible * fade * light
  //                * (color * diffuse * (n.l)^brilliance + specular * (r.l)^(1/roughness)))
  //   + ((1 - T) reflection + T F) * mirrored + T (1 - F) * refracted
  // The lamps' terms are from_lamp's (direct.h), the two last weights ways_on's (finishes.h).
  template <class Point>
  V shade(const Ray<Real>& ray, const Hit<Real>& hit, const Seen<Point, Real>& seen,
          const Path<Real>& path) {
    V light{Real(0), Real(0), Real(0)};
    if constexpr (Scope::plain) {
      light = seen.emission;
      add_lamps(light, ray, seen, {}, Real(1), path);
    } else {
      const Finishes<Real> finish = finishes(scope_.world, hit, seen.here);
      const Real keep = Real(1) - finish.transmission;  // of the surface's own light
      add(light, TermName::emission, keep, seen.emission);
      add(light, TermName::ambient, keep, finish.ambient * seen.tint);
      add_lamps(light, ray, seen, finish.gloss, keep, path);
      if (path.depth < scope_.rules.max_depth) add_children(light, ray, hit, seen, finish, path);
    }
    return light;
  }

  void add(V& light, TermName name, const Real& weight, const V& value) {
    light = light + value * weight;
    taker_.term(name, weight, value);
  }

  // ---- light straight from the lamps ----------------------------------------------------------

  template <class Point>
  void add_lamps(V& light, const Ray<Real>& ray, const Seen<Point, Real>& seen,
                 const Gloss<Real>& gloss, const Real& keep, const Path<Real>& path) {
    const auto& lamps = scope_.world.lamps;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const int number = static_cast<int>(i);
      const std::int64_t shadow_rays = scope_.rays.shadow;
      const auto direct = from_lamp(scope_, number, seen, ray.direction, gloss, path);
      if constexpr (Taker::taken)
        taker_.light = note_of(number, seen, direct, scope_.rays.shadow > shadow_rays);
      const V color = lift<Real>(lamps[i].color);
      if (Taker::taken || any(direct.diffuse > Real(0)))
        add(light, TermName::diffuse, keep * direct.diffuse, seen.albedo * color);
      if (any(direct.specular > Real(0)))
        add(light, TermName::specular, keep * direct.specular, color);
    }
    if constexpr (Taker::taken) taker_.light = {};
  }

  // What has cast no shadow ray lies below the horizon and needs no blocker.
  template <class Point>
  LampNote note_of(int number, const Seen<Point, Real>& seen, const LampLight<Real>& light,
                   bool cast) {
    const Incoming<Real>& from = light.middle;
    LampNote note{number, from, dot(seen.at.n, from.way), light.visible, light.fade};
    if (!cast || note.visible >= 1) return note;
    const Lamp& lamp = scope_.world.lamps[static_cast<std::size_t>(number)];
    const auto [part, copy] = scope_.blocker(seen.shadow_ray(from.way), from.distance, lamp);
    note.blocker = part;
    note.blocker_copy = copy;
    return note;
  }

  // ---- mirrored and refracted light -----------------------------------------------------------

  void add_children(V& light, const Ray<Real>& ray, const Hit<Real>& hit,
                    const Seen<SurfacePoint<Real>, Real>& seen, const Finishes<Real>& finish,
                    const Path<Real>& path) {
    const SurfacePoint<Real>& at = seen.at;
    // A smooth normal that looks away from the viewer would send rays through the surface.
    const V n = select(dot(at.n, ray.direction) < Real(0), at.n, at.ng);
    const Ways<Real> on =
        ways_on(ray.direction, n, hit.copy, seen.here, at.front, finish, path.through);
    const V aside = at.ng * seen.offset;
    if (const Mask<Real> here = on.mirror > Real(0); any(here)) {
      const Ray<Real> child{at.p + aside, normalize(mirrored(ray.direction, n))};
      add_child(light, TermName::reflection, on.mirror, child, here, path.mirrored());
    }
    if (const Mask<Real> here = on.glass > Real(0); any(here)) {
      const Ray<Real> child{at.p - aside, on.bent.way};
      const Interface<Real> entry{path.through,  here,     at.front,
                                  finish.object, hit.copy, finish.inside};
      add_child(light, TermName::refraction, on.glass, child, here,
                path.refracted(entry, on.behind));
    }
  }

  void add_child(V& light, TermName name, const Real& weight, const Ray<Real>& ray, Mask<Real> here,
                 const Path<Real>& path) {
    const V none{Real(0), Real(0), Real(0)};
    const V value = select(here, trace(ray, here, path), none);
    light = light + value * weight;
    taker_.child(name, weight, value);
  }

  // What a medium leaves of light on its way. Source: the law of Beer and Lambert.
  static V left_by(const V& absorption, const Real& t) {
    const auto left = [&](const Real& a) {
      const Mask<Real> absorbs = a > Real(0);
      return any(absorbs) ? select(absorbs, exp_of(-a * t), Real(1)) : Real(1);
    };
    return {left(absorption.x), left(absorption.y), left(absorption.z)};
  }

  Scope& scope_;
  Taker& taker_;
};

/// The light along camera rays in a world of few balls; in any other it is an Integrator's.
template <class Real>
Vec3<Real> whitted(BallScope& scope, const Ray<Real>& ray, Mask<Real> active,
                   const Draws<Real>& draws) {
  NoNotes notes;
  return Whitted<BallScope, Real>(scope, notes).trace(ray, active, Path<Real>{draws});
}

/// The whole tree of one camera ray, by the picture's own arithmetic. Errors: the limit's.
std::unique_ptr<RayNode> explain_whitted(WorldScope& scope, const Ray<float>& ray,
                                         const Draws<float>& draws, const NoteLimit& limit);

}  // namespace tia
