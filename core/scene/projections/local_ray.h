// LocalRay: what a projection that is no plane gives a point of its picture.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/octet.h"

namespace tia {

/// LocalRay: in the frame of a view: x right, y up, z towards the viewer, the eye at the origin.
/// `seen`: whether there is a ray at all; where there is none, it is any.
/// Projections are templates over S, double or eight of them, which give the same bits.
template <class S>
struct LocalRay {
  Vec3<S> origin, direction;  ///< of length 1
  Mask<S> seen;
};

template <class S>
Mask<S> always() {
  return S(0.0) < S(1.0);
}
template <class S>
Vec3<S> at_eye() {
  return {S(0.0), S(0.0), S(0.0)};
}

/// Raster: a point of a picture of that size, from -1 to 1 across each side, x to the right and y
/// up. Exactly symmetric about both axes.
template <class S>
struct Raster {
  S x, y;
};

}  // namespace tia
