// Pure checks of what a picture may cost, before anything is traced.
#pragma once

#include <cstdint>

#include "core/input/errors.h"

namespace tia {

/// Limits: what one request may ask for.
struct Limits {
  std::int64_t max_pixels = 16'777'216;    ///< pixels of the whole picture
  std::int64_t max_rays = 2'000'000'000;   ///< rays of all kinds, of the window that is drawn
  std::int64_t max_work = 10'000'000'000;  ///< tests of boxes and surfaces (WorkCounter)
  std::int64_t max_events = 1'000'000;     ///< of a motion: collisions, or steps of its bodies
  int max_frames = 3600;                   ///< of a film
};

/// Errors: InputError of one `limit` fault that names the limit and the option that sets it.
void check_size(std::int64_t width, std::int64_t height, const Limits& limits);
/// Of the rays that a window takes at least: its pixels times the samples of each.
void check_rays(std::int64_t pixels, std::int64_t samples, const Limits& limits);
/// What a request for too many rays is refused with, before tracing or while it goes on.
InputError too_many_rays(const std::string& got, std::int64_t max_rays);
/// The same where most of them are mirrored or refracted.
InputError too_many_children(std::int64_t max_rays);
/// What a request is refused with whose rays would be tried on too much.
InputError too_much_work(std::int64_t max_work);

}  // namespace tia
