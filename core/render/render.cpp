#include "core/render/render.h"

#include <algorithm>

namespace tia {

RayCounts render(const World& world, const View& view, const Window& window,
                 const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                 const std::function<void(const Block&)>& develop) {
  const int tile = options.tile;
  const int columns = (window.width() + tile - 1) / tile;
  const int rows = (window.height() + tile - 1) / tile;
  const Sampler sampler(options.samples, options.threshold, options.seed);
  RayMeter meter(options.max_rays, options.max_work, stop, options.spent);
  const View in_world = view.seen_from(world.origin);
  const Shot shot{world, in_world, options.integrator, options.max_depth, sampler, meter};

  pool.for_each(
      columns * rows, options.threads, stop,
      [&](int i) {
        Block block;
        block.x = i % columns * tile;
        block.y = i / columns * tile;
        block.width = std::min(tile, window.width() - block.x);
        block.height = std::min(tile, window.height() - block.y);
        trace_block(shot, options.scalar, window.x0 + block.x, window.y0 + block.y, block);
        develop(block);
      },
      options.flow);
  return meter.counts();
}

}  // namespace tia
