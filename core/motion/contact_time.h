// When balls that fly on parabolas meet: contact patches, and each other.
#pragma once

#include "core/motion/contact_patch.h"

namespace tia {

/// Flight: x(t) = position + velocity t + acceleration t^2 / 2, from the time 0 on.
struct Flight {
  Vec3d position{}, velocity{}, acceleration{};

  Vec3d position_at(double t) const { return position + (velocity + acceleration * (t / 2)) * t; }
  Vec3d velocity_at(double t) const { return velocity + acceleration * t; }
};

/// GapTolerance: what counts as no gap, and as no approach: lengths and velocities that rounding
/// may have made.
struct GapTolerance {
  double touch = 0;
  double approach = 1e-12;
};

/// The first time in [0, until] at which a ball of that radius, with its centre on the flight,
/// touches the patch and approaches it; infinite where there is none. Of two that touch and do not
/// approach each other it is when they come back.
double contact_time(const ContactPatch& patch, const Flight& flight, double radius, double until,
                    const GapTolerance& tolerance);

/// The same of two balls, by the flight from one's centre to the other's and both radii together.
double pair_time(const Flight& flight, double radii, double until, const GapTolerance& tolerance);

/// When the point of the patch next to a centre that slides along it is half of `touch` outside;
/// infinite where that is never. Domain: a centre that is over it to a quarter of `touch`.
double end_of_patch(const ContactPatch& patch, const Flight& flight, double until, double touch);

}  // namespace tia
