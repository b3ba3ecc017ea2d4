// What a packet's paths have come to.
#pragma once

#include "core/integrators/fog.h"
#include "core/integrators/media.h"

namespace tia {

/// PathState: of the paths of a packet, lane by lane.
template <class Real>
struct PathState {
  using V = Vec3<Real>;
  Medium<Real> medium{};                ///< that the path's last ray is in
  V light{Real(0), Real(0), Real(0)};   ///< gathered so far, linear RGB
  V beta{Real(1), Real(1), Real(1)};    ///< the throughput: what light counts that comes now
  Real wave = Real(0);                  ///< in nanometres; 0: white
  V from{Real(0), Real(0), Real(0)};    ///< the last vertex
  V from_n{Real(0), Real(0), Real(0)};  ///< its geometric normal
  /// Of the direction from there, by solid angle; 0: of the camera, of mirrors and of glass.
  Real pdf = Real(0);
  Real travelled = Real(0);  ///< how far it is from the camera to the last vertex
  Mask<Real> transmitted{};  ///< whether that direction went through the surface
  /// The last vertex, where it lies in fog.
  typename FogSampling<Real>::Vertex fog_vertex{};
  /// The square of the index of refraction, over that where the path began.
  Real denser = Real(1);
};

template <class Real>
Mask<Real> shines(const Vec3<Real>& light) {
  return light.x > Real(0) || light.y > Real(0) || light.z > Real(0);
}
template <class Real>
Mask<Real> is_finite(const Vec3<Real>& light) {
  return light.x < Real(infinity) && light.y < Real(infinity) && light.z < Real(infinity);
}

}  // namespace tia
