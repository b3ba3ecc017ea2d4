#include "core/render/trace_tile.h"

#include <algorithm>
#include <deque>

#include "core/integrators/whitted.h"
#include "core/render/ground_shadow.h"
#include "core/render/packet_pixels.h"
#include "core/render/pixel_lanes.h"

namespace tia {
namespace {

// One tile's rays through a world view, at one instant.
template <class Real, class AnyWorldView>
class Tracer {
 public:
  // `spread`: how wide rays see that are of no pixel; 0: they are.
  Tracer(const Shot& shot, const Instant& at, int x0, int y0, int width, int height,
         double spread = 0)
      : eye(at.view),
        shot_(shot),
        at_(at),
        cone_(spread > 0 ? PixelCone{0, spread} : cone_of(at.view)),
        world_view_{world_view_of(x0, y0, width, height)} {
    if constexpr (may_have_backdrop) {
      if (hides_beyond_ && at.world.ground)
        ground_.emplace(at.world, shot.integrator, shot.rules, cone_,
                        [this](std::int64_t work) { spent(work); });
      if (shot.parts_light()) world_view_.parts = &parts_;
      if (shot.guided) world_view_.guides = &guides_;
    }
  }

  static constexpr bool may_have_backdrop = std::is_same_v<AnyWorldView, WorldView>;

  Vec3<Real> light(const Ray<Real>& ray, Mask<Real> active,
                   const SamplerState<Real>& sampler_state) {
    if constexpr (!may_have_backdrop) {
      return whitted(world_view_, ray, active, sampler_state);
    } else {
      const Vec3<Real> light = radiance(shot_.integrator, world_view_, ray, active, sampler_state);
      if (!hides_beyond_) return light;
      const Mask<Real> seen = met_lanes() > Real(0);
      if (ground_) on_ground_ = ground_->light(ray, active && !seen, sampler_state, rays());
      if (world_view_.parts != nullptr) parts_.replace(~met(), rgb_of(beyond_));
      return select(seen, light, backdrop_);
    }
  }
  /// Whether the world has a backdrop, and which lanes of the last rays met an object, as bits.
  bool has_backdrop() const { return at_.world.backdrop.has_value(); }
  unsigned met() const { return world_view_.met; }
  /// 1 in those lanes, else 0, or what a shadow there covers.
  Real alpha() const { return ground_ ? met_lanes() + on_ground_.alpha() : met_lanes(); }
  /// Whether there is a ground, and what the last rays found there.
  bool has_ground() const { return ground_.has_value(); }
  const GroundLight<Real>& on_ground() const { return on_ground_; }
  /// What the last rays show, whose light that is: before white, if it is before nothing.
  Vec3<Real> shown(const Vec3<Real>& light) const {
    const Color wall = at_.world.backdrop->color.value_or(Color{1, 1, 1});
    if constexpr (may_have_backdrop) return light + lift<Real>(rgb_of(wall)) * (Real(1) - alpha());
    else return light;
  }
  RayCounts& rays() { return world_view_.rays; }
  /// Tells the meter the rays since it was told last, or only where they have become many.
  /// Errors: the meter's.
  void tell_rays() {
    all_rays_ += rays();
    shot_.meter.add(rays());
  }
  void tell_many_rays() {
    if (rays().all() < RayMeter::often) return;
    all_rays_ += rays();
    shot_.meter.add_if_many(rays());
  }
  /// All that the meter has been told.
  const RayCounts& all_rays() const { return all_rays_; }
  /// What the last rays' light consists of, where that is asked for.
  const LightParts& parts() const { return parts_; }
  /// What the last rays have found, which are these. Domain: a shot that is guided.
  const Guides& guides(const Ray<Real>& ray, Mask<Real> active) {
    if constexpr (may_have_backdrop)
      if (!tells_guides(shot_.integrator)) find_guides(world_view_, ray, active);
    return guides_;
  }

  const View& view() const { return at_.view; }
  /// Light in those lanes that have a ray, in the others what there is without.
  [[gnu::noinline]] Vec3<Real> seen(const Vec3<Real>& light, const Mask<Real>& those) {
    if constexpr (may_have_backdrop)
      if (world_view_.parts != nullptr) parts_.replace(~bits(those), {});
    const Real nothing(row_of(shot_.integrator).nothing);
    return select(those, light, {nothing, nothing, nothing});
  }

  Eye<Real> eye;

 private:
  Real met_lanes() const { return ones_in<Real>(met()); }
  // A tree of rays may become very large, so its rays are counted while they are traced.
  void spent(std::int64_t work) {
    shot_.meter.add_work(work);
    tell_rays();
  }
  AnyWorldView world_view_of(int x0, int y0, int width, int height) {
    if constexpr (std::is_same_v<AnyWorldView, FewBallsView>) {
      const Beam beam(at_.view, x0, y0, x0 + width, y0 + height);
      return {at_.world, candidates(at_.world, beam)};
    } else {
      return {at_.world,   WorkCounter([this](std::int64_t work) { spent(work); }),
              shot_.rules, {},
              0,           cone_,
              &at_.view};
    }
  }

  // A transparent one is black: light is multiplied by alpha. So is one with a ground, till later.
  Color beyond() const {
    return has_backdrop() && !at_.world.ground ? at_.world.backdrop->color.value_or(Color{})
                                               : Color{};
  }

  const Shot& shot_;
  const Instant& at_;
  const PixelCone cone_;
  const Color beyond_ = beyond();
  RayCounts all_rays_;
  Guides guides_;
  AnyWorldView world_view_;
  const Vec3<Real> backdrop_ = lift<Real>(rgb_of(beyond_));
  GroundLight<Real> on_ground_;
  std::optional<GroundShadow<Real>> ground_;
  LightParts parts_{};
  const bool hides_beyond_ = has_backdrop() && gathers_light(shot_.integrator);
};

/// Tracers: of one tile, one for each of the picture's instants.
template <class Real, class AnyWorldView>
class Tracers {
 public:
  using OfInstant = Tracer<Real, AnyWorldView>;

  Tracers(const Shot& shot, const TilePixels& tile) {
    for (const Instant& at : shot.instants)
      all_.emplace_back(shot, at, tile.x0, tile.y0, tile.width, tile.height, tile.spread);
  }
  bool blur() const { return all_.size() > 1; }
  OfInstant& first() { return all_.front(); }
  OfInstant& of(int sample) { return all_[static_cast<std::size_t>(sample) % all_.size()]; }
  bool have_ground() const { return std::ranges::any_of(all_, &OfInstant::has_ground); }
  /// Tells the meter. Returns: the rays of all.
  RayCounts tell_rays() {
    RayCounts rays;
    for (OfInstant& each : all_) {
      each.tell_rays();
      rays += each.all_rays();
    }
    return rays;
  }

 private:
  std::deque<OfInstant> all_;  // which do not move
};

// ---- one ray a pixel of a perspective view, as for most pictures --------------------------------

template <class Real, class AnyWorldView>
[[gnu::flatten]] void trace_centers_in(const Shot& shot, int x0, int y0, FilmTile& tile) {
  using PacketPixels = tia::PacketPixels<Real>;
  constexpr bool draws_much = std::is_same_v<AnyWorldView, WorldView>;
  SamplerState<Real> sampler_state;
  sampler_state.key = shot.sampler.key();
  const View& view = shot.first().view;
  Tracer<Real, AnyWorldView> tracer(shot, shot.first(), x0, y0, tile.width, tile.height);
  const Vec3<Real> origin = lift<Real>(view.origin);
  const Real column_of = PacketPixels::column(), row_of = PacketPixels::row();
  const auto number = [](int i) { return Real(static_cast<float>(i)); };
  std::array<Vec3<Real>, FilmTile::size / PacketPixels::width> columns;
  for (int x = 0; x < tile.width; x += PacketPixels::width)
    columns[static_cast<std::size_t>(x / PacketPixels::width)] =
        view.column(number(x0 + x) + column_of);

  for (int y = 0; y < tile.height; y += PacketPixels::height) {
    const Vec3<Real> row = view.row(number(y0 + y) + row_of);
    const Mask<Real> rows = row_of < number(tile.height - y);
    for (int x = 0; x < tile.width; x += PacketPixels::width) {
      const Vec3<Real>& column = columns[static_cast<std::size_t>(x / PacketPixels::width)];
      const Mask<Real> active = rows && column_of < number(tile.width - x);
      if constexpr (draws_much) PacketPixels::number(x0 + x, y0 + y, sampler_state);
      const Vec3<Real> light =
          tracer.light({origin, normalize(column + row)}, active, sampler_state);
      const std::size_t i = FilmTile::index(x, y);
      PacketPixels::store(light.x, &tile.r[i]);
      PacketPixels::store(light.y, &tile.g[i]);
      PacketPixels::store(light.z, &tile.b[i]);
      if constexpr (draws_much)
        if (tracer.has_backdrop()) PacketPixels::store(tracer.alpha(), &tile.alpha[i]);
    }
  }
  shot.meter.add(tracer.rays());
}

// The same of what looks through no plane. Not flattened, as trace_curved_round.
template <class Real, class AnyWorldView>
[[gnu::noinline]] void trace_curved_centers_in(const Shot& shot, int x0, int y0, FilmTile& tile) {
  using PacketPixels = tia::PacketPixels<Real>;
  SamplerState<Real> sampler_state;
  sampler_state.key = shot.sampler.key();
  Tracer<Real, AnyWorldView> tracer(shot, shot.first(), x0, y0, tile.width, tile.height);
  const Real column_of = PacketPixels::column(), row_of = PacketPixels::row();
  const auto number = [](int i) { return Real(static_cast<float>(i)); };
  for (int y = 0; y < tile.height; y += PacketPixels::height)
    for (int x = 0; x < tile.width; x += PacketPixels::width) {
      const auto [ray, seen] = curved_ray(shot.first().view, number(x0 + x) + column_of,
                                          number(y0 + y) + row_of, Real(0), Real(0));
      const Mask<Real> active =
          seen && row_of < number(tile.height - y) && column_of < number(tile.width - x);
      PacketPixels::number(x0 + x, y0 + y, sampler_state);
      const Vec3<Real> light = tracer.seen(tracer.light(ray, active, sampler_state), active);
      const std::size_t i = FilmTile::index(x, y);
      PacketPixels::store(light.x, &tile.r[i]);
      PacketPixels::store(light.y, &tile.g[i]);
      PacketPixels::store(light.z, &tile.b[i]);
      if constexpr (std::is_same_v<AnyWorldView, WorldView>)
        if (tracer.has_backdrop()) PacketPixels::store(tracer.alpha(), &tile.alpha[i]);
    }
  shot.meter.add(tracer.rays());
}

// ---- many rays a pixel --------------------------------------------------------------------------

// Whether a round has as many samples as there are: then those are one half, and it is the other.
bool doubles(const Sampler& sampler, int round) {
  return sampler.is_chance() && sampler.before(round) == sampler.count(round);
}
void begin_half(TilePixels& tile) {
  for (const int pixel : tile.unsettled) {
    const Estimate& estimate = tile.estimates[static_cast<std::size_t>(pixel)];
    GuidedSums& sums = tile.guided[static_cast<std::size_t>(pixel)];
    sums = {sums.found, sums.found, estimate.light, estimate.count};
  }
}

template <class Real>
Vec3<Real> clamped(const Vec3<Real>& v) {
  const auto clamp = [](const Real& x) { return min_of(max_of(x, Real(0)), Real(1)); };
  return {clamp(v.x), clamp(v.y), clamp(v.z)};
}

// Through what else rays go: a gaze's targets, or pixels of a view that is no plane.
template <class Real>
void redirect(const View& view, const std::optional<TargetLanes<Real>>& targets,
              const Pixels<Real>& pixels, const Aim<Real>& aim, Ray<Real>& ray,
              Mask<Real>& active) {
  if (targets) {
    ray = targets->ray(aim);
  } else {
    const auto curved = curved_ray(view, pixels.column(), pixels.row(), aim.dx, aim.dy);
    ray = curved.ray;
    active = active && curved.seen;
  }
}

/// Round: what a round's samples of the pixels come to.
template <class Real, class AnyWorldView>
class Round {
 public:
  Round(const Shot& shot, int round, Tracers<Real, AnyWorldView>& tracers,
        const Pixels<Real>& pixels)
      : pixels_(pixels),
        count_(shot.sampler.count(round)),
        before_(shot.sampler.before(round)),
        half_(doubles(shot.sampler, round) ? 0 : (count_ + 1) / 2),
        watches_(shot.watches()),
        clamps_(shot.convergence.clamps()),
        guided_(shot.guided),
        has_backdrop_(tracers.first().has_backdrop()),
        has_ground_(tracers.have_ground()),
        first_(pixels.first_light()),
        sums_(pixels) {
    if (has_ground_) sums_.begin_ground(pixels);
  }
  int count() const { return count_; }
  int before() const { return before_; }
  /// The i-th sample, which the tracer has just traced.
  [[gnu::always_inline]] void add(Tracer<Real, AnyWorldView>& tracer, const Ray<Real>& ray,
                                  const Mask<Real>& active, const Vec3<Real>& light, int i) {
    sums_.add(light);
    if (pixels_.parts[0] != nullptr) pixels_.add(tracer.parts());
    if constexpr (Tracer<Real, AnyWorldView>::may_have_backdrop)
      if (has_backdrop_) sums_.add_met(tracer.met());
    if (has_ground_) sums_.add_ground(tracer.on_ground());
    if (guided_) {
      pixels_.add(tracer.guides(ray, active), i < half_);
      if (i == half_ - 1) pixels_.end_half(sums_.light, half_);
    }
    if (watches_) {
      const Vec3<Real> shown = has_ground_ ? tracer.shown(light) : light;
      const Vec3<Real> watched = clamps_ ? clamped(shown) : shown;
      if (before_ + i == 0) first_ = watched;
      sums_.add_deviation(watched, first_);
    }
    tracer.tell_many_rays();
  }
  void tell() const {
    sums_.scatter_to(pixels_);
    pixels_.tell(first_, count_);
  }

 private:
  const Pixels<Real>& pixels_;
  const int count_, before_, half_;  // of which the first half is added to one of guides
  const bool watches_, clamps_, guided_, has_backdrop_, has_ground_;
  Vec3<Real> first_;
  Sums<Real> sums_;
};

template <class Real, class AnyWorldView>
[[gnu::flatten]] void trace_flat_round(const Shot& shot, int number,
                                       Tracers<Real, AnyWorldView>& tracers,
                                       const Pixels<Real>& pixels) {
  Tracer<Real, AnyWorldView>* at = &tracers.first();
  Aims<Real> aims(shot.sampler, number, pixels.x, pixels.y, shot.has_lens());
  Vec3<Real> center = pixels.center(at->view());
  const Mask<Real> active = pixels.active();
  SamplerState<Real> sampler_state{pixels.x, pixels.y, 0, shot.sampler.key()};
  Round<Real, AnyWorldView> round(shot, number, tracers, pixels);
  for (int i = 0; i < round.count(); ++i) {
    if (tracers.blur()) {
      at = &tracers.of(round.before() + i);
      center = pixels.center(at->view());
    }
    const int point = shot.sampler.point(number, i);
    sampler_state.sample = static_cast<std::uint32_t>(round.before() + point);
    const Ray<Real> ray = at->eye.ray(center, aims(point));
    const Vec3<Real> light = at->light(ray, active, sampler_state);
    round.add(*at, ray, active, light, i);
  }
  round.tell();
}

// The same through a gaze's targets and of views that are no plane. Not flattened, which takes the
// compiler long: such rays cost more than the calls. A loop of its own, for of one for both g++ 12
// made a fifth more instructions of what is flat.
template <class Real, class AnyWorldView>
[[gnu::noinline]] void trace_curved_round(const Shot& shot, int number,
                                          Tracers<Real, AnyWorldView>& tracers,
                                          const Pixels<Real>& pixels) {
  Aims<Real> aims(shot.sampler, number, pixels.x, pixels.y, shot.has_lens());
  std::optional<TargetLanes<Real>> targets;
  if (pixels.targets[0] != nullptr) targets.emplace(pixels, tracers.first().view());
  SamplerState<Real> sampler_state{pixels.x, pixels.y, 0, shot.sampler.key()};
  Round<Real, AnyWorldView> round(shot, number, tracers, pixels);
  for (int i = 0; i < round.count(); ++i) {
    Tracer<Real, AnyWorldView>& tracer =
        tracers.blur() ? tracers.of(round.before() + i) : tracers.first();
    const int point = shot.sampler.point(number, i);
    sampler_state.sample = static_cast<std::uint32_t>(round.before() + point);
    Ray<Real> ray;
    Mask<Real> active = pixels.active();
    redirect(tracer.view(), targets, pixels, aims(point), ray, active);
    const Vec3<Real> light = tracer.seen(tracer.light(ray, active, sampler_state), active);
    round.add(tracer, ray, active, light, i);
  }
  round.tell();
}

template <class Real, class AnyWorldView>
void trace_round(const Shot& shot, int round, Tracers<Real, AnyWorldView>& tracers,
                 TilePixels& tile) {
  std::vector<int>& unsettled = tile.unsettled;
  if (shot.guided && doubles(shot.sampler, round)) begin_half(tile);
  for (std::size_t begin = 0; begin < unsettled.size(); begin += Pixels<Real>::size) {
    Pixels<Real> pixels;
    pixels.count = std::min(Pixels<Real>::size, unsettled.size() - begin);
    for (std::size_t i = 0; i < Pixels<Real>::size; ++i) {
      const int pixel = unsettled[begin + (i < pixels.count ? i : 0)];
      pixels.estimates[i] = &tile.estimates[static_cast<std::size_t>(pixel)];
      if (!tile.parts.empty()) pixels.parts[i] = &tile.parts[static_cast<std::size_t>(pixel)];
      if (shot.guided) pixels.guided[i] = &tile.guided[static_cast<std::size_t>(pixel)];
      pixels.x[i] = static_cast<std::uint32_t>(tile.x0 + pixel % tile.width);
      pixels.y[i] = static_cast<std::uint32_t>(tile.y0 + pixel / tile.width);
      if (tile.targets.empty()) continue;
      const Target& target = tile.targets[static_cast<std::size_t>(pixel)];
      pixels.targets[i] = &target, pixels.x[i] = target.x, pixels.y[i] = target.y;
    }
    if (tracers.first().view().is_flat() && tile.targets.empty())
      trace_flat_round(shot, round, tracers, pixels);
    else trace_curved_round(shot, round, tracers, pixels);
  }
  if (!shot.convergence.watches()) return;
  std::erase_if(unsettled, [&](int pixel) {
    return shot.convergence.settle(tile.estimates[static_cast<std::size_t>(pixel)]);
  });
  if (shot.convergence.shows()) tile.error = shot.convergence.largest_error(tile.estimates);
}

template <class Real, class AnyWorldView>
void trace_rounds_in(const Shot& shot, int begin, int end, TilePixels& tile) {
  Tracers<Real, AnyWorldView> tracers(shot, tile);
  for (int round = begin; round < end && !tile.unsettled.empty(); ++round)
    trace_round(shot, round, tracers, tile);
  tile.rays += tracers.tell_rays();
}

// ---- which of them ------------------------------------------------------------------------------

// Calls trace with the scalar's type and that of the world's view. In worlds of few plain balls, as
// the thesis has, each ray is tried on all of them, without a tree.
template <class Trace>
void with_types(const Shot& shot, Scalar scalar, bool of_pixels, const Trace& trace) {
  const auto by_view = [&]<class Real>(std::type_identity<Real>) {
    const auto is_few = [](const Instant& at) {
      return at.world.few_balls && !at.view.is_clipped();
    };
    if (of_pixels && row_of(shot.integrator).is_whitted && !shot.guided &&
        std::ranges::all_of(shot.instants, is_few))
      return trace.template operator()<Real, FewBallsView>();
    return trace.template operator()<Real, WorldView>();
  };
  switch (scalar) {
    case Scalar::narrow: return by_view(std::type_identity<float>());
    case Scalar::exact: return by_view(std::type_identity<double>());
    case Scalar::wide: return by_view(std::type_identity<Wide>());
  }
}

// The pixels in the order of packets: packet by packet, each row by row.
std::vector<int> in_patches(int width, int height) {
  constexpr int w = PacketPixels<Wide>::width, h = PacketPixels<Wide>::height;
  std::vector<int> pixels;
  pixels.reserve(static_cast<std::size_t>(width * height));
  for (int y0 = 0; y0 < height; y0 += h)
    for (int x0 = 0; x0 < width; x0 += w)
      for (int y = y0; y < std::min(y0 + h, height); ++y)
        for (int x = x0; x < std::min(x0 + w, width); ++x) pixels.push_back(y * width + x);
  return pixels;
}

}  // namespace

void TilePixels::begin() {
  if (!estimates.empty()) return;
  estimates.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (has_parts) parts.resize(estimates.size());
  if (has_guides) guided.resize(estimates.size());
  unsettled = in_patches(width, height);
}

void trace_rounds(const Shot& shot, Scalar scalar, int first, int last, TilePixels& tile) {
  tile.begin();
  with_types(shot, scalar, tile.targets.empty(), [&]<class Real, class AnyWorldView>() {
    trace_rounds_in<Real, AnyWorldView>(shot, first, last, tile);
  });
}

void trace_centers(const Shot& shot, Scalar scalar, int x0, int y0, FilmTile& tile) {
  with_types(shot, scalar, true, [&]<class Real, class AnyWorldView>() {
    if (shot.first().view.is_flat())
      return trace_centers_in<Real, AnyWorldView>(shot, x0, y0, tile);
    trace_curved_centers_in<Real, AnyWorldView>(shot, x0, y0, tile);
  });
}

}  // namespace tia
