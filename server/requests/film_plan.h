// A film whose frames have all been checked: what is to be drawn, and when it is shown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/requests/film_request.h"
#include "server/requests/render_context.h"

namespace tia::server {

/// Shot: frames in a row that show one picture.
struct Shot {
  int first = 0, frames = 0;
  std::string etag;  ///< of the picture, as /render has it
};

/// FilmPlan. Frame k of it is at (first + k) / fps.
struct FilmPlan {
  KnownScene scene;  ///< in motion; it may be the request's own, and lives no longer
  double fps = 24;
  int first = 0, frames = 1;
  bool moves = true;  ///< the scene has an animation; else it is one frame
  int width = 0, height = 0;
  bool is_transparent = false;
  std::vector<Shot> shots;
  std::string etag;  ///< of the film
  double rays = 0;   ///< that its pictures are sure to take together

  double seconds_of(int frame) const { return (first + frame) / fps; }
  /// From the film's beginning to that frame, to the nearest thousandth: the last one's end is the
  /// film's duration, however the frames between are rounded. Unit: ms.
  std::int64_t ms_until(int frame) const;
};

/// Finds the picture of every frame, and draws none.
/// Errors: as plan_of, at the first frame that has any, whose time a fault of its animation tells;
/// InputError: more frames than `max_frames`, more rays together than `max_rays`, no frame, a frame
/// of another size or kind than the first.
FilmPlan film_plan_of(FilmRequest& asked, const RenderContext& context, const Requester& requester);

}  // namespace tia::server
