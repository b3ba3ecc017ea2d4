// Instant: what a picture's samples are of at one time, for as long as the shutter is open.
#pragma once

#include <span>

#include "core/accel/world/world.h"
#include "core/scene/view.h"

namespace tia {

/// Instant: the world of a time, and how it is seen then. Whose space the view is in is said where
/// there is one.
struct Instant {
  const World& world;
  View view;
};

/// Instants: of the strata of the open time, of which sample s is in number s mod k; of a picture
/// of one time alone there is one. All have a backdrop, or none has.
using Instants = std::span<const Instant>;

}  // namespace tia
