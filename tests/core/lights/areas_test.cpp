// Directions drawn to luminous areas: they meet the area, as dense as the density says.
#include "core/lights/areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "core/lights/spherical.h"
#include "core/math/deterministic.h"
#include "core/math/onb.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using test::rounds;

using AnyArea = std::variant<TriangleArea, QuadArea, DiscArea, BoxArea, CylinderArea>;

AnyArea random_area(Random& random, int kind) {
  const Vec3d p = random.point(1), x = random.vector(0.2, 2), y = random.vector(0.2, 2);
  const Onb frame = onb_around(random.direction());
  const double a = random.in(0.1, 1), b = random.in(0.1, 1), c = random.in(0.1, 1);
  switch (kind) {
    case 0: return TriangleArea{p, x, y};
    case 1: return QuadArea{p, frame.u * a, frame.v * b};
    case 2: return QuadArea{p, x, y};
    case 3: return DiscArea{p, x, y};
    case 4: return BoxArea{p, frame.u * a, frame.v * b, frame.n * c};
    default: return CylinderArea{p, x, a};
  }
}
constexpr int area_kinds = 6;

// What a ray meets first; none beyond. Each kind by its own equation.
double flat_hit(const Vec3d& p, const Vec3d& wi, const Vec3d& q, const Vec3d& x, const Vec3d& y,
                bool (*within)(double, double)) {
  const Vec3d n = cross(x, y);
  const double t = dot(n, q - p) / dot(n, wi);
  if (!(t > 0)) return Aabb::far;
  const Vec3d at = p + wi * t - q;
  const double u = dot(cross(at, y), n) / dot(n, n), v = dot(cross(x, at), n) / dot(n, n);
  return within(u, v) ? t : Aabb::far;
}
bool in_square(double u, double v) { return u >= 0 && u <= 1 && v >= 0 && v <= 1; }
bool in_triangle(double u, double v) { return u >= 0 && v >= 0 && u + v <= 1; }
bool in_circle(double u, double v) { return u * u + v * v <= 1; }

double hit(const TriangleArea& t, const Vec3d& p, const Vec3d& wi) {
  return flat_hit(p, wi, t.a, t.ab, t.ac, in_triangle);
}
double hit(const QuadArea& q, const Vec3d& p, const Vec3d& wi) {
  return flat_hit(p, wi, q.corner, q.u, q.v, in_square);
}
double hit(const DiscArea& d, const Vec3d& p, const Vec3d& wi) {
  return flat_hit(p, wi, d.center, d.x, d.y, in_circle);
}
double hit(const BoxArea& b, const Vec3d& p, const Vec3d& wi) {
  double near = Aabb::far;
  const std::array axes{b.x, b.y, b.z};
  for (std::size_t i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) {
      const Vec3d &u = axes[(i + 1) % 3], &v = axes[(i + 2) % 3];
      const Vec3d corner = b.center + axes[i] * side - u - v;
      near = std::min(near, flat_hit(p, wi, corner, u * 2.0, v * 2.0, in_square));
    }
  return near;
}
double hit(const CylinderArea& c, const Vec3d& p, const Vec3d& wi) {
  const Onb frame = onb_around(normalize(c.axis));
  double near = Aabb::far;
  for (const double end : {0.0, 1.0})
    near = std::min(near, flat_hit(p, wi, c.base + c.axis * end, frame.u * c.radius,
                                   frame.v * c.radius, in_circle));
  const Vec3d o = frame.local(p - c.base), d = frame.local(wi);
  const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y;
  const double root = b * b - a * (o.x * o.x + o.y * o.y - c.radius * c.radius);
  if (root < 0) return near;
  for (const double t : {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a}) {
    const double z = o.z + t * d.z;
    if (t > 0 && z >= 0 && z <= length(c.axis)) near = std::min(near, t);
  }
  return near;
}

// The share of the sphere that it fills is the mean of 1 / pdf over those directions that are drawn
// to what is seen of it, and that of all directions that meet it.
TEST(Areas, DrawnDirectionsMeetWhatIsThereAsDenseAsTheySay) {
  Random random(950);
  for (int i = 0; i < rounds(60, 12); ++i) {
    const AnyArea any = random_area(random, i % area_kinds);
    const Vec3d p = random.direction() * random.in(3, 5), axis = random.direction();
    std::visit(
        [&](const auto& area) {
          // By the area's samples and by those of a cone around it: the integral of a ramp.
          const Vec3d middle = extent_of(area).box.center();
          const Onb frame = onb_around(normalize(middle - p));
          const double reach = length(extent_of(area).box.size()) / 2, far = length(middle - p);
          const double rise = 1 - std::sqrt(1 - std::min(reach * reach / (far * far), 1.0));
          double drawn = 0, drawn_square = 0, even = 0, even_square = 0;
          constexpr int count = 20'000;
          for (int k = 0; k < count; ++k) {
            const double u = random.unit();
            const AreaSample at = sample_area(area, p, u, random.unit());
            if (at.pdf > 0) {
              const double first = hit(area, p, at.wi);
              EXPECT_NEAR(pdf_area(area, p, at.wi, at.distance), at.pdf, 1e-6 * at.pdf);
              EXPECT_LT(first, at.distance * (1 + 1e-6)) << i % area_kinds;
              if (first > at.distance * (1 - 1e-6)) {
                const double one = (2 + dot(at.wi, axis)) / at.pdf;
                drawn += one / count, drawn_square += one * one / count;
              }
            }
            const double height = 1 - rise * random.unit();
            const double aside = std::sqrt(1 - height * height), turn = 2 * pi * random.unit();
            const Vec3d wi = frame.n * height + frame.u * (aside * std::cos(turn)) +
                             frame.v * (aside * std::sin(turn));
            const double one =
                hit(area, p, wi) < Aabb::far ? (2 + dot(wi, axis)) * 2 * pi * rise : 0;
            even += one / count, even_square += one * one / count;
          }
          const double error = std::sqrt((drawn_square - drawn * drawn) / count +
                                         (even_square - even * even) / count);
          EXPECT_NEAR(drawn, even, 4 * error + 1e-9) << i % area_kinds;
        },
        any);
  }
}

// The eighth of the sphere, and a face of a cube seen from its middle.
TEST(Areas, SolidAnglesAreKnownOnes) {
  EXPECT_NEAR(SphericalTriangle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}).solid_angle, pi / 2, 1e-12);
  EXPECT_NEAR(SphericalRectangle({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}).solid_angle, 4 * pi / 6, 1e-12);
  const BoxArea box{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(pdf_area(box, {0.5, 0.2, -0.7}, {1, 0, 0}, 1), 0) << "inside";
  EXPECT_NEAR(1 / pdf_area(box, {0, 0, 2}, {0, 0, -1}, 1), 4 * pi / 6, 1e-12);
}

}  // namespace
}  // namespace tia
