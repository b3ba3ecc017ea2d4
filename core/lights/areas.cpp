#include "core/lights/areas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/lights/spherical.h"
#include "core/math/deterministic.h"
#include "core/math/onb.h"
#include "core/math/warp.h"

namespace tia {
namespace {

template <class S>
AreaSamples<S> chosen(const Mask<S>& mask, const AreaSamples<S>& a, const AreaSamples<S>& b) {
  return {select(mask, a.wi, b.wi), select(mask, a.distance, b.distance),
          select(mask, a.pdf, b.pdf)};
}

// The density of points even over an area by solid angle. `facing`: the area times the cosine.
template <class S>
S by_solid_angle(const S& distance, const S& facing) {
  return select(facing > S(0), distance * distance / facing, S(0));
}
template <class S>
AreaSamples<S> towards(const Vec3<S>& p, const Vec3<S>& q) {
  const Vec3<S> way = q - p;
  const S distance = length(way);
  const AreaSamples<S> none;
  const Mask<S> apart = distance > S(0);
  return {select(apart, way * (S(1) / distance), none.wi), select(apart, distance, S(0)), S(0)};
}
// To the point of a plane through q that lies in that direction.
template <class S>
AreaSamples<S> along(const Vec3<S>& wi, const Vec3<S>& p, const Vec3<S>& q, const Vec3<S>& n,
                     const S& pdf) {
  const S distance = dot(n, q - p) / dot(n, wi);
  const Mask<S> before = distance > S(0) && distance < S(Aabb::far);
  return chosen<S>(before, {wi, distance, pdf}, {});
}

bool is_right(const QuadArea& area) {
  return std::fabs(dot(area.u, area.v)) <= 1e-6 * length(area.u) * length(area.v);
}

Aabb box_of(const Vec3d& middle, const Vec3d& reach) { return {middle - reach, middle + reach}; }
// Half the box around a sum of three vectors of either sign.
Vec3d sum_of_sizes(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  return {std::fabs(x.x) + std::fabs(y.x) + std::fabs(z.x),
          std::fabs(x.y) + std::fabs(y.y) + std::fabs(z.y),
          std::fabs(x.z) + std::fabs(y.z) + std::fabs(z.z)};
}

}  // namespace

// ---- triangle -------------------------------------------------------------------------------

AreaSample sample_area(const TriangleArea& area, const Vec3d& p, double u, double v) {
  const SphericalTriangle seen(area.a - p, area.a + area.ab - p, area.a + area.ac - p);
  const Vec3d n = cross(area.ab, area.ac);
  if (seen.solid_angle > least_solid_angle)
    return along(seen.sample(u, v), p, area.a, n, 1 / seen.solid_angle);
  const double root = std::sqrt(u);
  AreaSample at = towards(p, area.a + area.ab * (1 - root) + area.ac * (v * root));
  at.pdf = by_solid_angle(at.distance, std::fabs(dot(n, at.wi)) / 2);
  return at;
}
double pdf_area(const TriangleArea& area, const Vec3d& p, const Vec3d& wi, double distance) {
  const SphericalTriangle seen(area.a - p, area.a + area.ab - p, area.a + area.ac - p);
  if (seen.solid_angle > least_solid_angle) return 1 / seen.solid_angle;
  return by_solid_angle(distance, std::fabs(dot(cross(area.ab, area.ac), wi)) / 2);
}
Extent extent_of(const TriangleArea& area) {
  const Vec3d n = cross(area.ab, area.ac);
  return {around(around(around(Aabb{}, area.a), area.a + area.ab), area.a + area.ac), length(n) / 2,
          n};
}

// ---- quad -----------------------------------------------------------------------------------

namespace {

template <class S>
AreaSamples<S> sample_quad(const QuadArea& area, const Vec3<S>& p, const S& u, const S& v) {
  const auto lifted = [](const Vec3d& each) { return static_cast<Vec3<S>>(each); };
  const Vec3<S> n = lifted(cross(area.u, area.v)), corner = lifted(area.corner);
  AreaSamples<S> evenly;
  Mask<S> large = S(0) > S(1);
  if (is_right(area)) {
    const SphericalRectangle<S> seen(corner - p, area.u, area.v);
    large = seen.solid_angle > S(least_solid_angle);
    if (any(large)) evenly = along(seen.sample(u, v), p, corner, n, S(1) / seen.solid_angle);
  }
  if (!any(!large)) return evenly;
  AreaSamples<S> at = towards(p, corner + lifted(area.u) * u + lifted(area.v) * v);
  at.pdf = by_solid_angle(at.distance, abs_of(dot(n, at.wi)));
  return chosen<S>(large, evenly, at);
}

}  // namespace

AreaSample sample_area(const QuadArea& area, const Vec3d& p, double u, double v) {
  return sample_quad(area, p, u, v);
}
AreaSamples<Octet> sample_area(const QuadArea& area, const Vec3<Octet>& p, const Octet& u,
                               const Octet& v) {
  return sample_quad(area, p, u, v);
}
double pdf_area(const QuadArea& area, const Vec3d& p, const Vec3d& wi, double distance) {
  if (is_right(area)) {
    const SphericalRectangle<double> seen(area.corner - p, area.u, area.v);
    if (seen.solid_angle > least_solid_angle) return 1 / seen.solid_angle;
  }
  return by_solid_angle(distance, std::fabs(dot(cross(area.u, area.v), wi)));
}
Extent extent_of(const QuadArea& area) {
  const Vec3d half = (area.u + area.v) * 0.5, n = cross(area.u, area.v);
  return {box_of(area.corner + half, sum_of_sizes(area.u, area.v, {}) * 0.5), length(n), n};
}

// ---- disc -----------------------------------------------------------------------------------

AreaSample sample_area(const DiscArea& area, const Vec3d& p, double u, double v) {
  const DiscPoint<double> at = square_to_disc(u, v);
  AreaSample sample = towards(p, area.center + area.x * at.x + area.y * at.y);
  sample.pdf = pdf_area(area, p, sample.wi, sample.distance);
  return sample;
}
double pdf_area(const DiscArea& area, const Vec3d&, const Vec3d& wi, double distance) {
  return by_solid_angle(distance, pi * std::fabs(dot(cross(area.x, area.y), wi)));
}
Extent extent_of(const DiscArea& area) {
  const auto reach = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const Vec3d n = cross(area.x, area.y);
  return {box_of(area.center,
                 {reach(area.x.x, area.y.x), reach(area.x.y, area.y.y), reach(area.x.z, area.y.z)}),
          pi * length(n), n};
}

// ---- box ------------------------------------------------------------------------------------

namespace {

/// SeenFaces: the faces of a box that a point outside of it sees, three at most.
struct SeenFaces {
  struct Face {
    QuadArea quad;
    SphericalRectangle<double> seen;
  };
  std::array<Face, 3> faces;
  std::size_t count = 0;
  double solid_angle = 0;

  SeenFaces(const BoxArea& box, const Vec3d& p) {
    const std::array axes{box.x, box.y, box.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d &n = axes[i], &u = axes[(i + 1) % 3], &v = axes[(i + 2) % 3];
      const double aside = dot(p - box.center, n), reach = dot(n, n);
      // What rounding may have put beside the face that it is on is inside.
      if (std::fabs(aside) <= reach * (1 + 1e-5)) continue;
      const QuadArea quad{box.center + n * (aside > 0 ? 1.0 : -1.0) - u - v, u * 2.0, v * 2.0};
      faces[count] = {quad, SphericalRectangle<double>(quad.corner - p, quad.u, quad.v)};
      solid_angle += faces[count++].seen.solid_angle;
    }
  }
};

}  // namespace

AreaSample sample_area(const BoxArea& area, const Vec3d& p, double u, double v) {
  const SeenFaces box(area, p);
  if (!(box.solid_angle > 0)) return {};
  double left = u * box.solid_angle;
  std::size_t i = 0;
  while (i + 1 < box.count && left >= box.faces[i].seen.solid_angle)
    left -= box.faces[i++].seen.solid_angle;
  const auto& [quad, seen] = box.faces[i];
  const double share = std::min(left / seen.solid_angle, 1.0);
  return along(seen.sample(share, v), p, quad.corner, cross(quad.u, quad.v), 1 / box.solid_angle);
}
double pdf_area(const BoxArea& area, const Vec3d& p, const Vec3d&, double) {
  const SeenFaces box(area, p);
  return box.solid_angle > 0 ? 1 / box.solid_angle : 0;
}
Extent extent_of(const BoxArea& area) {
  const double x = length(area.x), y = length(area.y), z = length(area.z);
  return {box_of(area.center, sum_of_sizes(area.x, area.y, area.z)), 8 * (x * y + y * z + z * x)};
}

// ---- cylinder -------------------------------------------------------------------------------

namespace {

double surface_of(const CylinderArea& c) { return 2 * pi * c.radius * (length(c.axis) + c.radius); }

}  // namespace

AreaSample sample_area(const CylinderArea& area, const Vec3d& p, double u, double v) {
  const double height = length(area.axis), whole = height + area.radius;
  const Onb frame = onb_around(area.axis * (1 / height));
  const double at = u * whole;
  Vec3d q = area.base;
  if (at < height) {
    const auto [sine, cosine] = sincos_of(2 * pi * v);
    q = q + area.axis * (at / height) + (frame.u * cosine + frame.v * sine) * area.radius;
  } else {
    // Two discs, each of half the radius' share.
    const double share = std::min(2 * (at - height) / area.radius, 1.999999999);
    const bool is_cap = share >= 1;
    const DiscPoint<double> d = square_to_disc(is_cap ? share - 1 : share, v);
    q = q + (frame.u * d.x + frame.v * d.y) * area.radius + area.axis * (is_cap ? 1.0 : 0.0);
  }
  AreaSample sample = towards(p, q);
  sample.pdf = pdf_area(area, p, sample.wi, sample.distance);
  return sample;
}
double pdf_area(const CylinderArea& area, const Vec3d& p, const Vec3d& wi, double distance) {
  const double height = length(area.axis);
  const Vec3d n = area.axis * (1 / height), q = p + wi * distance - area.base;
  const double up = dot(q, n);
  const Vec3d aside = q - n * up;
  const double out = length(aside);
  const bool on_side =
      std::fabs(out - area.radius) < std::min(std::fabs(up), std::fabs(height - up));
  const double cosine = on_side ? dot(aside, wi) / out : dot(n, wi);
  return by_solid_angle(distance, surface_of(area) * std::fabs(cosine));
}
Extent extent_of(const CylinderArea& area) {
  const Vec3d half = area.axis * 0.5;
  const Onb frame = onb_around(half * (1 / length(half)));
  const Vec3d reach = sum_of_sizes(half, frame.u * area.radius, frame.v * area.radius);
  return {box_of(area.base + half, reach), surface_of(area)};
}

}  // namespace tia
