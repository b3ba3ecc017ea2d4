#include "core/render/trace_tile.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/integrators/integrator.h"
#include "core/integrators/whitted.h"
#include "core/render/packet_pixels.h"

namespace tia {
namespace {

// One tile's rays through a world view.
template <class Real, class AnyWorldView>
class Tracer {
 public:
  Tracer(const Shot& shot, int x0, int y0, const FilmTile& tile)
      : eye(shot.view), shot_(shot), world_view_{world_view_of(shot, x0, y0, tile)} {}

  Vec3<Real> light(const Ray<Real>& ray, Mask<Real> active,
                   const SamplerState<Real>& sampler_state) {
    if constexpr (std::is_same_v<AnyWorldView, FewBallsView>)
      return whitted(world_view_, ray, active, sampler_state);
    else return radiance(shot_.integrator, world_view_, ray, active, sampler_state);
  }
  RayCounts& rays() { return world_view_.rays; }

  Eye<Real> eye;

 private:
  // A tree of rays may become very large, so its rays are counted while they are traced.
  void spent(std::int64_t work) {
    shot_.meter.add_work(work);
    shot_.meter.add(rays());
  }
  AnyWorldView world_view_of(const Shot& shot, int x0, int y0, const FilmTile& tile) {
    if constexpr (std::is_same_v<AnyWorldView, FewBallsView>) {
      const Beam beam(shot.view, x0, y0, x0 + tile.width, y0 + tile.height);
      return {shot.world, candidates(shot.world, beam)};
    } else {
      return {shot.world, WorkCounter([this](std::int64_t work) { spent(work); }), shot.rules};
    }
  }

  const Shot& shot_;
  AnyWorldView world_view_;
};

// ---- one ray a pixel of a perspective view, as for most pictures --------------------------------

template <class Real, class AnyWorldView>
[[gnu::flatten]] void trace_centers(const Shot& shot, int x0, int y0, FilmTile& tile) {
  using PacketPixels = tia::PacketPixels<Real>;
  constexpr bool draws_much = std::is_same_v<AnyWorldView, WorldView>;
  SamplerState<Real> sampler_state;
  sampler_state.key = shot.sampler.key();
  Tracer<Real, AnyWorldView> tracer(shot, x0, y0, tile);
  const Vec3<Real> origin = lift<Real>(shot.view.origin);
  const Real column_of = PacketPixels::column(), row_of = PacketPixels::row();
  const auto number = [](int i) { return Real(static_cast<float>(i)); };
  std::array<Vec3<Real>, FilmTile::size / PacketPixels::width> columns;
  for (int x = 0; x < tile.width; x += PacketPixels::width)
    columns[static_cast<std::size_t>(x / PacketPixels::width)] =
        shot.view.column(number(x0 + x) + column_of);

  for (int y = 0; y < tile.height; y += PacketPixels::height) {
    const Vec3<Real> row = shot.view.row(number(y0 + y) + row_of);
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
    }
  }
  shot.meter.add(tracer.rays());
}

// ---- many rays a pixel --------------------------------------------------------------------------

// The sums over a pixel's rays so far. Deviations are those of the light, clamped to [0,1], from
// that of the first ray, so that their squares do not vanish in the rounding of the sums.
struct Estimate {
  Vec3d light{}, deviations{}, squares{};
  Vec3f first{};
  int count = 0;

  bool settled(const Sampler& sampler) const {
    return sampler.settled(deviations.x, squares.x, count) &&
           sampler.settled(deviations.y, squares.y, count) &&
           sampler.settled(deviations.z, squares.z, count);
  }
};

// Several pixels of a tile, one in each lane; the first one again in the lanes left over.
template <class Real>
struct Pixels {
  static constexpr auto size = static_cast<std::size_t>(lanes<Real>);
  std::size_t count = 0;
  std::array<Estimate*, size> estimates{};
  typename Aims<Real>::Pixels x{}, y{};

  Mask<Real> active() const { return iota<Real>() < Real(static_cast<float>(count)); }
  Vec3<Real> first() const {
    return {lanes_of([&](std::size_t i) { return estimates[i]->first.x; }),
            lanes_of([&](std::size_t i) { return estimates[i]->first.y; }),
            lanes_of([&](std::size_t i) { return estimates[i]->first.z; })};
  }
  Vec3<Real> center(const View& view) const {
    return view.column(lanes_of([&](std::size_t i) { return static_cast<float>(x[i]); })) +
           view.row(lanes_of([&](std::size_t i) { return static_cast<float>(y[i]); }));
  }
  // Calls to(estimate, vector) with each pixel's lane of a vector.
  template <class To>
  void scatter(const Vec3<Precise<Real>>& from, To to) const {
    std::array<double, size> vx, vy, vz;
    store(from.x, vx.data());
    store(from.y, vy.data());
    store(from.z, vz.data());
    for (std::size_t i = 0; i < count; ++i) to(*estimates[i], Vec3d{vx[i], vy[i], vz[i]});
  }

 private:
  template <class F>
  static Real lanes_of(F value) {
    std::array<LaneOf<Real>, size> each;
    for (std::size_t i = 0; i < size; ++i) each[i] = value(i);
    return load<Real>(each.data());
  }
};

// The sums of one round of some pixels.
template <class Real>
struct Sums {
  using P = Precise<Real>;
  Vec3<P> light{P(0), P(0), P(0)}, deviations = light, squares = light;

  void add(const Vec3<Real>& sample) { light = light + widen(sample); }
  void add_deviation(const Vec3<Real>& clamped, const Vec3<Real>& first) {
    const Vec3<P> deviation = widen(clamped - first);
    deviations = deviations + deviation;
    squares = squares + deviation * deviation;
  }
};

template <class Real>
Vec3<Real> clamped(const Vec3<Real>& v) {
  const auto clamp = [](const Real& x) { return min_of(max_of(x, Real(0)), Real(1)); };
  return {clamp(v.x), clamp(v.y), clamp(v.z)};
}

template <class Real, class AnyWorldView>
[[gnu::flatten]] void trace_round(const Shot& shot, int round, Tracer<Real, AnyWorldView>& tracer,
                                  const Pixels<Real>& pixels) {
  Aims<Real> aims(shot.sampler, round, pixels.x, pixels.y, shot.view.has_lens());
  const Vec3<Real> center = pixels.center(shot.view);
  const Mask<Real> active = pixels.active();
  const int count = shot.sampler.strata(round).count();
  Vec3<Real> first = pixels.first();
  SamplerState<Real> sampler_state{pixels.x, pixels.y, 0, shot.sampler.key()};
  Sums<Real> sums;
  for (int i = 0; i < count; ++i) {
    sampler_state.sample = static_cast<std::uint32_t>(shot.sampler.before(round) + i);
    const Vec3<Real> light = tracer.light(tracer.eye.ray(center, aims(i)), active, sampler_state);
    sums.add(light);
    if (shot.sampler.adaptive()) {
      const Vec3<Real> shown = clamped(light);
      if (round == 0 && i == 0) first = shown;
      sums.add_deviation(shown, first);
    }
    shot.meter.add_if_many(tracer.rays());
  }
  pixels.scatter(sums.light, [&](Estimate& e, const Vec3d& v) {
    e.light = e.light + v;
    e.count += count;
  });
  if (!shot.sampler.adaptive()) return;
  pixels.scatter(widen(first), [](Estimate& e, const Vec3d& v) { e.first = Vec3f(v); });
  pixels.scatter(sums.deviations,
                 [](Estimate& e, const Vec3d& v) { e.deviations = e.deviations + v; });
  pixels.scatter(sums.squares, [](Estimate& e, const Vec3d& v) { e.squares = e.squares + v; });
}

// The pixels' means.
void develop(const std::vector<Estimate>& estimates, FilmTile& tile) {
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const Estimate& estimate = estimates[i];
    const int x = static_cast<int>(i) % tile.width, y = static_cast<int>(i) / tile.width;
    const std::size_t at = FilmTile::index(x, y);
    tile.r[at] = static_cast<float>(estimate.light.x / estimate.count);
    tile.g[at] = static_cast<float>(estimate.light.y / estimate.count);
    tile.b[at] = static_cast<float>(estimate.light.z / estimate.count);
  }
}

// The tile's pixels, patch by patch.
template <class Real>
std::vector<int> in_patches(const FilmTile& tile) {
  constexpr int w = PacketPixels<Real>::width, h = PacketPixels<Real>::height;
  std::vector<int> pixels(static_cast<std::size_t>(tile.width * tile.height));
  std::iota(pixels.begin(), pixels.end(), 0);
  const auto place = [&](int pixel) {
    const int x = pixel % tile.width, y = pixel / tile.width;
    return std::tuple(y / h, x / w, pixel);
  };
  std::ranges::sort(pixels, {}, place);
  return pixels;
}

template <class Real, class AnyWorldView>
void trace_samples(const Shot& shot, int x0, int y0, FilmTile& tile) {
  Tracer<Real, AnyWorldView> tracer(shot, x0, y0, tile);
  std::vector<Estimate> estimates(static_cast<std::size_t>(tile.width * tile.height));
  std::vector<int> unsettled = in_patches<Real>(tile);
  for (int round = 0; round < shot.sampler.rounds() && !unsettled.empty(); ++round) {
    for (std::size_t begin = 0; begin < unsettled.size(); begin += Pixels<Real>::size) {
      Pixels<Real> pixels;
      pixels.count = std::min(Pixels<Real>::size, unsettled.size() - begin);
      for (std::size_t i = 0; i < Pixels<Real>::size; ++i) {
        const int pixel = unsettled[begin + (i < pixels.count ? i : 0)];
        pixels.estimates[i] = &estimates[static_cast<std::size_t>(pixel)];
        pixels.x[i] = static_cast<std::uint32_t>(x0 + pixel % tile.width);
        pixels.y[i] = static_cast<std::uint32_t>(y0 + pixel / tile.width);
      }
      trace_round(shot, round, tracer, pixels);
    }
    std::erase_if(unsettled, [&](int pixel) {
      return estimates[static_cast<std::size_t>(pixel)].settled(shot.sampler);
    });
  }
  shot.meter.add(tracer.rays());
  develop(estimates, tile);
}

template <class Real, class AnyWorldView>
void trace(const Shot& shot, int x0, int y0, FilmTile& tile) {
  if (shot.sampler.centered() && !shot.view.orthographic())
    trace_centers<Real, AnyWorldView>(shot, x0, y0, tile);
  else trace_samples<Real, AnyWorldView>(shot, x0, y0, tile);
}

// In worlds of few plain balls, as the thesis has, each ray is tried on all of them, without a
// tree.
template <class Real>
void trace(const Shot& shot, int x0, int y0, FilmTile& tile) {
  if (shot.world.few_balls && row_of(shot.integrator).is_whitted)
    trace<Real, FewBallsView>(shot, x0, y0, tile);
  else trace<Real, WorldView>(shot, x0, y0, tile);
}

}  // namespace

void trace_tile(const Shot& shot, Scalar scalar, int x0, int y0, FilmTile& tile) {
  switch (scalar) {
    case Scalar::narrow: return trace<float>(shot, x0, y0, tile);
    case Scalar::exact: return trace<double>(shot, x0, y0, tile);
    case Scalar::wide: return trace<Wide>(shot, x0, y0, tile);
  }
}

}  // namespace tia
