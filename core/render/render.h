// World -> picture: tiles over threads. A pixel depends on nothing but the world, the view and
// itself: not on threads, tile size, window or lanes.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "core/accel/world.h"
#include "core/film/image.h"
#include "core/render/pool.h"

namespace tia {

/// Window: the pixels x0 <= x < x1, y0 <= y < y1 of a picture.
struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool operator==(const Window&) const = default;
};

/// RayCounts: exact numbers of rays by kind; a shadow ray for each lamp and hit with n.l > 0.
struct RayCounts {
  std::int64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
  bool operator==(const RayCounts&) const = default;
};

/// The arithmetic of a render: `wide` is what pictures are made with, `narrow` gives the same bytes
/// one ray at a time, `exact` traces in double, for tests and explanations.
enum class Scalar { wide, narrow, exact };

struct RenderOptions {
  IntegratorName integrator = IntegratorName::thesis;
  int threads = 1;
  int tile = Block::size;  ///< pixels a side, at most Block::size
  Scalar scalar = Scalar::wide;
};

/// Traces the window and hands each finished block, in window coordinates, to `develop`, from
/// several threads at once, each pixel in exactly one block.
/// Errors: Stopped, between tiles, when `stop` is requested.
RayCounts render(const World& world, const View& view, const Window& window,
                 const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                 const std::function<void(const Block&)>& develop);

}  // namespace tia
