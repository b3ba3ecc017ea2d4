// What a track comes to at a time.
#pragma once

#include <optional>

#include "core/scene/animation.h"

namespace tia {

/// TrackTarget: what the value is of, as far as it matters to what is between keys.
enum class TrackTarget { numbers, color, quaternion };

/// The value at a time, none where the formula is not defined there. At a key it is the key's own.
/// Domain: a track without faults that has keys or a formula.
std::optional<Value> value_at(const Track& track, TrackTarget target, double seconds);

/// The time at which a track is asked for at a time of its animation: the same where it repeats,
/// whose end so goes on as its beginning; else none before the animation's beginning or after its
/// end.
double own_time(const Animation& animation, const Track& track, double seconds);

}  // namespace tia
