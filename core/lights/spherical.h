// Triangles and rectangles as a point sees them, and directions drawn evenly over what they fill.
#pragma once

#include "core/math/octet.h"

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

/// SphericalRectangle, from one point or from eight. Domain: the corner relative to the point;
/// perpendicular edges.
/// Source: Urena, Fajardo, King, "An area-preserving parametrization for spherical rectangles",
/// Computer Graphics Forum 32(4) (2013), algorithm 1 and 2.
template <class S>
struct SphericalRectangle {
  S solid_angle = S(0);

  SphericalRectangle() = default;
  SphericalRectangle(const Vec3<S>& to_corner, const Vec3d& u, const Vec3d& v);
  /// Domain: solid_angle > 0.
  Vec3<S> sample(const S& u, const S& v) const;

 private:
  Vec3d x_{}, y_{}, z_{};
  S x0_ = S(0), x1_ = S(0), y0_ = S(0), y1_ = S(0);
  S height_ = S(0), z0_ = S(0);  // along z_, and with a sign that is never positive
  S b0_ = S(0), b1_ = S(0), k_ = S(0);
};

}  // namespace tia
