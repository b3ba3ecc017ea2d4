#include "core/render/render.h"

#include <algorithm>
#include <new>

#include "core/parallel/stopped.h"
#include "core/render/coarse_preview.h"
#include "core/render/denoised_window.h"
#include "core/render/gaze_picture.h"
#include "core/render/kept_rounds.h"
#include "core/render/out_of_budget.h"

namespace tia {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
HostLimits limits_of(const RenderOptions& options) { return {options.max_rays, options.max_work}; }

std::vector<Instant> in_worlds(Instants instants) {
  std::vector<Instant> seen;
  for (const auto& [world, view] : instants) seen.push_back({world, view.seen_from(world.origin)});
  return seen;
}

// Whether rounds have all that decides what comes of them in sums that are kept.
bool may_be_left(const RenderOptions& options, const DenoisedWindow* denoised) {
  return row_of(options.integrator).is_chance() && options.threshold == 0 && denoised == nullptr;
}
// What one with a budget has at the end of a round cannot be told of rounds beyond the budget.
bool may_go_on(const RenderOptions& options, const DenoisedWindow* denoised) {
  return options.from && may_be_left(options, denoised) &&
         (!options.budget || options.from->rays().all() <= options.budget->max_rays);
}

/// Render: one picture.
class Render {
 public:
  Render(Instants instants, const Window& window, const RenderOptions& options, Pool& pool,
         const std::stop_token& stop, DenoisedWindow* denoised = nullptr)
      : options_(options),
        tiles_(instants.front().world, window, options.integrator, options.tile,
               PoolShare{pool, options.threads, stop, options.flow}),
        instants_(in_worlds(instants)),
        sampler_({.samples = options.samples,
                  .threshold = options.threshold,
                  .seed = options.seed,
                  .is_chance = row_of(options.integrator).is_chance(),
                  .in_rounds = options.noise > 0 || options.budget,
                  .is_watched = is_watched() || denoised != nullptr || may_go_on(options, denoised),
                  .blur_steps = options.blur_steps}),
        convergence_(
            {options.threshold, options.noise, tells_errors(), options.tone, options.blur_steps}),
        meter_(options.budget ? no_limit : options.max_rays,
               options.budget ? no_limit : options.max_work, stop,
               spent_within(options.budget, options.spent, limits_of(options))),
        denoised_(denoised),
        shot_{instants_, options.integrator, rules_of(options),  sampler_, convergence_,
              meter_,    options.layers,     denoised != nullptr},
        preview_(tiles_, shot_, options.scalar, options.seed, options.spent, stop),
        from_(may_go_on(options, denoised) && options.from->fits(sampler_) &&
                      options.from->tiles() == static_cast<std::size_t>(tiles_.count())
                  ? options.from.get()
                  : nullptr) {
    if (from_ != nullptr) meter_.begin_at(before_ = from_->rays());
  }

  Rendered picture(const Develop& develop) {
    if (options_.gaze) return for_gaze(develop);
    if (denoised_ == nullptr) {
      if (from_ == nullptr || from_->samples() == 0) show_preview();
      return traced(develop);
    }
    const Rendered drawn = traced([&](const FilmTile& tile) { denoised_->put_alpha(tile); });
    develop_filtered([&] { return denoise(denoised_->halves(), tiles_.share().workers()); },
                     develop);
    return drawn;
  }
  /// To who watches. Of few pixels it would be no less than the first round, or than the picture.
  void show_preview() {
    if (is_watched() && (preview_.block() > 1 || (!has_rounds() && !sampler_.centered())))
      options_.watch({.is_preview = true,
                      .show = [this](const Develop& develop) { return preview_.show(develop); }});
  }

 private:
  bool has_rounds() const { return is_watched() && sampler_.rounds() > 1; }
  bool is_watched() const { return options_.watch != nullptr; }
  bool tells_errors() const {
    const bool known = is_watched() && options_.threshold == 0 && options_.samples > 1 &&
                       row_of(options_.integrator).is_chance();
    return known || options_.budget;
  }

  Rendered traced(const Develop& develop) {
    // A centred picture has no rounds.
    const bool by_rounds = !sampler_.centered() && (options_.budget || has_rounds());
    return by_rounds ? round_by_round(develop) : tile_by_tile(develop);
  }
  Rendered tile_by_tile(const Develop& develop) {
    try {
      tiles_.for_each_tile([&](int i, FilmTile& tile) {
        trace(i, tile);
        tiles_.hand_over(develop, tile);
      });
    } catch (const OutOfBudget& end) {
      refuse(end, limits_of(options_));
    }
    return told(meter_.counts(), tally_, options_.samples);
  }

  Rendered for_gaze(const Develop& develop) {
    GazePicture(tiles_, shot_, options_.scalar, *options_.gaze).draw(develop, tally_);
    return told(meter_.counts(), tally_, options_.samples);
  }

  // With a budget, or for who watches.
  Rendered round_by_round(const Develop& develop) {
    std::vector<RoundsOfTile> all;
    all.reserve(static_cast<std::size_t>(tiles_.count()));
    for (int i = 0; i < tiles_.count(); ++i) all.push_back(begun_tile(i));
    if (from_ == nullptr && is_first_filtered())
      first_.emplace(tiles_.window().width(), tiles_.window().height());
    try {
      return round_by_round(all, develop);
    } catch (const Stopped&) {
      leave(std::move(all));
      throw;
    }
  }
  Rendered round_by_round(std::vector<RoundsOfTile>& all, const Develop& develop) {
    int rounds = whole_rounds(all, sampler_.rounds());
    for (OpenTiles open = open_for(rounds, all); goes_on(open, rounds);
         open = open_for(rounds, all)) {
      if (rounds > 0 && is_watched()) show(all, rounds);
      if (!trace_round(open, rounds)) break;
      ++rounds;
    }
    develop_all(all, rounds, tally_, develop);
    const bool ended = std::ranges::all_of(all, &RoundsOfTile::settled);
    return told(rays_after(rounds, all), tally_,
                ended ? options_.samples : sampler_.before(rounds));
  }
  RoundsOfTile begun_tile(int i) const {
    if (from_ != nullptr) return from_->tile(static_cast<std::size_t>(i), sampler_);
    return RoundsOfTile(pixels_of(i));
  }
  void leave(std::vector<RoundsOfTile>&& all) const try {
    const auto has_begun = [](const RoundsOfTile& tile) { return tile.begun() > 0; };
    if (options_.leave && may_be_left(options_, denoised_) && std::ranges::any_of(all, has_begun))
      options_.leave(std::make_shared<const KeptRounds>(std::move(all), sampler_));
  } catch (const std::bad_alloc&) {  // then nothing is kept
  }

  TilePixels pixels_of(int i) const {
    FilmTile tile;
    return tiles_.pixels_of(tiles_.place(i, tile), shot_.parts_light(), shot_.guided);
  }

  void trace(int i, FilmTile& tile) {
    if (sampler_.centered() && !shot_.first().view.orthographic() && !tells_more_)
      return trace_centers(shot_, options_.scalar, tiles_.window().x0 + tile.x,
                           tiles_.window().y0 + tile.y, tile);
    RoundsOfTile begun = begun_tile(i);
    const int first = begun.begun();
    TilePixels pixels = std::move(begun).pixels();
    trace_rounds(shot_, options_.scalar, first, sampler_.rounds(), pixels);
    ShownTile shown = shown_of(pixels, options_.layers);
    if (convergence_.shows() || is_watched()) tally_.add(shown);
    fill(tile, std::move(shown));
    if (denoised_ != nullptr) denoised_->put(tile, halves_of(pixels));
  }

  // ---- by rounds ------------------------------------------------------------------------------

  // Whether there is a further round, and time for it.
  bool goes_on(const OpenTiles& open, int rounds) const {
    if (open.tiles.empty() || rounds == sampler_.rounds()) return false;
    if (!options_.budget || !sampler_.may_end_after(rounds)) return true;
    // A sample takes a ray at least: no round is begun of more samples than there are rays left.
    const std::int64_t samples = open.pixels * sampler_.count(rounds);
    if (meter_.counts().all() + samples > options_.budget->max_rays) return false;
    const std::int64_t done = meter_.counts().primary - before_.primary;
    if (done == 0) return options_.budget->has_time(0);
    return options_.budget->has_time(static_cast<double>(samples) / static_cast<double>(done));
  }

  // Returns: whether it came to its end.
  bool trace_round(const OpenTiles& open, int round) {
    try {
      tiles_.share().for_each(static_cast<int>(open.tiles.size()), [&](int i) {
        RoundsOfTile& tile = *open.tiles[static_cast<std::size_t>(i)];
        if (round == 0 && first_) trace_first(tile, i);
        else trace_round(shot_, tile, round);
      });
    } catch (const OutOfBudget& end) {
      if (!sampler_.may_end_after(round)) refuse(end, limits_of(options_));
      return false;
    }
    return true;
  }

  void trace_round(const Shot& shot, RoundsOfTile& tile, int round) const {
    if (options_.leave) tile.trace_or_leave(shot, options_.scalar, round);
    else tile.trace(shot, options_.scalar, round);
  }

  // For a preview what guides tell is put beside the light, tile by tile.
  void trace_first(RoundsOfTile& tile, int i) {
    Shot guided = shot_;
    guided.guided = true;
    FilmTile at;
    tile.guide();
    trace_round(guided, tile, 0);
    tile.put(tiles_.place(i, at), *first_);
    tile.unguide();
  }

  void develop_all(std::vector<RoundsOfTile>& all, int rounds, Tally& tally, const Develop& develop,
                   const PreviewLight* light = nullptr) {
    const auto shown_of_tile = [&](int i, const FilmTile& tile) -> const ShownTile& {
      RoundsOfTile& of_tile = all[static_cast<std::size_t>(i)];
      const ShownTile& shown = of_tile.after(rounds, options_.layers);
      tally.add(shown);
      if (denoised_ != nullptr) denoised_->put(tile, of_tile.halves());
      return shown;
    };
    tiles_.hand_over(develop, shown_of_tile, light);
  }
  // The window's part of what `filter` makes of what has been traced.
  template <class Filter>
  void develop_filtered(const Filter& filter, const Develop& develop) {
    Image light;
    tiles_.share().workers().alone([&] { light = filter(); });
    denoised_->develop(light, tiles_.share().workers(),
                       [&](FilmTile& tile) { tiles_.hand_over(develop, tile); });
  }

  void show(std::vector<RoundsOfTile>& all, int rounds) {
    const int samples = sampler_.before(rounds);
    const bool quickly = samples == 1 || (denoised_ != nullptr && !is_worth_denoising());
    options_.watch({quickly, rays_after(rounds, all), before_, [&](const Develop& develop) {
                      Tally tally;
                      if (denoised_ != nullptr) show_denoised(all, rounds, quickly, tally, develop);
                      else show_plainly(all, rounds, tally, develop);
                      return tally.reached(samples);
                    }});
    first_.reset();
  }
  void show_plainly(std::vector<RoundsOfTile>& all, int rounds, Tally& tally,
                    const Develop& develop) {
    if (first_) tiles_.share().workers().alone([&] { first_->filter(tiles_.share().workers()); });
    develop_all(all, rounds, tally, develop, first_ ? &*first_ : nullptr);
  }
  void show_denoised(std::vector<RoundsOfTile>& all, int rounds, bool quickly, Tally& tally,
                     const Develop& develop) {
    develop_all(all, rounds, tally, [&](const FilmTile& tile) { denoised_->put_alpha(tile); });
    if (!quickly)
      return develop_filtered(
          [&] { return denoise(denoised_->halves(), tiles_.share().workers()); }, develop);
    PreviewLight light(tiles_.window().width(), tiles_.window().height());
    tiles_.for_each_tile(
        [&](int i, const FilmTile& tile) { all[static_cast<std::size_t>(i)].put(tile, light); });
    develop_filtered([&] { return light.filter(tiles_.share().workers()); }, develop);
  }
  // So much light has been traced that to denoise what there is costs little of the time. As rounds
  // double, all such together cost no more than half of what the first of them costs.
  bool is_worth_denoising() const {
    constexpr std::int64_t rays_a_pixel = 256;
    return meter_.counts().all() >= rays_a_pixel * tiles_.pixels();
  }

  bool is_first_filtered() const {
    return is_watched() && denoised_ == nullptr && preview_.is_filtered() &&
           sampler_.before(1) == 1 && tiles_.pixels() <= PreviewLight::most_pixels;
  }

  Rendered told(const RayCounts& rays, const Tally& tally, int samples) const {
    if (!convergence_.shows() && !is_watched()) return {rays, {}, before_};
    if (sampler_.centered()) return {rays, Reached{1, 1, 1, 1, 1}};
    return {rays, tally.reached(samples), before_};
  }

  const RenderOptions& options_;
  const WindowTiles tiles_;
  const std::vector<Instant> instants_;  // in the worlds' spaces
  const Sampler sampler_;
  const Convergence convergence_;
  RayMeter meter_;
  Tally tally_;
  DenoisedWindow* const denoised_;     // null: it is shown as it is
  std::optional<PreviewLight> first_;  // of the first round, until it is shown
  const Shot shot_;
  const CoarsePreview preview_;
  const KeptRounds* const from_;  // null: from the beginning
  RayCounts before_ = {};         // the rays of that
  const bool tells_more_ = options_.layers.any([](const LayerRow& row) { return row.is_beside(); });
};

// The first preview needs no margin.
Rendered render_denoised(Instants instants, const Window& window, const RenderOptions& options,
                         Pool& pool, const std::stop_token& stop, const Develop& develop) {
  if (options.watch) Render(instants, window, options, pool, stop).show_preview();
  const View& view = instants.front().view;
  DenoisedWindow denoised(window, view.width, view.height);
  return Render(instants, denoised.traced(), options, pool, stop, &denoised).picture(develop);
}

}  // namespace

Rendered render(Instants instants, const Window& window, const RenderOptions& options, Pool& pool,
                const std::stop_token& stop, const Develop& develop) {
  if (options.denoise) return render_denoised(instants, window, options, pool, stop, develop);
  return Render(instants, window, options, pool, stop).picture(develop);
}

}  // namespace tia
