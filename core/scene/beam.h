// The cone around a rectangle of the picture, by which what no ray of it can meet is left out.
#pragma once

#include "core/scene/view.h"

namespace tia {

/// Beam: a cone around all rays from the eye through one rectangle of the picture, those of float
/// with all their roundings included. What is culled with it is only what no ray of it can meet, so
/// that no pixel depends on it. Rays that do not all leave one point, or go through no plane, have
/// no such cone: with a lens, orthographic or by angles, a beam meets everything.
class Beam {
 public:
  /// The rays through any points of the pixels x0 <= x < x1, y0 <= y < y1.
  Beam(const View& view, int x0, int y0, int x1, int y1);
  /// False only if no ray of the beam meets the ball.
  bool may_meet(const Vec3d& center, double radius) const;

 private:
  Vec3d origin_, axis_{};
  double cos_spread_ = 0, sin_spread_ = 1;  // of the angle between the axis and the outermost ray
  double eye_blur_ = 0;                     // how far a float eye may lie from the exact one
};

}  // namespace tia
