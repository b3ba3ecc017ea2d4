#include "server/requests/moment.h"

namespace tia::server {

void Moment::check(const Place& at, Faults& faults) const {
  if (time && frame)
    faults.add({FaultKind::conflict, at.at("frame").pointer(), Value(*frame), "time or frame"});
}

double Moment::seconds_in(const Animation& animation) const {
  const auto refuse = [](const char* pointer, double got, const Spec& spec, bool integer) {
    throw InputError({FaultKind::out_of_range, pointer, Value(got), range_text(spec, integer)});
  };
  const double last_frame = animation.frames() - 1;
  if (frame && *frame > last_frame) refuse("/frame", *frame, {.min = 0, .max = last_frame}, true);
  if (time && *time > animation.duration)
    refuse("/time", *time, {.unit = "s", .min = 0, .max = animation.duration}, false);
  if (frame) return *frame / animation.fps;
  return time.value_or(0);
}

}  // namespace tia::server
