// Path tracing: light as it really goes, with all that surfaces and fog send to each other.
#include <optional>

#include "core/integrators/integrator.h"
#include "core/integrators/light_gatherer.h"
#include "core/materials/spectrum.h"
#include "core/scene/scene.h"

namespace tia {
namespace {

/// PathTracer: the light along camera rays, estimated by one path each: at every vertex one point
/// of one light is asked for, and one direction, drawn by the surface, goes on. In fog, light is
/// asked for somewhere along each of the path's rays, and the path scatters there by chance.
/// Source: Kajiya, "The rendering equation" (1986); Veach, "Robust Monte Carlo methods for light
/// transport simulation" (1997), ch. 8 to 10.
template <class Real, class Recorder = NoPathRecorder>
class PathTracer {
  using V = Vec3<Real>;
  using Surface = SurfaceInteraction<SurfacePoint<Real>, Real>;
  using Numbers = typename PathNumbers<Real>::AtVertex;
  using Flight = typename FogSampling<Real>::Flight;

 public:
  PathTracer(WorldView& world_view, const SamplerState<Real>& sampler_state, Recorder& recorder)
      : world_view_(world_view),
        recorder_(recorder),
        numbers_(sampler_state),
        lights_(world_view, state_, world_view.parts != nullptr ? &parts_.emplace() : nullptr,
                recorder) {}

  V trace(Ray<Real> ray, Mask<Real> active) {
    const int max_depth = std::min(world_view_.rules.max_depth, SceneOptions::deepest);
    for (int depth = 0; any(active); ++depth) {
      count_rays(depth, active);
      const Hit<Real> hit = hit_of(ray, active, depth);
      Surface isect = surfaces(world_view_, ray, hit, active, state_.travelled);
      if (world_view_.guides != nullptr) guide(depth, isect, hit);
      state_.beta = state_.beta * transmittance_of(state_.medium.absorption, hit.t);
      if constexpr (Recorder::records)
        recorder_.begin(ray, hit, isect.at.p, isect.at.n, state_.beta);
      const FogSpan<Real> span = span_of(ray, hit.t, active);
      lights_.add_emitted(ray, hit, isect, span, active);
      if (depth > 0 && world_view_.world.floor >= 0) isect.here = isect.here && !on_floor(hit);
      if (!any(isect.here || span.here)) break;
      if (depth < max_depth && any(span.here))
        lights_.add_scattered(ray, span, numbers_.in_fog(depth));
      const Numbers numbers = numbers_.at_vertex(depth);
      const Flight flight = fly(ray, span, numbers);
      isect.here = isect.here && !flight.scattered;
      state_.travelled = state_.travelled + select(flight.scattered, flight.t, hit.t);
      if (depth == max_depth) {
        const int cut = count(flight.scattered || scatters(world_view_.world, hit, isect));
        world_view_.rays.cut += cut;
        if constexpr (Recorder::records) recorder_.cut(cut > 0);
        break;
      }
      const V arriving = state_.beta;
      Ray<Real> next = ray;
      if (any(isect.here)) active = scatter(ray, hit, isect, numbers, depth, next);
      else active = isect.here;
      if (any(flight.scattered))
        active = active || scatter_in_fog(ray, flight, span, arriving, numbers, depth, next);
      if (parts_) parts_->go_on(state_.pdf);
      ray = next;
    }
    const V light = clamped(state_.light);
    if (parts_) parts_->store_to(*world_view_.parts);
    if constexpr (Recorder::records) recorder_.finish(light, state_.wave);
    return light;
  }

 private:
  // The same path goes on through what is there in part, by chance. Its weights stay as they are:
  // what light is asked for is dimmed by as much.
  Hit<Real> hit_of(const Ray<Real>& ray, Mask<Real> active, int depth) {
    if (!world_view_.world.passable)
      return depth == 0 ? world_view_.closest_seen(ray, active) : world_view_.closest(ray, active);
    const Sight<Real> sight{numbers_.passing(depth), !(state_.pdf > Real(0))};
    const Hit<Real> hit = world_view_.stop_of(ray, active, sight, depth == 0);
    if (depth == 0) world_view_.met = bits(active && hit.t < Real(infinity));
    return hit;
  }
  [[gnu::noinline]] void guide(int depth, const Surface& isect, const Hit<Real>& hit) const {
    if (depth == 0) world_view_.guides->take(isect, hit.t);
    else world_view_.guides->close();
  }
  // Where all light ends that does not come from there to the camera.
  Mask<Real> on_floor(const Hit<Real>& hit) const {
    return hit.primitive == Real(static_cast<float>(world_view_.world.floor));
  }
  // What a matt surface sends on counts as reflected.
  void count_rays(int depth, Mask<Real> active) {
    const int refracted = depth == 0 ? 0 : count(active && state_.transmitted);
    world_view_.rays.count(RayKind::refraction, refracted);
    world_view_.rays.count(depth == 0 ? RayKind::primary : RayKind::reflection,
                           count(active) - refracted);
  }
  V clamped(const V& light) {
    const double most = world_view_.rules.clamp;
    if (most == Rules{}.clamp) return light;
    const Real brightest = max_of(max_of(light.x, light.y), light.z), bound = lift<Real>(most);
    const Real share = select(brightest > bound, bound / brightest, Real(1));
    if (parts_) parts_->dim(share);
    if constexpr (Recorder::records) recorder_.clamped(share);
    return light * share;
  }

  // ---- wavelengths ------------------------------------------------------------------------------

  static Mask<Real> disperses(const Scatterers<Real>& materials, Mask<Real> here) {
    return here && !materials.bsdf.thin && materials.bsdf.glass > Real(0) &&
           materials.bsdf.dispersion > Real(0);
  }
  // A path that meets glass which parts colours is of a single wavelength from there on.
  void disperse(Scatterers<Real>& materials, Mask<Real> here) {
    const Mask<Real> parted = disperses(materials, here),
                     fresh = parted && !(state_.wave > Real(0));
    if (any(fresh)) {
      const Real wave = Real(shortest_wave) + numbers_.wave() * Real(longest_wave - shortest_wave);
      state_.wave = select(fresh, wave, state_.wave);
      state_.beta = select(fresh, state_.beta * wave_color(state_.wave), state_.beta);
    }
    auto& [bsdf, inside, object] = materials;
    inside.ior = select(parted, ior_at(bsdf.ior, bsdf.dispersion, state_.wave), inside.ior);
  }

  // ---- fog --------------------------------------------------------------------------------------

  FogSpan<Real> span_of(const Ray<Real>& ray, const Real& t_max, Mask<Real> active) const {
    const WorldFog& fog = world_view_.world.fog;
    if (!(fog.density > 0)) return {};
    return {fog, ray, t_max, active && state_.medium.density > Real(0)};
  }
  // Where the fog scatters the path. Where it only absorbs, light that passes is dimmed instead.
  Flight fly(const Ray<Real>& ray, const FogSpan<Real>& span, const Numbers& numbers) {
    state_.fog_vertex.here = Mask<Real>{};
    if (!any(span.here)) return {};
    if (!emits(world_view_.world.fog.albedo.exact)) {
      state_.beta = state_.beta * span.transmittance(state_.medium.density);
      return {};
    }
    return lights_.fog().flight(ray, span, numbers.flight);
  }
  Mask<Real> scatter_in_fog(const Ray<Real>& ray, const Flight& flight, const FogSpan<Real>& span,
                            const V& arriving, const Numbers& numbers, int depth, Ray<Real>& next) {
    const Mask<Real> here = flight.scattered;
    state_.fog_vertex = {ray, span, flight.t, here};
    const V p = ray.origin + ray.direction * flight.t;
    const V wi = lights_.phase().sample(ray.direction, numbers.u, numbers.v);
    const V scattered = arriving * lift<Real>(world_view_.world.fog.albedo);
    state_.beta = select(here, scattered * flight.weight, state_.beta);
    state_.pdf = select(here, lights_.phase().value(dot(ray.direction, wi)), state_.pdf);
    state_.from = select(here, p, state_.from);
    state_.transmitted = state_.transmitted && !here;
    next = {select(here, p, next.origin), select(here, wi, next.direction)};
    if constexpr (Recorder::records)
      recorder_.drawn(PathEvent::volume, p,
                      lift<Real>(world_view_.world.fog.albedo) * flight.weight, state_.pdf);
    return went_on(here && survives(depth, here, numbers), here);
  }

  // ---- the path goes on -------------------------------------------------------------------------

  // At surfaces. Returns: the lanes that go on, by `next`.
  Mask<Real> scatter(const Ray<Real>& ray, const Hit<Real>& hit, const Surface& isect,
                     const Numbers& numbers, int depth, Ray<Real>& next) {
    auto materials = scatterers(world_view_.world, hit, isect);
    if (any(disperses(materials, isect.here))) disperse(materials, isect.here);
    const auto behind = boundary(materials, isect, hit, last_, space_);
    const Bsdf<Real> bsdf(materials.bsdf, -ray.direction, isect.at.n, isect.at.ng, behind.eta,
                          isect.here, isect.textures.frames ? &*isect.textures.frames : nullptr);
    lights_.add_direct(isect, bsdf, behind, numbers);
    const BsdfSample<Real> drawn = bsdf.sample(numbers.lobe, numbers.u, numbers.v);
    state_.beta = state_.beta * drawn.weight;
    state_.denser =
        select(drawn.transmitted, state_.denser * (bsdf.eta() * bsdf.eta()), state_.denser);
    if constexpr (Recorder::records)
      if (drawn.here) recorder_.drawn(event_of(bsdf, drawn), isect.at.p, drawn.weight, drawn.pdf);
    const Mask<Real> here = went_on(drawn.here && survives(depth, drawn.here, numbers), drawn.here);
    const Mask<Real> enters = drawn.transmitted && !materials.bsdf.thin;
    if (any(enters)) pass(hit, isect, materials, behind, enters, depth);
    state_.pdf = drawn.pdf;
    state_.from = isect.at.p;
    state_.from_n = isect.at.ng;
    state_.transmitted = drawn.transmitted;
    next = isect.ray_off(drawn.wi, drawn.transmitted);
    return here;
  }
  // From the fifth vertex on paths end by chance, the less they count the sooner.
  Mask<Real> survives(int depth, Mask<Real> here, const Numbers& numbers) {
    if (depth + 1 < 5) return shines(state_.beta);
    const Real most = max_of(max_of(state_.beta.x, state_.beta.y), state_.beta.z) * state_.denser;
    const Real q = min_of(Real(0.95F), most);
    if constexpr (Recorder::records) recorder_.roulette(q);
    state_.beta = select(here, state_.beta * (Real(1) / q), state_.beta);
    return shines(state_.beta) && numbers.roulette < q;
  }
  Mask<Real> went_on(Mask<Real> here, Mask<Real> drawn) {
    if constexpr (Recorder::records) recorder_.goes_on(here, drawn && shines(state_.beta));
    return here;
  }
  void pass(const Hit<Real>& hit, const Surface& isect, const Scatterers<Real>& materials,
            const MediumBoundary<Real>& behind, Mask<Real> enters, int depth) {
    last_ = &passed_[static_cast<std::size_t>(depth)].emplace(MediumTransition<Real>{
        last_, enters, isect.at.front, materials.object, hit.instance, materials.inside});
    state_.medium = select(enters, behind.medium, state_.medium);
  }

  WorldView& world_view_;
  Recorder& recorder_;
  const PathNumbers<Real> numbers_;
  const Medium<Real> space_{.density = lift<Real>(world_view_.world.fog.density)};
  PathState<Real> state_{space_};
  std::optional<PathParts<Real>> parts_{};  // where they are asked for
  LightGatherer<Real, Recorder> lights_;
  std::array<std::optional<MediumTransition<Real>>, SceneOptions::deepest> passed_{};
  const MediumTransition<Real>* last_ = nullptr;
};

}  // namespace

template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::path>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                      Mask<Real> active,
                                                      const SamplerState<Real>& sampler_state) {
  NoPathRecorder recorder;
  return PathTracer<Real>(world_view, sampler_state, recorder).trace(ray, active);
}
TIA_INTEGRATOR(path)

PathRecord explain_path(WorldView& world_view, const Ray<float>& ray,
                        const SamplerState<float>& sampler_state) {
  PathRecorder recorder;
  PathTracer<float, PathRecorder>(world_view, sampler_state, recorder).trace(ray, true);
  return recorder.take();
}

}  // namespace tia
