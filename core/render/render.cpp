#include "core/render/render.h"

#include <algorithm>

namespace tia {

RayCounts render(const World& world, const View& view, const Window& window,
                 const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                 const std::function<void(const FilmTile&)>& develop) {
  const int side = options.tile;
  const int columns = (window.width() + side - 1) / side;
  const int rows = (window.height() + side - 1) / side;
  const Sampler sampler(options.samples, options.threshold, options.seed);
  RayMeter meter(options.max_rays, options.max_work, stop, options.spent);
  const View in_world = view.seen_from(world.origin);
  const Rules rules = rules_of(options.integrator, options.max_depth, options.ao_radius);
  const Shot shot{world, in_world, options.integrator, rules, sampler, meter};

  pool.for_each(
      columns * rows, options.threads, stop,
      [&](int i) {
        FilmTile tile;
        tile.x = i % columns * side;
        tile.y = i / columns * side;
        tile.width = std::min(side, window.width() - tile.x);
        tile.height = std::min(side, window.height() - tile.y);
        trace_tile(shot, options.scalar, window.x0 + tile.x, window.y0 + tile.y, tile);
        develop(tile);
      },
      options.flow);
  return meter.counts();
}

}  // namespace tia
