// Parametric surfaces that other kinds give too, and those whose hits can be counted.
#include "core/shapes/parametric/parametric.h"

#include <algorithm>
#include <functional>

#include "core/math/deterministic.h"
#include "core/shapes/simple/sphere.h"
#include "core/shapes/simple/torus.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

const Parametric sphere_by_angles{"cos(u)*cos(v)", "sin(v)",          "sin(u)*cos(v)",
                                  {-pi, pi},       {-pi / 2, pi / 2}, {}};
const Parametric torus_by_angles{
    "(1+0.4*cos(v))*cos(u)", "0.4*sin(v)", "(1+0.4*cos(v))*sin(u)", {0, 2 * pi}, {0, 2 * pi}, {}};

// A grid of rays from an eye, most of which meet the ball of radius 1.6.
template <class Each>
void for_grid(int n, Each each) {
  const Vec3d eye{1.5, 2.5, -4}, way = normalize(-eye);
  const Vec3d side = normalize(cross(way, Vec3d{0, 1, 0})), up = cross(side, way);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = 0.9 * (i - n / 2.0 + 0.37) / n, y = 0.9 * (k - n / 2.0 + 0.41) / n;
      each(SceneLine{eye, normalize(way + side * x + up * y)});
    }
}

// The surface against a closed form: `uv_of(p)` are its own parameters there.
template <class Form, class UvOf>
void expect_same_picture(const ParametricForm& form, const Form& other, UvOf uv_of) {
  int rays = 0, unlike = 0, hits = 0;
  for_grid(200, [&](const SceneLine& line) {
    ++rays;
    const auto a = crossings_along(form, line), b = crossings_along(other, line);
    if (a.size() != b.size()) {
      ++unlike;
      return;
    }
    for (std::size_t i = 0; i < a.size(); ++i, ++hits) {
      if (std::fabs(a[i].t - b[i].t) > 1e-6) ++unlike;
      const Vec3d p = line.origin + line.direction * b[i].t;
      const Vec3d n = normal(form, p, a[i].element), expected = normal(other, p, b[i].element);
      ASSERT_NEAR(std::fabs(dot(n, expected)), 1, 1e-6);
      const Vec2d own = uv(form, p, a[i].element), known = uv_of(p);
      const auto apart = [](double x, double y) { return std::fabs(x - y - std::round(x - y)); };
      ASSERT_LT(apart(own.u, known.u), 1e-6);
      ASSERT_LT(apart(own.v, known.v), 1e-6);
    }
  });
  EXPECT_LE(unlike, rays / 1000);
  EXPECT_GT(hits, rays / 4);
}

TEST(Parametric, SphereIsTheSphere) {
  expect_same_picture(prepare(sphere_by_angles), Sphere{{}, 1}, [](const Vec3d& p) {
    return Vec2d{(std::atan2(p.z, p.x) + pi) / (2 * pi), std::asin(p.y) / pi + 0.5};
  });
}

TEST(Parametric, TorusIsTheTorus) {
  expect_same_picture(prepare(torus_by_angles), prepare(Torus{1, 0.4}), [](const Vec3d& p) {
    const double ring = std::sqrt(p.x * p.x + p.z * p.z) - 1;
    return Vec2d{std::atan2(p.z, p.x) / (2 * pi), std::atan2(p.y, ring) / (2 * pi)};
  });
}

TEST(Parametric, SeamsAndPolesHaveNoCracks) {
  Random random(1);
  const ParametricForm form = prepare(sphere_by_angles);
  int missed = 0, doubled = 0;
  std::int64_t most = 0;
  for (int i = 0; i < rounds(10'000); ++i) {
    const double v = random.in(-pi / 2, pi / 2);
    // The seam is where u is pi; patches meet at its eighths, too.
    const double u = pi * random.below(9) / 4 - pi;
    Vec3d at{std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)};
    if (i % 4 == 0) at = {0, i % 8 == 0 ? 1.0 : -1.0, 0};
    const Vec3d aside = random.direction(), from = dot(aside, at) < 0 ? -aside : aside;
    if (dot(from, at) < 0.05) continue;
    const SceneLine line{at + from * 3.0, -from};
    const auto t = roots_along(form, line);
    missed += t.empty() || std::fabs(t.front() - 3) > 1e-6;
    doubled += t.size() > 2;
    most = std::max(most, work_along(form, line));
  }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(doubled, 0);
  EXPECT_LT(most, 100'000);
}

// ---- open, one-sided and self-crossing surfaces -----------------------------------------------

struct Known {
  const char* name;
  Parametric surface;
  std::function<Vec3d(double, double)> at;
};
const std::vector<Known>& surfaces() {
  static const std::vector<Known> all{
      {"cylinder",
       {"cos(u)", "v", "sin(u)", {0, 2 * pi}, {-1, 1}, {}},
       [](double u, double v) {
         return Vec3d{std::cos(u), v, std::sin(u)};
       }},
      {"saddle",
       {"u", "v", "u*v", {-1, 1}, {-1, 1}, {}},
       [](double u, double v) {
         return Vec3d{u, v, u * v};
       }},
      {"strip",
       {"(1+v*cos(u/2))*cos(u)",
        "v*sin(u/2)",
        "(1+v*cos(u/2))*sin(u)",
        {0, 2 * pi},
        {-0.4, 0.4},
        {}},
       [](double u, double v) {
         const double r = 1 + v * std::cos(u / 2);
         return Vec3d{r * std::cos(u), v * std::sin(u / 2), r * std::sin(u)};
       }},
      {"bottle",
       {"(1+0.4*(cos(u/2)*sin(v)-sin(u/2)*sin(2*v)))*cos(u)",
        "0.4*(sin(u/2)*sin(v)+cos(u/2)*sin(2*v))",
        "(1+0.4*(cos(u/2)*sin(v)-sin(u/2)*sin(2*v)))*sin(u)",
        {0, 2 * pi},
        {0, 2 * pi},
        {}},
       [](double u, double v) {
         const double s = std::sin(v), d = std::sin(2 * v);
         const double r = 1 + 0.4 * (std::cos(u / 2) * s - std::sin(u / 2) * d);
         return Vec3d{r * std::cos(u), 0.4 * (std::sin(u / 2) * s + std::cos(u / 2) * d),
                      r * std::sin(u)};
       }}};
  return all;
}

// How often a line meets a triangle: by the signs of volumes.
bool meets_triangle(const SceneLine& line, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d &o = line.origin, &d = line.direction;
  const auto side = [&](const Vec3d& p, const Vec3d& q) { return dot(d, cross(p - o, q - o)) > 0; };
  return side(a, b) == side(b, c) && side(b, c) == side(c, a);
}
int met_of_triangles(const Known& known, const SceneLine& line, int n) {
  const auto at = [&](int i, int k) {
    const auto &u = known.surface.u, &v = known.surface.v;
    return known.at(u[0] + (u[1] - u[0]) * i / n, v[0] + (v[1] - v[0]) * k / n);
  };
  int met = 0;
  std::vector<Vec3d> row(std::size_t(n) + 1), next = row;
  for (int k = 0; k <= n; ++k) row[std::size_t(k)] = at(0, k);
  for (int i = 1; i <= n; ++i, row.swap(next)) {
    for (int k = 0; k <= n; ++k) next[std::size_t(k)] = at(i, k);
    for (std::size_t k = 0; k < std::size_t(n); ++k)
      met += meets_triangle(line, row[k], row[k + 1], next[k]) +
             meets_triangle(line, next[k], row[k + 1], next[k + 1]);
  }
  return met;
}

TEST(Parametric, HitsAreAsManyAsTrianglesAreMet) {
  Random random(2);
  for (const Known& known : surfaces()) {
    const ParametricForm form = prepare(known.surface);
    int unlike = 0, hits = 0;
    for (int i = 0; i < rounds(150, 10); ++i) {
      const Vec3d origin = random.vector(2, 4), target = random.point(0.9);
      const SceneLine line{origin, normalize(target - origin)};
      const int own = static_cast<int>(crossings_along(form, line).size());
      hits += own;
      unlike += own != met_of_triangles(known, line, 300);
    }
    // Near a silhouette the triangles may be wrong.
    EXPECT_LE(unlike, 2) << known.name;
    EXPECT_GT(hits, rounds(60)) << known.name;
  }
}

TEST(Parametric, HitPointsAreTheSurfaceAtTheirUv) {
  Random random(3);
  for (const Known& known : surfaces()) {
    const ParametricForm form = prepare(known.surface);
    const auto &u = known.surface.u, &v = known.surface.v;
    for (int i = 0; i < rounds(2000); ++i) {
      const Vec3d origin = random.vector(2, 4), target = random.point(0.9);
      const SceneLine line{origin, normalize(target - origin)};
      for (const Crossing& each : crossings_along(form, line)) {
        const Vec3d p = line.origin + line.direction * each.t;
        const Vec2d place = uv(form, p, each.element);
        const Vec3d q = known.at(u[0] + (u[1] - u[0]) * place.u, v[0] + (v[1] - v[0]) * place.v);
        ASSERT_LT(length(p - q), 1e-8) << known.name;
        ASSERT_NEAR(length(normal(form, p, each.element)), 1, 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace tia
