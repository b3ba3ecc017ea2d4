// Contact patches: the pieces of fixed things' surfaces as balls meet them: a piece of a plane, of
// a cylinder, of a sphere, or a circle. Edges and corners are a cylinder and a sphere of radius 0.
// Around a ball's radius a patch leaves room for its centre: the offset surface, on which contacts
// are found. Offset edges are whole, so that those of faces, which end there, have no gap to them.
#pragma once

#include <array>
#include <variant>

#include "core/math/aabb.h"
#include "core/math/vec3.h"

namespace tia {

/// A piece of the plane (x - point) . normal = 0: all of it, a convex polygon where
/// x . inward[i] >= offset[i], or the disc around the point.
struct PlanePatch {
  Vec3d point{}, normal{0, 1, 0};
  int sides = 0;  ///< of the polygon; 0: it is none
  std::array<Vec3d, 4> inward{};
  std::array<double, 4> offset{};
  double disc_radius = 0;  ///< 0: it is no disc
  Aabb box = Aabb::everything();
};
/// The points at `radius` from the segment base + z axis, z in [0, length], beside it.
struct CylinderPatch {
  Vec3d base{}, axis{0, 1, 0};
  double length = 0, radius = 0;
};
/// The points at `radius` from the centre; only those towards `half` unless that is 0.
struct SpherePatch {
  Vec3d center{};
  double radius = 0;
  Vec3d half{};
};
/// A circle.
struct CirclePatch {
  Vec3d center{}, axis{0, 1, 0};
  double radius = 1;
};
using ContactPatch = std::variant<PlanePatch, CylinderPatch, SpherePatch, CirclePatch>;

/// Touch: how far a ball is from a patch, and what way: from the patch to the ball, unit.
struct Touch {
  double gap = Aabb::far;
  Vec3d normal{0, 1, 0};
};

/// Of a ball whose centre is x. Where the nearest point of the patch's whole surface (of all the
/// plane, ...) is farther than `margin` outside of the patch the gap is infinite.
Touch touch_of(const ContactPatch& patch, const Vec3d& x, double radius, double margin);

/// Whether a patch is an edge or a corner that is nowhere above a plane by more than `margin`, seen
/// from the side that the normal shows to.
bool lies_below(const ContactPatch& patch, const PlanePatch& plane, const Vec3d& normal,
                double margin);

/// What the surface's curvature adds to the gap's second derivative, v . H v, H the gap's Hessian:
/// above 0 around a convex patch, below in a hollow, 0 along a plane.
double bend_of(const ContactPatch& patch, const Vec3d& x, const Vec3d& v);

/// The least radius of curvature that the centre of a ball meets there; infinite of a plane.
double bend_radius(const ContactPatch& patch, const Vec3d& x, double radius);

Aabb bounds_of(const ContactPatch& patch);

}  // namespace tia
