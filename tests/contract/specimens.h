// Specimens: what the laws of the contract need to know of each kind of surface. A new kind brings
// one: random members of it, and how far a point is from them by their equations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
/// and where they apply:
///   fixed_size  it has no length of its own to scale: make takes no notice of scale
///   rounds_at_start  its roots are searched for from where a ray starts, and rounded accordingly
///   rounding    how far from a root that may lead, along a direction, where a slope is next to 0
///   share       of the contract's rounds a share of this many, where a member is costly to compile
///   regular     whether a point is clear of the surface's singular ones: there roots are multiple
///               and lose digits, and normals mean nothing
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
struct Specimen<Capsule> {
  static constexpr bool convex = true;
  static Capsule make(Random& random, double scale) {
    const Vec3d base = random.point(3) * scale;
    const Vec3d cap = base + random.vector(0, 3) * scale;
    return {base, cap, random.in(0.2, 2) * scale};
  }
  static Reach reach(const Capsule& c) {
    return {(c.base + c.cap) * 0.5, c.radius + length(c.cap - c.base) / 2};
  }
  static double distance(const Capsule& c, const Vec3d& p) {
    const Vec3d axis = c.cap - c.base, w = p - c.base;
    const double share = std::clamp(dot(w, axis) / dot(axis, axis), 0.0, 1.0);
    return length(w - axis * share) - c.radius;
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

/// Grids of up to 4 cells along each axis, most of them filled.
template <>
struct Specimen<Voxels> {
  static constexpr bool convex = false;
  static Voxels make(Random& random, double scale) {
    Voxels v;
    for (int& n : v.size) n = 1 + random.below(4);
    v.origin = random.point(2) * scale;
    const double x = random.in(0.2, 1) * scale, y = random.in(0.2, 1) * scale;
    v.cell = Vec3d{x, y, random.in(0.2, 1) * scale};
    v.occupied.width = 3;
    for (int k = 0; k < v.size[2]; ++k)
      for (int j = 0; j < v.size[1]; ++j)
        for (int i = 0; i < v.size[0]; ++i)
          if (random.chance(0.6)) v.occupied.numbers.insert(v.occupied.numbers.end(), {i, j, k});
    if (v.occupied.numbers.empty()) v.occupied.numbers = {0, 0, 0};
    return v;
  }
  static Reach reach(const Voxels& v) {
    const Aabb box = bounds(v);
    return {box.center(), length(box.size()) / 2};
  }
  // By the nearest cell of the other kind, the empty ones around the grid included.
  static double distance(const Voxels& v, const Vec3d& p) {
    double to_filled = Aabb::far, to_empty = Aabb::far;
    for (int k = -1; k <= v.size[2]; ++k)
      for (int j = -1; j <= v.size[1]; ++j)
        for (int i = -1; i <= v.size[0]; ++i) {
          double& nearest = is_filled(v, i, j, k) ? to_filled : to_empty;
          nearest = std::min(nearest, to_cell(v, {double(i), double(j), double(k)}, p));
        }
    return to_filled <= 0 ? -to_empty : to_filled;
  }
  static bool is_filled(const Voxels& v, int i, int j, int k) {
    const auto& n = v.occupied.numbers;
    for (std::size_t at = 0; at < n.size(); at += 3)
      if (n[at] == i && n[at + 1] == j && n[at + 2] == k) return true;
    return false;
  }
  static double to_cell(const Voxels& v, const Vec3d& index, const Vec3d& p) {
    const Vec3d cell = std::get<Vec3d>(v.cell), low = v.origin + cell * index;
    return Specimen<Box>::distance({low, low + cell}, p);
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
  static constexpr bool convex = true, rounds_at_start = true;
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

// ---- the named algebraic surfaces, as their books write them ------------------------------------

/// Slope: a number with its gradient, to differentiate what is written in it.
struct Slope {
  double value = 0;
  Vec3d gradient{};
  Slope(double constant) : value(constant) {}
  Slope(double at, const Vec3d& way) : value(at), gradient(way) {}

  friend Slope operator+(const Slope& a, const Slope& b) {
    return {a.value + b.value, a.gradient + b.gradient};
  }
  friend Slope operator-(const Slope& a, const Slope& b) {
    return {a.value - b.value, a.gradient - b.gradient};
  }
  friend Slope operator*(const Slope& a, const Slope& b) {
    return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
  }
};
inline Slope squared(const Slope& a) { return a * a; }
inline Slope cubed(const Slope& a) { return a * a * a; }

/// What the specimens of named surfaces share: Left::of is the left side of the equation.
template <class S, class Left>
struct Classic {
  static constexpr bool convex = false, fixed_size = true, rounds_at_start = true;
  static S make(Random&, double) { return {}; }
  static Reach reach(const S&) { return {{}, Left::radius}; }
  static double distance(const S& s, const Vec3d& p) {
    const Slope at =
        Left::of(s, Slope(p.x, {1, 0, 0}), Slope(p.y, {0, 1, 0}), Slope(p.z, {0, 0, 1}));
    return at.value / length(at.gradient);
  }
};

struct SteinerLeft {
  static constexpr double radius = 0.6;
  static Slope of(const Steiner&, const Slope& x, const Slope& y, const Slope& z) {
    return squared(x * y) + squared(y * z) + squared(z * x) - x * y * z;
  }
};
template <>
struct Specimen<Steiner> : Classic<Steiner, SteinerLeft> {
  // Two of its sheets meet along each axis.
  static bool regular(const Steiner&, const Vec3d& p) {
    const double x = p.x * p.x, y = p.y * p.y, z = p.z * p.z;
    return std::min({x + y, y + z, z + x}) > 0.02 * 0.02;
  }
};

struct BarthLeft {
  static constexpr double radius = 1.5;
  static Slope of(const BarthSextic&, const Slope& x, const Slope& y, const Slope& z) {
    const double p = (1 + std::sqrt(5.0)) / 2;
    const auto factor = [&](const Slope& a, const Slope& b) { return (p * a - b) * (p * a + b); };
    return 4 * factor(x, y) * factor(y, z) * factor(z, x) -
           (1 + 2 * p) * squared(squared(x) + squared(y) + squared(z) - 1.0);
  }
};
template <>
struct Specimen<BarthSextic> : Classic<BarthSextic, BarthLeft> {};

struct ChmutovLeft {
  static constexpr double radius = 1.3;
  static Slope of(const Chmutov& s, const Slope& x, const Slope& y, const Slope& z) {
    Slope sum(0);
    for (const Slope& t : {x, y, z}) {
      Slope before(1), now = t;
      for (int i = 1; i < s.order; ++i) before = std::exchange(now, 2 * t * now - before);
      sum = sum + now;
    }
    return sum;
  }
};
/// Of low orders: those that keep nearly all of a double's digits.
template <>
struct Specimen<Chmutov> : Classic<Chmutov, ChmutovLeft> {
  static Chmutov make(Random& random, double) { return {2 + random.below(4), {}}; }
};

struct HeartLeft {
  static constexpr double radius = 1.4;
  static Slope of(const Heart&, const Slope& x, const Slope& y, const Slope& z) {
    return cubed(squared(x) + squared(1.5 * y) + squared(z) - 1) -
           (squared(x) + 0.1125 * squared(y)) * cubed(z);
  }
};
template <>
struct Specimen<Heart> : Classic<Heart, HeartLeft> {
  // Where both sides are 0, around its waist and at its two tips, they are so to the third order.
  static bool regular(const Heart&, const Vec3d& p) {
    return std::fabs(p.z) > 0.05 && p.x * p.x + p.y * p.y > 0.05 * 0.05;
  }
  // The sum is off by some 2^-53 of what the sizes of its terms add up to, and a root along d by
  // that over the slope there; next to where both sides are 0 there hardly is one.
  static double rounding(const Heart& heart, const Vec3d& p, const Vec3d& d) {
    const double x = p.x * p.x, y = p.y * p.y, z = p.z * p.z, sides = x + 2.25 * y + z + 1;
    const double sizes = sides * sides * sides + (x + 0.1125 * y) * z * std::fabs(p.z);
    const Slope at =
        HeartLeft::of(heart, Slope(p.x, {1, 0, 0}), Slope(p.y, {0, 1, 0}), Slope(p.z, {0, 0, 1}));
    return 8 * 0x1p-53 * sizes / std::fabs(dot(at.gradient, d));
  }
};

/// As the sum of five cubes, of numbers whose sum is 0.
struct ClebschLeft {
  static constexpr double radius = 1.5;
  static Slope of(const Clebsch&, const Slope& x, const Slope& y, const Slope& z) {
    const Slope sum = 3 * (x + y + z);
    return (cubed(12 * x - sum - 1) + cubed(12 * y - sum - 1) + cubed(12 * z - sum - 1) +
            cubed(2 - 2 * sum) + cubed(sum + 1)) *
           (1.0 / 6);
  }
};
template <>
struct Specimen<Clebsch> : Classic<Clebsch, ClebschLeft> {};

struct CayleyLeft {
  static constexpr double radius = 1.5;
  static Slope of(const Cayley&, const Slope& x, const Slope& y, const Slope& z) {
    return squared(2 * x) + squared(2 * y) + squared(2 * z) + 16 * x * y * z - 1;
  }
};
template <>
struct Specimen<Cayley> : Classic<Cayley, CayleyLeft> {};

}  // namespace tia::test
