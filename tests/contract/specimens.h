// Specimens: what the laws of the contract need to know of each kind of surface. A new kind brings
// one: random members of it, and how far a point is from them by their equations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/shapes/shape.h"
#include "tests/core/support.h"

namespace tia::test {

/// Where most of a shape is, for rays to be aimed at.
struct Reach {
  Vec3d center;
  double radius;
};

/// Specimen<S>:
///   make      a random member, lengths in proportion to scale
///   reach     a ball that holds it, or the interesting part of it
///   distance  in scene units near the surface; of a solid below 0 inside
///   convex    whether it lies on one side of each of its tangent planes
template <class S>
struct Specimen;

template <>
struct Specimen<Sphere> {
  static constexpr bool convex = true;
  static Sphere make(Random& random, double scale) {
    const Vec3d center = random.point(3) * scale;
    return {center, random.in(0.2, 3) * scale};
  }
  static Reach reach(const Sphere& s) { return {s.center, s.radius}; }
  static double distance(const Sphere& s, const Vec3d& p) {
    return length(p - s.center) - s.radius;
  }
};

template <>
struct Specimen<Plane> {
  static constexpr bool convex = true;
  static Plane make(Random& random, double scale) {
    const Vec3d point = random.point(3) * scale;
    return {point, random.direction() * 8.0};
  }
  // About the point of it that the scale was chosen for.
  static Reach reach(const Plane& p) { return {p.point, std::max(length(p.point), 1e-9)}; }
  static double distance(const Plane& s, const Vec3d& p) {
    return dot(p - s.point, normalize(s.normal));
  }
};

template <>
struct Specimen<Disc> {
  static constexpr bool convex = true;
  static Disc make(Random& random, double scale) {
    const Vec3d center = random.point(3) * scale, normal = random.direction() * 0.125;
    return {center, normal, random.in(0.2, 3) * scale};
  }
  static Reach reach(const Disc& d) { return {d.center, d.radius}; }
  static double distance(const Disc& d, const Vec3d& p) {
    const Vec3d n = normalize(d.normal), w = p - d.center;
    const double height = dot(w, n), aside = length(w - n * height);
    return std::max(std::fabs(height), aside - d.radius);
  }
};

template <>
struct Specimen<Box> {
  static constexpr bool convex = true;
  static Box make(Random& random, double scale) {
    const Vec3d min = random.point(3) * scale;
    const double x = random.in(0.2, 3) * scale, y = random.in(0.2, 3) * scale;
    return {min, min + Vec3d{x, y, random.in(0.2, 3) * scale}};
  }
  static Reach reach(const Box& b) { return {(b.min + b.max) * 0.5, length(b.max - b.min) / 2}; }
  static double distance(const Box& b, const Vec3d& p) {
    const Vec3d low = b.min - p, high = p - b.max;
    return std::max({low.x, low.y, low.z, high.x, high.y, high.z});
  }
};

template <>
struct Specimen<Cone> {
  static constexpr bool convex = true;
  static Cone make(Random& random, double scale) {
    const Vec3d base = random.point(3) * scale;
    const Vec3d cap = base + random.vector(0.5, 3) * scale;
    const double r = random.in(0.2, 2) * scale;
    return {base, cap, r, random.chance(0.3) ? 0 : random.in(0.2, 2) * scale};
  }
  static Reach reach(const Cone& c) {
    const double r = std::max(c.base_radius, c.cap_radius), half = length(c.cap - c.base) / 2;
    return {(c.base + c.cap) * 0.5, std::sqrt(r * r + half * half)};
  }
  static double distance(const Cone& c, const Vec3d& p) {
    const double height = length(c.cap - c.base);
    const Vec3d n = normalize(c.cap - c.base), w = p - c.base;
    const double z = dot(w, n), growth = (c.cap_radius - c.base_radius) / height;
    const double aside = length(w - n * z) - (c.base_radius + growth * z);
    return std::max({-z, z - height, aside / std::sqrt(1 + growth * growth)});
  }
};

template <>
struct Specimen<Cylinder> {
  static constexpr bool convex = true;
  static Cylinder make(Random& random, double scale) {
    const Cone cone = Specimen<Cone>::make(random, scale);
    return {cone.base, cone.cap, cone.base_radius};
  }
  static Cone cone(const Cylinder& c) { return {c.base, c.cap, c.radius, c.radius}; }
  static Reach reach(const Cylinder& c) { return Specimen<Cone>::reach(cone(c)); }
  static double distance(const Cylinder& c, const Vec3d& p) {
    return Specimen<Cone>::distance(cone(c), p);
  }
};

template <>
struct Specimen<Triangle> {
  static constexpr bool convex = true;
  static Triangle make(Random& random, double scale) {
    const Vec3d a = random.point(3) * scale, way = random.direction();
    const Vec3d b = a + way * (random.in(0.5, 3) * scale);
    const Vec3d aside = normalize(cross(way, random.direction()));
    return {a, b, a + aside * (random.in(0.5, 3) * scale) + way * (random.in(-1, 1) * scale)};
  }
  static Reach reach(const Triangle& t) {
    const Vec3d middle = (t.a + t.b + t.c) * (1.0 / 3);
    return {middle, std::max({length(t.a - middle), length(t.b - middle), length(t.c - middle)})};
  }
  // The height above the plane, or how far a point is beyond an edge.
  static double distance(const Triangle& t, const Vec3d& p) {
    const Vec3d n = normalize(cross(t.b - t.a, t.c - t.a));
    const auto beyond = [&](const Vec3d& from, const Vec3d& to) {
      return dot(p - from, normalize(cross(to - from, n)));
    };
    return std::max(
        {std::fabs(dot(p - t.a, n)), beyond(t.a, t.b), beyond(t.b, t.c), beyond(t.c, t.a)});
  }
};

template <>
struct Specimen<Torus> {
  static constexpr bool convex = false;
  static Torus make(Random& random, double scale) {
    const double major = random.in(0.5, 3) * scale;
    return {major, major * random.in(0.1, 0.9)};
  }
  static Reach reach(const Torus& t) { return {{}, t.major_radius + t.minor_radius}; }
  static double distance(const Torus& t, const Vec3d& p) {
    const double ring = std::sqrt(p.x * p.x + p.z * p.z) - t.major_radius;
    return std::sqrt(ring * ring + p.y * p.y) - t.minor_radius;
  }
};

/// Ellipsoids along the axes: ((x - c) / s)^2 + ... - 1, written out.
template <>
struct Specimen<Quadric> {
  static constexpr bool convex = true;
  static Quadric make(Random& random, double scale) {
    const Vec3d c = random.point(3) * scale;
    const auto square = [&] { return 1 / (random.in(0.04, 4) * scale * scale); };
    const double x = square(), y = square(), z = square();
    return {{x, y, z, 0, 0, 0, -2 * x * c.x, -2 * y * c.y, -2 * z * c.z,
             x * c.x * c.x + y * c.y * c.y + z * c.z * c.z - 1},
            {}};
  }
  static Reach reach(const Quadric& q) {
    const auto& k = q.coefficients;
    return {{-k[6] / k[0] / 2, -k[7] / k[1] / 2, -k[8] / k[2] / 2},
            1 / std::sqrt(std::min({k[0], k[1], k[2]}))};
  }
  static double distance(const Quadric& q, const Vec3d& p) {
    const auto& k = q.coefficients;
    const Vec3d squares{k[0], k[1], k[2]}, w = p - reach(q).center;
    return (dot(squares * w, w) - 1) / length(squares * w) / 2;
  }
};

/// Superellipsoids around the origin: (x / a)^4 + (y / b)^4 + (z / c)^4 = 1.
template <>
struct Specimen<Algebraic> {
  static constexpr bool convex = true;
  static Algebraic make(Random& random, double scale) {
    const auto fourth = [&] {
      const double half = random.in(0.5, 2) * scale;
      return 1 / (half * half * half * half);
    };
    const double x = fourth(), y = fourth(), z = fourth();
    return {{{{4, 0, 0}, x}, {{0, 4, 0}, y}, {{0, 0, 4}, z}, {{0, 0, 0}, -1}}, {}};
  }
  // A corner of the box around it is sqrt 3 times as far as the middle of a face.
  static Reach reach(const Algebraic& a) {
    double least = a.terms[0].coefficient;
    for (const std::size_t i : {1U, 2U}) least = std::min(least, a.terms[i].coefficient);
    return {{}, std::sqrt(3 / std::sqrt(least))};
  }
  static double distance(const Algebraic& a, const Vec3d& p) {
    const Vec3d k{a.terms[0].coefficient, a.terms[1].coefficient, a.terms[2].coefficient};
    const Vec3d cubes = k * p * p * p;
    return (dot(cubes, p) - 1) / length(cubes) / 4;
  }
};

}  // namespace tia::test
