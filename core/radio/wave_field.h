// The electric field that a path carries, and what all paths of a link have in common.
#pragma once

#include "core/math/vec3.h"
#include "core/radio/complex.h"
#include "core/radio/constants.h"

namespace tia {

/// WaveField: the electric field at a place. Space/units: scene space.
struct WaveField {
  Vec3d re{}, im{};

  Complex along(const Vec3d& axis) const { return {dot(re, axis), dot(im, axis)}; }
  void add(const Vec3d& axis, const Complex& much) {
    re = re + axis * much.re;
    im = im + axis * much.im;
  }
};

/// LinkWave: what all paths of a link have in common.
struct LinkWave {
  Wave wave{};
  double unit_metres = 1;
};

}  // namespace tia
