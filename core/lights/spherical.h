// Triangles and rectangles as a point sees them, and directions drawn evenly over what they fill.
#pragma once

#include "core/math/vec3.h"

namespace tia {

/// SphericalTriangle. Domain: corners relative to the point. A degenerate one has solid angle 0.
/// Source: Arvo, "Stratified sampling of spherical triangles" (1995), as Pharr, Jakob, Humphreys,
/// "Physically Based Rendering", 4th ed., 6.5.4, have it; the solid angle: Van Oosterom, Strackee,
/// "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30 (1983).
struct SphericalTriangle {
  Vec3d a, b, c;  ///< unit
  double solid_angle;

  SphericalTriangle(const Vec3d& to_a, const Vec3d& to_b, const Vec3d& to_c);
  /// Domain: solid_angle > 0.
  Vec3d sample(double u, double v) const;
};

/// SphericalRectangle. Domain: the corner relative to the point; perpendicular edges.
/// Source: Urena, Fajardo, King, "An area-preserving parametrization for spherical rectangles",
/// Computer Graphics Forum 32(4) (2013), algorithm 1 and 2.
struct SphericalRectangle {
  double solid_angle = 0;

  SphericalRectangle() = default;
  SphericalRectangle(const Vec3d& to_corner, const Vec3d& u, const Vec3d& v);
  /// Domain: solid_angle > 0.
  Vec3d sample(double u, double v) const;

 private:
  Vec3d x_{}, y_{}, z_{};
  double x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0, z0_ = 0;
  double b0_ = 0, b1_ = 0, k_ = 0;
};

}  // namespace tia
