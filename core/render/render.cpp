#include "core/render/render.h"

#include <algorithm>

#include "core/render/rounds.h"

namespace tia {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

/// OutOfBudget: thrown within a round, which then does not count.
struct OutOfBudget {
  enum { time, rays, limit_of_rays, limit_of_work } what;
};

// Ends a round that goes beyond the budget. What the host allows at most is one, too, where there
// is one: who asks for as much as there is time for is given that.
Spent spent_of(const RenderOptions& options) {
  if (!options.budget) return options.spent;
  return [&options](std::int64_t rays, std::int64_t tests) {
    if (options.spent) options.spent(rays, tests);
    if (rays > options.budget->max_rays) throw OutOfBudget{OutOfBudget::rays};
    if (rays > options.max_rays) throw OutOfBudget{OutOfBudget::limit_of_rays};
    if (tests > options.max_work) throw OutOfBudget{OutOfBudget::limit_of_work};
    if (!options.budget->has_time(0)) throw OutOfBudget{OutOfBudget::time};
  };
}

[[noreturn]] void refuse(const OutOfBudget& end, const RenderOptions& options) {
  switch (end.what) {
    case OutOfBudget::time: throw BudgetSpent(BudgetSpent::Of::time);
    case OutOfBudget::rays: throw BudgetSpent(BudgetSpent::Of::rays);
    case OutOfBudget::limit_of_rays: throw too_many_rays("a first round of more", options.max_rays);
    case OutOfBudget::limit_of_work: break;
  }
  throw too_much_work(options.max_work);
}

/// Render: one picture.
class Render {
 public:
  using Develop = std::function<void(const FilmTile&)>;

  Render(const World& world, const View& view, const Window& window, const RenderOptions& options,
         Pool& pool, const std::stop_token& stop)
      : options_(options),
        window_(window),
        pool_(pool),
        stop_(stop),
        in_world_(view.seen_from(world.origin)),
        sampler_({.samples = options.samples,
                  .threshold = options.threshold,
                  .seed = options.seed,
                  .is_chance = row_of(options.integrator).is_chance(),
                  .in_rounds = options.noise > 0 || options.budget}),
        convergence_({options.threshold, options.noise, options.budget.has_value(), options.tone}),
        meter_(options.budget ? no_limit : options.max_rays,
               options.budget ? no_limit : options.max_work, stop, spent_of(options)),
        shot_{world,        in_world_, options.integrator, rules_of(options), sampler_,
              convergence_, meter_,    options.layers} {}

  Rendered tile_by_tile(const Develop& develop) {
    try {
      for_each(tiles(), [&](int i) {
        FilmTile tile;
        place(i, tile);
        trace(tile);
        lay_under(tile);
        develop(tile);
      });
    } catch (const OutOfBudget& end) {
      refuse(end, options_);
    }
    return told(meter_.counts(), options_.samples);
  }

  // With a budget. A centred picture has no rounds.
  Rendered by_rounds(const Develop& develop) {
    if (sampler_.centered()) return tile_by_tile(develop);
    std::vector<RoundsOfTile> all;
    all.reserve(static_cast<std::size_t>(tiles()));
    for (int i = 0; i < tiles(); ++i) all.emplace_back(pixels_of(i));
    int rounds = 0;
    RayCounts rays;
    while (trace_round(all, rounds)) {
      ++rounds;
      rays = meter_.counts();
    }
    for_each(tiles(), [&](int i) {
      FilmTile tile;
      place(i, tile);
      const ShownTile& shown = all[static_cast<std::size_t>(i)].after(rounds, options_.layers);
      tally_.add(shown.pixels);
      fill(tile, shown);
      lay_under(tile);
      develop(tile);
    });
    const bool ended = std::ranges::all_of(all, &RoundsOfTile::settled);
    return told(rays, ended ? options_.samples : sampler_.before(rounds));
  }

 private:
  int columns() const { return (window_.width() + options_.tile - 1) / options_.tile; }
  int tiles() const { return columns() * ((window_.height() + options_.tile - 1) / options_.tile); }
  void place(int i, FilmTile& tile) const {
    tile.x = i % columns() * options_.tile;
    tile.y = i / columns() * options_.tile;
    tile.width = std::min(options_.tile, window_.width() - tile.x);
    tile.height = std::min(options_.tile, window_.height() - tile.y);
  }
  TilePixels pixels_of(const FilmTile& tile) const {
    return {window_.x0 + tile.x, window_.y0 + tile.y, tile.width, tile.height, shot_.parts_light()};
  }
  TilePixels pixels_of(int i) const {
    FilmTile tile;
    place(i, tile);
    return pixels_of(tile);
  }
  void for_each(int count, const std::function<void(int)>& task) {
    pool_.for_each(count, options_.threads, stop_, task, options_.flow);
  }

  void trace(FilmTile& tile) {
    if (sampler_.centered() && !in_world_.orthographic() && !tells_more_)
      return trace_centers(shot_, options_.scalar, window_.x0 + tile.x, window_.y0 + tile.y, tile);
    TilePixels pixels = pixels_of(tile);
    trace_rounds(shot_, options_.scalar, 0, sampler_.rounds(), pixels);
    ShownTile shown = shown_of(pixels, options_.layers);
    if (convergence_.shows()) tally_.add(shown.pixels);
    fill(tile, std::move(shown));
  }

  // The colour of a backdrop that shadows fall on.
  void lay_under(FilmTile& tile) const {
    const World& world = shot_.world;
    if (!world.ground || world.backdrop->is_transparent() || !gathers_light(shot_.integrator))
      return;
    const Vec3f color = lift<float>(rgb_of(*world.backdrop->color));
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) {
        const std::size_t i = FilmTile::index(x, y);
        const float free = 1 - tile.alpha[i];
        tile.r[i] += color.x * free, tile.g[i] += color.y * free, tile.b[i] += color.z * free;
      }
  }

  // Returns: whether there was a round to be traced, and it came to its end.
  bool trace_round(std::vector<RoundsOfTile>& all, int round) {
    std::vector<RoundsOfTile*> open;
    std::int64_t pixels = 0;
    for (RoundsOfTile& tile : all) {
      if (tile.settled()) continue;
      open.push_back(&tile);
      pixels += tile.unsettled();
    }
    if (open.empty() || round == sampler_.rounds()) return false;
    const double more = static_cast<double>(pixels * sampler_.count(round)) /
                        static_cast<double>(std::max<std::int64_t>(meter_.counts().primary, 1));
    if (round > 0 && !options_.budget->has_time(more)) return false;
    try {
      for_each(static_cast<int>(open.size()), [&](int i) {
        open[static_cast<std::size_t>(i)]->trace(shot_, options_.scalar, round);
      });
    } catch (const OutOfBudget& end) {
      if (round == 0) refuse(end, options_);
      return false;
    }
    return true;
  }

  Rendered told(const RayCounts& rays, int samples) {
    if (!convergence_.shows()) return {rays};
    if (sampler_.centered()) return {rays, Reached{1, 1, 1, 1, 1}};
    return {rays, tally_.reached(samples)};
  }

  const RenderOptions& options_;
  const Window window_;
  Pool& pool_;
  const std::stop_token& stop_;
  const View in_world_;
  const Sampler sampler_;
  const Convergence convergence_;
  RayMeter meter_;
  Tally tally_;
  const Shot shot_;
  const bool tells_more_ = options_.layers.any([](const LayerRow& row) { return row.is_beside(); });
};

}  // namespace

Rendered render(const World& world, const View& view, const Window& window,
                const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                const std::function<void(const FilmTile&)>& develop) {
  Render render(world, view, window, options, pool, stop);
  return options.budget ? render.by_rounds(develop) : render.tile_by_tile(develop);
}

}  // namespace tia
