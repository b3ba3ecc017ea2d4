// How hard a solid is to turn: its centre of mass, principal axes and moments of inertia.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/transform.h"

namespace tia {

/// Inertia: of a solid of even density. The frame's origin is the centre of mass, its axes the
/// principal ones, right-handed, of length 1; moments are about these.
struct Inertia {
  Affine frame{};
  Vec3d moments{};
};

/// About their axis, the frame's y, and about x and z. Space/units: mass times square length.
Vec3d sphere_moments(double mass, double radius);
Vec3d box_moments(double mass, const Vec3d& half);
Vec3d cylinder_moments(double mass, double radius, double height);
/// About its centre of mass, a quarter of its height above its base.
Vec3d cone_moments(double mass, double radius, double height);
/// `height` is the segment's length.
Vec3d capsule_moments(double mass, double radius, double height);

/// Of the solid that triangles enclose, whichever way they are wound, if they all are one way.
/// Domain: a volume other than 0.
/// Source: Blow, Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid
/// body represented by a triangle mesh" (2004).
Inertia mesh_inertia(double mass, const std::vector<Vec3d>& points,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace tia
