// Luminous areas that directions are drawn to, in double: by the solid angle that
// they fill where that is known, else by area.
#pragma once

#include <concepts>

#include "core/math/aabb.h"
#include "core/math/octet.h"

namespace tia {

/// AreaSample: a point of an area, seen from another point. Space/units: world space; wi is unit;
/// the density is by solid angle; 0: none.
template <class S>
struct AreaSamples {
  Vec3<S> wi{S(0), S(1), S(0)};
  S distance = S(0), pdf = S(0);
};
using AreaSample = AreaSamples<double>;

/// Below this solid angle areas are sampled by area: their cosines hardly change.
inline constexpr double least_solid_angle = 3e-4;

/// TriangleArea: a, a + ab, a + ac.
/// Source: Arvo, "Stratified sampling of spherical triangles" (1995); the solid angle: Van
/// Oosterom, Strackee, "The solid angle of a plane triangle" (1983).
struct TriangleArea {
  Vec3d a, ab, ac;
};
/// QuadArea: the parallelogram corner, corner + u, corner + u + v, corner + v.
/// Source: where its angles are right, Urena, Fajardo, King, "An area-preserving parametrization
/// for spherical rectangles" (2013).
struct QuadArea {
  Vec3d corner, u, v;
};
/// DiscArea: center + x cos t + y sin t and all within: an ellipse.
struct DiscArea {
  Vec3d center, x, y;
};
/// BoxArea: center +- x +- y +- z, which are perpendicular; from outside, evenly over the solid
/// angle that it fills: its faces are in nobody's way. From inside there is no density.
struct BoxArea {
  Vec3d center, x, y, z;
};
/// CylinderArea: from base to base + axis, closed.
struct CylinderArea {
  Vec3d base, axis;
  double radius;
};

AreaSample sample_area(const TriangleArea& area, const Vec3d& p, double u, double v);
AreaSample sample_area(const QuadArea& area, const Vec3d& p, double u, double v);
/// From eight points at once; each lane the same bits as from one.
AreaSamples<Octet> sample_area(const QuadArea& area, const Vec3<Octet>& p, const Octet& u,
                               const Octet& v);
AreaSample sample_area(const DiscArea& area, const Vec3d& p, double u, double v);
AreaSample sample_area(const BoxArea& area, const Vec3d& p, double u, double v);
AreaSample sample_area(const CylinderArea& area, const Vec3d& p, double u, double v);

/// The density of sample_area() for a direction in which the area is at that distance.
double pdf_area(const TriangleArea& area, const Vec3d& p, const Vec3d& wi, double distance);
double pdf_area(const QuadArea& area, const Vec3d& p, const Vec3d& wi, double distance);
double pdf_area(const DiscArea& area, const Vec3d& p, const Vec3d& wi, double distance);
double pdf_area(const BoxArea& area, const Vec3d& p, const Vec3d& wi, double distance);
double pdf_area(const CylinderArea& area, const Vec3d& p, const Vec3d& wi, double distance);

/// Extent: what a tree of lights needs to know of one: where it is, its surface (for power), and
/// the normal of a flat one, of any length; 0: it faces all sides.
struct Extent {
  Aabb box;
  double area;
  Vec3d normal{};
};
Extent extent_of(const TriangleArea& area);
Extent extent_of(const QuadArea& area);
Extent extent_of(const DiscArea& area);
Extent extent_of(const BoxArea& area);
Extent extent_of(const CylinderArea& area);

template <class Form>
concept DrawsByArea = requires(const Form& form, const Vec3d& p) {
  { sample_area(form, p, 0.5, 0.5) } -> std::same_as<AreaSample>;
  { pdf_area(form, p, p, 1.0) } -> std::same_as<double>;
  { extent_of(form) } -> std::same_as<Extent>;
};

template <class Form>
concept DrawsFromEight = DrawsByArea<Form> && requires(const Form& form, const Octet& of_eight) {
  sample_area(form, Vec3<Octet>{of_eight, of_eight, of_eight}, of_eight, of_eight);
};

}  // namespace tia
