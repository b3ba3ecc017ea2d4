#include "core/scene/open_time.h"

#include <algorithm>
#include <array>

#include "core/scene/animation_target.h"

namespace tia {
namespace {

constexpr std::array<std::string_view, 6> once_a_frame{"title",         "description", "backdrop",
                                                       "shadow_ground", "sheet",       "options"};

bool is_of_the_frame(const Track& track) {
  const TargetPath steps = steps_of(track.target);
  return !steps.empty() && std::ranges::find(once_a_frame, steps.front()) != once_a_frame.end();
}

bool differs(const Animation& animation, const Track& track, double from, double to) {
  const double one = own_time(animation, track, from), other = own_time(animation, track, to);
  if (track.visible) return track.is_visible(one) != track.is_visible(other);
  const TrackTarget kind = kind_of_target(steps_of(track.target));
  const auto value = value_at(track, kind, one);
  return !value || value != value_at(track, kind, other);
}

}  // namespace

std::vector<double> stratum_times(const Animation& animation, double seconds, int steps) {
  const bool repeats = std::ranges::any_of(
      animation.tracks, [](const Track& track) { return track.repeat != KeyRepeat::once; });
  std::vector<double> times;
  for (int i = 0; i < steps; ++i) {
    const double from_middle = (i + 0.5) / steps - 0.5;
    const double time = seconds + animation.shutter / animation.fps * from_middle;
    times.push_back(repeats ? time : std::clamp(time, 0.0, animation.duration));
  }
  return times;
}

Scene exposed_scene(const Scene& moving, const Scene& frame) {
  Scene exposed = moving;
  exposed.title = frame.title;
  exposed.description = frame.description;
  exposed.backdrop = frame.backdrop;
  exposed.shadow_ground = frame.shadow_ground;
  exposed.sheet = frame.sheet;
  exposed.options = frame.options;
  std::erase_if(exposed.animation->tracks, is_of_the_frame);
  return exposed;
}

bool moves_within(const Animation& animation, const std::vector<double>& times) {
  return std::ranges::any_of(animation.tracks, [&](const Track& track) {
    return std::ranges::any_of(
        times, [&](double time) { return differs(animation, track, times.front(), time); });
  });
}

}  // namespace tia
