// A picture that has been drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/render/render.h"
#include "server/operation/timing.h"

namespace tia::server {

/// Picture: the bytes of an image file and what they cost.
struct Picture {
  std::string bytes;
  std::string_view media_type;
  RayCounts rays;
  std::int64_t rays_before = 0;  ///< of these, what a drawing had traced that was left
  Timing timing;
  std::optional<Reached> reached = {};  ///< of rounds, where somebody wanted to know
  bool tells_reached = false;  ///< whether answers tell: where noise or a budget was asked for
  bool tells_noise = false;    ///< whether `reached` has the noise, too
  std::string etag = {};  ///< its tag, where only its drawing could tell; else it was known before
  std::size_t degenerate = 0;  ///< triangles without area, which were left out
  std::size_t unasked = 0;     ///< luminous objects whose light is met by chance alone
  double trace_seconds = 0;    ///< of all threads that traced it
};

}  // namespace tia::server
