#include "core/render/render.h"

#include <algorithm>
#include <atomic>

#include "core/integrators/integrator.h"

namespace tia {
namespace {

// Fills the block's pixels, whose corner is pixel (x0, y0) of the picture.
template <class Real>
[[gnu::flatten]] void trace_block(const World& world, const View& view, IntegratorName integrator,
                                  int x0, int y0, Block& block, RayTally& rays) {
  constexpr int n = lanes<Real>;
  const std::vector<int> objects =
      candidates(world, Beam(view, x0, y0, x0 + block.width, y0 + block.height));
  const Real lane_index = iota<Real>();
  const Real width(static_cast<float>(block.width));
  const Vec3<Real> origin = lift<Real>(view.origin);
  std::array<Vec3<Real>, Block::size / n> columns;
  for (int x = 0; x < block.width; x += n)
    columns[static_cast<std::size_t>(x / n)] =
        view.column(Real(static_cast<float>(x0 + x)) + lane_index);

  for (int y = 0; y < block.height; ++y) {
    const Vec3<Real> row = view.row(Real(static_cast<float>(y0 + y)));
    for (int x = 0; x < block.width; x += n) {
      const Real in_block = Real(static_cast<float>(x)) + lane_index;
      const Ray<Real> ray{origin, normalize(columns[static_cast<std::size_t>(x / n)] + row)};
      const Vec3<Real> light = radiance(integrator, world, objects, ray, in_block < width, rays);
      const auto i = static_cast<std::size_t>(y * Block::size + x);
      store(light.x, &block.r[i]);
      store(light.y, &block.g[i]);
      store(light.z, &block.b[i]);
    }
  }
}

auto tracer_for(Scalar scalar) {
  switch (scalar) {
    case Scalar::narrow: return trace_block<float>;
    case Scalar::exact: return trace_block<double>;
    case Scalar::wide: break;
  }
  return trace_block<Wide>;
}

}  // namespace

RayCounts render(const World& world, const View& view, const Window& window,
                 const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                 const std::function<void(const Block&)>& develop) {
  const int tile = options.tile;
  const int columns = (window.width() + tile - 1) / tile;
  const int rows = (window.height() + tile - 1) / tile;
  const auto trace = tracer_for(options.scalar);
  std::atomic<std::int64_t> primary = 0, shadow = 0;

  pool.for_each(columns * rows, options.threads, stop, [&](int i) {
    Block block;
    block.x = i % columns * tile;
    block.y = i / columns * tile;
    block.width = std::min(tile, window.width() - block.x);
    block.height = std::min(tile, window.height() - block.y);
    RayTally rays;
    trace(world, view, options.integrator, window.x0 + block.x, window.y0 + block.y, block, rays);
    develop(block);
    primary += rays.primary;
    shadow += rays.shadow;
  });
  return {.primary = primary, .shadow = shadow};
}

}  // namespace tia
