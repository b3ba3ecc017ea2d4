// Directions drawn to luminous areas: they meet the area, as dense as the density says.
#include "core/lights/areas.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <variant>

#include "core/lights/spherical.h"
#include "core/lights/sun.h"
#include "core/math/deterministic.h"
#include "core/math/onb.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using test::rounds;

using AnyArea =
    std::variant<TriangleArea, QuadArea, DiscArea, BoxArea, CylinderArea, SphereForm, SunForm>;

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
    case 5: return CylinderArea{p, x, a};
    case 6: return SphereForm{p, 2 * a};
    default: {
      // The sun's disc, as large as can be seen well.
      const double sine = random.in(0.1, 0.5);
      return SunForm{random.direction(), sine * sine, 1 - std::sqrt(1 - sine * sine)};
    }
  }
}
constexpr int area_kinds = 8;

// Lights that draw lane by lane, as if they were areas.
constexpr double far_away = 1e9;
template <class Form>
AreaSample sample_area(const Form& form, const Vec3d& p, double u, double v) {
  const LightSample<double> at = sample_li(form, p, u, v);
  return {at.wi, std::min(at.distance, far_away), pdf_li(form, p, at.wi, at.distance)};
}
template <class Form>
double pdf_area(const Form& form, const Vec3d& p, const Vec3d& wi, double distance) {
  return pdf_li(form, p, wi, distance);
}

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

double hit(const SphereForm& ball, const Vec3d& p, const Vec3d& wi) {
  const Vec3d to = lift<double>(ball.middle) - p;
  const double along = dot(to, wi), reach = along * along - dot(to, to) + ball.radius * ball.radius;
  return reach >= 0 && along > 0 ? along - std::sqrt(reach) : Aabb::far;
}
double hit(const SunForm& sun, const Vec3d&, const Vec3d& wi) {
  const double c = dot(lift<double>(sun.wi), wi);
  return c > std::sqrt(1 - sun.sine_square) ? far_away : Aabb::far;
}

// A cone of directions that holds the area.
struct Cone {
  Onb frame;
  double rise;  // 1 - the cosine at its edge
  Vec3d at(double u, double v) const {
    const double height = 1 - rise * u, aside = std::sqrt(1 - height * height);
    return frame.n * height + frame.u * (aside * std::cos(2 * pi * v)) +
           frame.v * (aside * std::sin(2 * pi * v));
  }
};
template <class Form>
Cone cone_of(const Form& area, const Vec3d& p) {
  if constexpr (std::is_same_v<Form, SunForm>)
    return {onb_around(lift<double>(area.wi)), 1.2 * area.rise};
  else {
    Vec3d middle;
    double reach;
    if constexpr (std::is_same_v<Form, SphereForm>)
      middle = lift<double>(area.middle), reach = 1.1 * area.radius;
    else middle = extent_of(area).box.center(), reach = length(extent_of(area).box.size()) / 2;
    const double sine = reach / length(middle - p);
    return {onb_around(normalize(middle - p)), 1 - std::sqrt(1 - std::min(sine * sine, 1.0))};
  }
}

// What is drawn to an area, in cells of a cone around it, beside what its density says of each cell
// that the area fills, by directions spread over the cone; and the integral of a ramp over what is
// seen, by both.
struct Drawn {
  static constexpr int cells = 16, finer = 8, count = 1 << 12;
  std::array<double, cells * cells> expected{}, got{};
  std::array<int, cells * cells> filled{};
  double drawn = 0, drawn_square = 0, even = 0, even_square = 0;

  template <class Form>
  Drawn(const Form& area, const Vec3d& p, Random& random) {
    const Vec3d axis = random.direction();
    const Cone cone = cone_of(area, p);
    constexpr int side = cells * finer;
    constexpr double share = 1.0 / (side * side);
    for (int i = 0; i < side * side; ++i) {
      const double u = (i / side + random.unit()) / side, v = (i % side + random.unit()) / side;
      const Vec3d wi = cone.at(u, v);
      const double distance = hit(area, p, wi), solid_angle = 2 * pi * cone.rise;
      if (!(distance < Aabb::far)) continue;
      const double one = (2 + dot(wi, axis)) * solid_angle;
      even += one * share, even_square += one * one * share;
      const std::size_t at = cell(i / side / finer, i % side / finer);
      expected[at] += pdf_area(area, p, wi, distance) * solid_angle * share * count, ++filled[at];
    }
    for (int k = 0; k < count; ++k) {
      const double u = random.unit();
      const AreaSample at = sample_area(area, p, u, random.unit());
      if (!(at.pdf > 0)) continue;
      const double first = hit(area, p, at.wi);
      EXPECT_NEAR(pdf_area(area, p, at.wi, at.distance), at.pdf, 1e-6 * at.pdf);
      EXPECT_LT(first, at.distance * (1 + 1e-6));
      if (!(first > at.distance * (1 - 1e-6))) continue;  // its other side
      const double one = (2 + dot(at.wi, axis)) / at.pdf;
      drawn += one / count, drawn_square += one * one / count;
      const Vec3d w = cone.frame.local(at.wi);
      const double turn = std::atan2(w.y, w.x) / (2 * pi);
      ++got[cell(static_cast<int>((1 - w.z) / cone.rise * cells),
                 static_cast<int>((turn < 0 ? turn + 1 : turn) * cells))];
    }
  }
  static std::size_t cell(int row, int column) {
    return static_cast<std::size_t>(std::clamp(row, 0, cells - 1) * cells +
                                    std::clamp(column, 0, cells - 1));
  }
  // Pearson's sum over the filled cells, as standard deviations from its mean.
  int filled_cells() const {
    return static_cast<int>(std::count(filled.begin(), filled.end(), finer * finer));
  }
  double surprise() const {
    double statistic = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
      if (filled[k] == finer * finer)
        statistic += (got[k] - expected[k]) * (got[k] - expected[k]) / expected[k];
    return (statistic - filled_cells()) / std::sqrt(2.0 * std::max(filled_cells(), 1));
  }
  double error() const {
    return std::sqrt((drawn_square - drawn * drawn) / count +
                     (even_square - even * even) / (cells * cells * finer * finer));
  }
};

TEST(Areas, DrawnDirectionsMeetWhatIsThereAsDenseAsTheySay) {
  Random random(950);
  int filled = 0;
  for (int i = 0; i < rounds(104, 8); ++i) {
    const AnyArea any = random_area(random, i % area_kinds);
    const Vec3d p = random.direction() * random.in(3, 5);
    std::visit(
        [&](const auto& area) {
          const Drawn drawn(area, p, random);
          EXPECT_NEAR(drawn.drawn, drawn.even, 4 * drawn.error() + 1e-9) << i % area_kinds;
          EXPECT_LT(drawn.surprise(), 5) << i % area_kinds;
          filled += drawn.filled_cells();
        },
        any);
  }
  EXPECT_GT(filled, rounds(104, 8) * 30);
}

// The eighth of the sphere, and a face of a cube seen from its middle.
// Points in the plane of the area, on its edges and behind it among them.
TEST(Areas, EightPointsDrawAsEachDoes) {
  Random random(153);
  for (int round = 0; round < rounds(500, 50); ++round) {
    const QuadArea area = std::get<QuadArea>(random_area(random, random.whole(1, 2)));
    std::array<std::array<double, Octet::size>, 5> in;
    for (std::size_t i = 0; i < Octet::size; ++i) {
      const double far = random.below(3) == 0 ? 100 : 1;
      Vec3d p = area.corner + random.vector(0.01, far);
      if (i == 0) p = area.corner + area.u * random.in(-1, 2) + area.v * random.in(-1, 2);
      if (i == 1) p = area.corner + area.v;
      in[0][i] = p.x, in[1][i] = p.y, in[2][i] = p.z;
      in[3][i] = random.in(0, 1), in[4][i] = random.in(0, 1);
    }
    const auto eight = [&](std::size_t row) { return Octet::load_unaligned(in[row].data()); };
    const AreaSamples<Octet> at =
        sample_area(area, Vec3<Octet>{eight(0), eight(1), eight(2)}, eight(3), eight(4));
    for (std::size_t i = 0; i < Octet::size; ++i) {
      const AreaSample one =
          sample_area(area, Vec3d{in[0][i], in[1][i], in[2][i]}, in[3][i], in[4][i]);
      const auto same = [&](const Octet& of_eight, double alone) {
        const double own = lane(of_eight, static_cast<int>(i));
        return std::bit_cast<std::uint64_t>(own) == std::bit_cast<std::uint64_t>(alone) ||
               (std::isnan(own) && std::isnan(alone));
      };
      EXPECT_TRUE(same(at.wi.x, one.wi.x) && same(at.wi.y, one.wi.y) && same(at.wi.z, one.wi.z) &&
                  same(at.distance, one.distance) && same(at.pdf, one.pdf))
          << round << ", lane " << i;
    }
  }
}

TEST(Areas, SolidAnglesAreKnownOnes) {
  EXPECT_NEAR(SphericalTriangle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}).solid_angle, pi / 2, 1e-12);
  EXPECT_NEAR(SphericalRectangle<double>({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}).solid_angle, 4 * pi / 6,
              1e-12);
  const BoxArea box{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(pdf_area(box, {0.5, 0.2, -0.7}, {1, 0, 0}, 1), 0) << "inside";
  EXPECT_NEAR(1 / pdf_area(box, {0, 0, 2}, {0, 0, -1}, 1), 4 * pi / 6, 1e-12);
}

}  // namespace
}  // namespace tia
