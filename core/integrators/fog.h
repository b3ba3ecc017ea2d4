// Fog along the rays of a packet: how much light comes through, and where it is scattered.
#pragma once

#include <array>
#include <optional>

#include "core/integrators/fog_line.h"
#include "core/integrators/light_sampling.h"
#include "core/integrators/path_numbers.h"
#include "core/math/powers.h"

namespace tia {

/// FogSpan: the distances along a packet's rays between which the world's fog fills their way;
/// those of some lanes may be empty.
template <class Real>
struct FogSpan {
  Real near = Real(0), far = Real(0);
  Mask<Real> here{};  ///< where it is not empty
  Mask<Real> open{};  ///< where nothing lies behind it

  FogSpan() = default;
  /// `foggy`: the lanes whose rays are in no body.
  FogSpan(const WorldFog& fog, const Ray<Real>& ray, const Real& t_max, Mask<Real> foggy)
      : far(t_max) {
    if (fog.region) clip(fog.region, ray, foggy);
    here = foggy && near < far;
    open = here && !(t_max < Real(infinity));
  }
  Real transmittance(const Real& density) const {
    return select(here, exp_of(-density * (far - near)), Real(1));
  }

 private:
  void clip(const std::optional<Region>& region, const Ray<Real>& ray, Mask<Real> foggy) {
    using Lane = LaneOf<Real>;
    std::array<Lane, static_cast<std::size_t>(lanes<Real>)> in{}, out{};
    each_lane<Real>(foggy, [&](int i, std::size_t at) {
      const Chord held = chord(region, {lane_of(ray.origin, i), lane_of(ray.direction, i)});
      in[at] = static_cast<Lane>(held.in.t), out[at] = static_cast<Lane>(held.out.t);
    });
    near = max_of(load<Real>(in.data()), near);
    far = min_of(load<Real>(out.data()), far);
  }
};

/// FogSampling: where along their ways rays scatter in fog, and which light they are given there.
/// A distance and a light are drawn together, by two ways alike: the light, and then the distance
/// by the angle seen from its middle, or by what comes through. Both keep to where the light
/// shines. Among many lights, that which may give much depends on the place: there, what comes
/// through decides on the distance first.
template <class Real>
class FogSampling {
  using V = Vec3<Real>;
  using Lane = LaneOf<Real>;
  using Lanes = std::array<Lane, static_cast<std::size_t>(lanes<Real>)>;

 public:
  FogSampling(const World& world, const LightSampling<Real>& lights)
      : fog_(world.fog), all_(lights), lights_(world.path_lights) {}

  /// How far paths go before the fog scatters them, whether that is within the span, and what they
  /// count then.
  struct Flight {
    Real t;
    Mask<Real> scattered;
    Real weight;
  };
  Flight flight(const Ray<Real>& ray, const FogSpan<Real>& span, const Real& u) const {
    Lanes t{}, weight{};
    each_lane<Real>(span.here, [&](int i, std::size_t at) {
      const FogLine way = line(ray, span, i);
      t[at] = static_cast<Lane>(way.flight(tia::lane(u, i)));
      weight[at] = static_cast<Lane>(way.flight_weight());
    });
    const Real distance = load<Real>(t.data());
    return {distance, span.open || (span.here && distance < span.far), load<Real>(weight.data())};
  }

  /// Where light is asked for: at a distance where the fog meets light from the ray's beginning
  /// with density `met`, and where flight() leads with density `flown`.
  struct Meeting {
    Real t, met, flown;
  };
  /// Calls f(meeting, draw, mask) for what the lanes of `here` ask for, what one light sends there;
  /// `draw.pdf` is by distance, too.
  template <class F>
  void draw(const Ray<Real>& ray, const FogSpan<Real>& span,
            const typename PathNumbers<Real>::InFog& numbers, Mask<Real> here, F f) const {
    if (lights_.empty()) return;
    Lanes light, share{}, t{}, met{}, flown{};
    light.fill(-1);
    each_lane<Real>(here, [&](int i, std::size_t at) {
      const FogLine way = line(ray, span, i);
      const Drawn one = drawn(way, tia::lane(numbers.choice, i), tia::lane(numbers.distance, i));
      light[at] = static_cast<Lane>(one.light), share[at] = static_cast<Lane>(one.density);
      t[at] = static_cast<Lane>(one.t);
      met[at] = static_cast<Lane>(one.met);
      flown[at] = static_cast<Lane>(one.met / way.flight_weight());
    });
    const Meeting meeting{load<Real>(t.data()), load<Real>(met.data()), load<Real>(flown.data())};
    all_.draw_of(load<Real>(light.data()), load<Real>(share.data()),
                 ray.origin + ray.direction * meeting.t, numbers.u, numbers.v, here,
                 [&](const LightDraw<Real>& drawn, Mask<Real> those) { f(meeting, drawn, those); });
  }

  /// FogVertex: where a path has scattered in fog, for what it then meets.
  struct Vertex {
    Ray<Real> ray;
    FogSpan<Real> span;
    Real t;
    Mask<Real> here{};
  };
  /// The density with which draw() would have asked for a light at the vertex, over that with which
  /// flight() has led there.
  double chance(const Vertex& vertex, int light, int i) const {
    const FogLine way = line(vertex.ray, vertex.span, i);
    const auto t = static_cast<double>(tia::lane(vertex.t, i));
    return density(way, Aim(way, lights_, light), t) * way.flight_weight() / way.met(t);
  }
  /// The same of all that is infinitely far, over its chance_beyond(); 1 at surfaces.
  Real times_beyond(const Vertex& vertex) const {
    Lanes times;
    times.fill(1);
    each_lane<Real>(vertex.here, [&](int i, std::size_t at) {
      const FogLine way = line(vertex.ray, vertex.span, i);
      times[at] = static_cast<Lane>(way.flight_weight() / way.taken());
    });
    return load<Real>(times.data());
  }

 private:
  FogLine line(const Ray<Real>& ray, const FogSpan<Real>& span, int i) const {
    return {lane_of(ray.origin, i),
            lane_of(ray.direction, i),
            tia::lane(span.near, i),
            tia::lane(span.far, i),
            fog_.density,
            (bits(span.open) >> i & 1U) != 0};
  }
  // Aim: the distances at which one light is asked for that is chosen first.
  class Aim {
   public:
    Aim(const FogLine& way, const PathLights& lights, int light)
        : light_(light), lit_(way.lit_by(spans(way, lights, light))) {
      if (lights.is_near(light)) view_.emplace(lit_, lights.middle(light));
    }
    Aim(const Aim&) = delete;
    Aim& operator=(const Aim&) = delete;
    int light() const { return light_; }
    bool is_dark() const { return !(lit_.taken() > 0); }
    double by_angle(double u) const { return view_ ? view_->draw(u) : lit_.within(u); }
    double by_way(double u) const { return lit_.within(u); }
    double pdf_by_angle(double t) const { return view_ ? view_->pdf(t) : pdf_by_way(t); }
    double pdf_by_way(double t) const { return lit_.has(t) ? lit_.met(t) / lit_.taken() : 0; }

   private:
    static LitSpans spans(const FogLine& way, const PathLights& lights, int light) {
      return light < lights.size() ? lit_spans(lights[light], way.origin(), way.direction())
                                   : LitSpans::whole();
    }
    int light_;
    FogLine lit_;
    std::optional<FogLine::View> view_;  // of what is near
  };
  struct Drawn {
    int light = -1;
    double t = 0, met = 0, density = 0;  // of the line there, and of all that is drawn
  };
  Drawn drawn(const FogLine& way, double choice, double u) const {
    const bool by_angle = choice >= 0.5;
    const bool place_first = !by_angle && lights_.knows_places();
    const double place = place_first ? way.within(u) : 0;
    const Vec3d from = place_first ? way.point(place) : way.outlook();
    const int light = lights_.choose(from, {}, by_angle ? 2 * choice - 1 : 2 * choice).light;
    if (light < 0) return {};
    const Aim aim(way, lights_, light);
    if (aim.is_dark()) return {};
    const double t = place_first ? place : by_angle ? aim.by_angle(u) : aim.by_way(u);
    return {light, t, way.met(t), density(way, aim, t)};
  }
  // Of a light and a distance t.
  double density(const FogLine& way, const Aim& aim, double t) const {
    const double first = lights_.chance(aim.light(), way.outlook(), {});
    const double by_way = lights_.knows_places() ? lights_.chance(aim.light(), way.point(t), {}) *
                                                       (way.met(t) / way.taken())
                                                 : first * aim.pdf_by_way(t);
    return (by_way + first * aim.pdf_by_angle(t)) / 2;
  }

  const WorldFog& fog_;
  const LightSampling<Real>& all_;
  const PathLights& lights_;
};

}  // namespace tia
