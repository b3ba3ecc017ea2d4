// Paths by way of curved mirrors: the ray is aimed until it meets the receiver, where its length is
// stationary (Fermat), and its tube tells how the field spreads.
#pragma once

#include <optional>

#include "core/radio/launch.h"

namespace tia {

/// The path by those mirrors that a ray of that direction is near: Newton's steps on how far it
/// passes the receiver. Its `tube` and `caustics` are those of the reflected astigmatism, found by
/// differences of neighbouring rays. None where no such path is near.
/// Source: Kouyoumjian, Pathak, Proc. IEEE 62 (1974), (7) to (9): the spreading of a tube is the
/// root of the ratio of its areas, and each caustic that it passes turns the phase by +pi/2.
std::optional<RadioPath> curved_path(const RadioWorld& world, const RadioPath& near,
                                     const Vec3d& direction, const MirrorSequence& mirrors);

}  // namespace tia
