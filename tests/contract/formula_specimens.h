// Specimens of the surfaces that formulas give.
#pragma once

#include "tests/contract/specimens.h"

namespace tia::test {

/// Ellipsoids along the axes, written as a formula.
template <>
struct Specimen<Implicit> {
  static constexpr bool convex = true, rounds_at_start = true;
  static constexpr int share = 50;
  static Implicit make(Random& random, double scale) {
    const Vec3d c = random.point(3) * scale;
    const auto half = [&] { return random.in(0.4, 2) * scale; };
    const double r = half(), s = half(), q = half();
    const Vec3d room = Vec3d{r, s, q} * 1.1;
    Bounds box;
    box.min = c - room, box.max = c + room;
    return {"((x-a)/r)^2 + ((y-b)/s)^2 + ((z-c)/q)^2 - 1",
            box,
            {{"a", c.x}, {"b", c.y}, {"c", c.z}, {"r", r}, {"s", s}, {"q", q}}};
  }
  static Vec3d center(const Implicit& f) {
    return {f.parameters.at("a"), f.parameters.at("b"), f.parameters.at("c")};
  }
  static Vec3d halves(const Implicit& f) {
    return {f.parameters.at("r"), f.parameters.at("s"), f.parameters.at("q")};
  }
  static Reach reach(const Implicit& f) {
    const Vec3d half = halves(f);
    return {center(f), std::max({half.x, half.y, half.z})};
  }
  static double distance(const Implicit& f, const Vec3d& p) {
    const Vec3d half = halves(f), w = p - center(f);
    const Vec3d g{w.x / (half.x * half.x), w.y / (half.y * half.y), w.z / (half.z * half.z)};
    return (dot(g, w) - 1) / length(g) / 2;
  }
};

/// Hills that are solid below, paraboloids, within bounds that no test's march comes to.
template <>
struct Specimen<Explicit> {
  static constexpr bool convex = true, rounds_at_start = true;
  static constexpr int share = 50;
  static Explicit make(Random& random, double scale) {
    const Vec3d top = random.point(3) * scale;
    const double steep = random.in(0.2, 1) / scale, size = random.in(0.5, 2) * scale;
    Bounds ball;
    ball.center = top, ball.radius = 16 * size;
    return {"h - k*((x-a)^2 + (y-b)^2)",
            ball,
            {{"a", top.x}, {"b", top.y}, {"h", top.z}, {"k", steep}}};
  }
  static Reach reach(const Explicit& g) { return {*g.bounds.center, *g.bounds.radius / 16}; }
  static double distance(const Explicit& g, const Vec3d& p) {
    const double k = g.parameters.at("k");
    const Vec3d w = p - *g.bounds.center;
    const double square = w.x * w.x + w.y * w.y;
    return (w.z + k * square) / std::sqrt(1 + 4 * k * k * square);
  }
};

/// Tori by two angles, with two seams.
template <>
struct Specimen<Parametric> {
  static constexpr bool convex = false, rounds_at_start = true;
  static constexpr int share = 50;
  static Parametric make(Random& random, double scale) {
    const Vec3d c = random.point(3) * scale;
    const double r = random.in(0.6, 2) * scale, s = r * random.in(0.3, 0.7);
    return {"a + (r + s*cos(v))*cos(u)",
            "b + (r + s*cos(v))*sin(u)",
            "c + s*sin(v)",
            {-pi, pi},
            {0, 2 * pi},
            {{"a", c.x}, {"b", c.y}, {"c", c.z}, {"r", r}, {"s", s}}};
  }
  static Reach reach(const Parametric& p) {
    return {{p.parameters.at("a"), p.parameters.at("b"), p.parameters.at("c")},
            p.parameters.at("r") + p.parameters.at("s")};
  }
  static double distance(const Parametric& p, const Vec3d& at) {
    const Vec3d w = at - reach(p).center;
    const double ring = std::sqrt(w.x * w.x + w.y * w.y) - p.parameters.at("r");
    return std::fabs(std::sqrt(ring * ring + w.z * w.z) - p.parameters.at("s"));
  }
};

/// Two balls that have grown together: their distances joined as Blend's comment says.
template <>
struct Specimen<Blend> {
  static constexpr bool convex = false, rounds_at_start = true;
  static constexpr int share = 100;
  static Blend make(Random& random, double scale) {
    Blend blend;
    blend.radius = random.in(0.1, 0.6) * scale;
    const Vec3d first = random.point(2) * scale;
    const double r = random.in(0.5, 1) * scale;
    const Vec3d second = first + random.vector(0.8, 1.4) * scale;
    blend.children.push_back({Sphere{first, r}, {}});
    blend.children.push_back({Sphere{second, random.in(0.5, 1) * scale}, {}});
    return blend;
  }
  static const Sphere& ball(const Blend& blend, std::size_t i) {
    return std::get<Sphere>(blend.children[i].shape);
  }
  static Reach reach(const Blend& blend) {
    const Sphere &a = ball(blend, 0), &b = ball(blend, 1);
    return {(a.center + b.center) * 0.5,
            length(a.center - b.center) / 2 + std::max(a.radius, b.radius)};
  }
  static double distance(const Blend& blend, const Vec3d& p) {
    const double r = blend.radius;
    std::array<double, 2> d{}, depth{};
    std::array<Vec3d, 2> n{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3d away = p - ball(blend, i).center;
      d[i] = length(away) - ball(blend, i).radius;
      depth[i] = std::max(0.0, r - d[i]);
      n[i] = away * (1 / length(away));
    }
    const double both = std::sqrt(depth[0] * depth[0] + depth[1] * depth[1]);
    if (both == 0) return std::min(d[0], d[1]);
    const Vec3d gradient = (n[0] * depth[0] + n[1] * depth[1]) * (1 / both);
    return (std::max(r, std::min(d[0], d[1])) - both) / length(gradient);
  }
};

}  // namespace tia::test
