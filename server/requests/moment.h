// Which time of an animated scene is meant.
#pragma once

#include <optional>

#include "core/scene/animation.h"

namespace tia::server {

/// Moment: a time, or a frame, which is at frame / fps; else the time 0.
struct Moment {
  static constexpr std::string_view schema_name = "moment";
  std::optional<double> time;
  std::optional<int> frame;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("time", &Moment::time,
          Spec{.about = "the time of a scene that moves, from 0 to its duration; else 0",
               .unit = "s",
               .min = 0,
               .max = 86400});
    visit("frame", &Moment::frame,
          Spec{.about = "the frame of a scene that moves instead: frame k is at time k / fps",
               .min = 0,
               .max = Animation::most_frames - 1});
  }
  /// time with frame.
  void check(const Place& at, Faults& faults) const;
  bool is_asked() const { return time || frame; }
  /// Seconds. Errors: InputError at /time or /frame beyond the animation's end.
  double seconds_in(const Animation& animation) const;
};

}  // namespace tia::server
