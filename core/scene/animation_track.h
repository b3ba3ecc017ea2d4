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

}  // namespace tia
