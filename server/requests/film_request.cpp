#include "server/requests/film_request.h"

namespace tia::server {

bool frames_have(std::string_view parameter) {
  for (const std::string_view other : {"time", "frame", "format", "budget_ms", "max_rays",
                                       "frame_ms", "depth_range", "aov", "depth"})
    if (parameter == other) return false;
  return true;
}

void FilmRequest::check(const Place& at, Faults& faults) const {
  PictureRequest::check(at, faults);
  if (from && to && *from >= *to)
    faults.add({FaultKind::conflict, at.at("to").pointer(), Value(*to), "a time after from"});
}

}  // namespace tia::server
