// LayerFrames: how a surface's coat and its grain lie, where maps tell them apart from the surface.
#pragma once

#include "core/math/wide.h"

namespace tia {

/// LayerFrames: of the surfaces that a packet has hit, lane by lane. Space/units: the world's.
template <class Real>
struct LayerFrames {
  Vec3<Real> coat_n{};  ///< the coat's normal, unit, on the side of the shading normal
  Vec3<Real> grain{};   ///< along which facets are stretched; what stands upright of it is left out
  Mask<Real> coated{};  ///< where the coat has that normal; elsewhere it has the surface's
  Mask<Real> grained{};  ///< where that is told; elsewhere it is turned from the horizontal
};

}  // namespace tia
