#include "core/lights/spherical.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

double angle_between(const Vec3d& a, const Vec3d& b) {
  return atan2_of(length(cross(a, b)), dot(a, b));
}
// The part of v across the unit vector w, unit.
Vec3d across(const Vec3d& v, const Vec3d& w) { return normalize(v - w * dot(v, w)); }

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3d& to_a, const Vec3d& to_b, const Vec3d& to_c)
    : a(normalize(to_a)), b(normalize(to_b)), c(normalize(to_c)) {
  const double volume = std::fabs(dot(a, cross(b, c)));
  const double angle = 2 * atan2_of(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
  solid_angle = angle > 0 ? angle : 0;  // NaN: a corner is the point
}

Vec3d SphericalTriangle::sample(double u, double v) const {
  const Vec3d n_ab = cross(a, b), n_bc = cross(b, c), n_ca = cross(c, a);
  const double alpha = angle_between(n_ab, -n_ca), beta = angle_between(n_bc, -n_ab),
               gamma = angle_between(n_ca, -n_bc);
  // The triangle of u times the area with the same corner a, and its third corner on the edge ac.
  const double area = pi + u * (alpha + beta + gamma - pi);
  const auto [sin_alpha, cos_alpha] = sincos_of(alpha);
  const auto [sin_area, cos_area] = sincos_of(area);
  const double sin_phi = sin_area * cos_alpha - cos_area * sin_alpha;
  const double cos_phi = cos_area * cos_alpha + sin_area * sin_alpha;
  const double k1 = cos_phi + cos_alpha, k2 = sin_phi - sin_alpha * dot(a, b);
  double cosine = (k2 + (k2 * cos_phi - k1 * sin_phi) * cos_alpha) /
                  ((k2 * sin_phi + k1 * cos_phi) * sin_alpha);
  cosine = cosine >= -1 ? std::min(cosine, 1.0) : -1;
  const Vec3d third = a * cosine + across(c, a) * std::sqrt(1 - cosine * cosine);
  // On the arc from b to there.
  const double height = 1 - v * (1 - dot(third, b));
  const double aside = std::sqrt(std::max(0.0, 1 - height * height));
  return normalize(b * height + across(third, b) * aside);
}

SphericalRectangle::SphericalRectangle(const Vec3d& to_corner, const Vec3d& u, const Vec3d& v)
    : x_(normalize(u)), y_(normalize(v)), z_(cross(x_, y_)) {
  x0_ = dot(to_corner, x_), y0_ = dot(to_corner, y_), z0_ = dot(to_corner, z_);
  if (z0_ > 0) z_ = -z_, z0_ = -z0_;
  x1_ = x0_ + length(u), y1_ = y0_ + length(v);
  // The angles inside are those between the planes through the edges, whose normals these are.
  const auto share = [&](double edge) { return edge / std::sqrt(edge * edge + z0_ * z0_); };
  const auto rest = [&](double edge) { return z0_ / std::sqrt(edge * edge + z0_ * z0_); };
  const Vec3d n0{0, rest(y0_), -share(y0_)}, n1{-rest(x1_), 0, share(x1_)};
  const Vec3d n2{0, -rest(y1_), share(y1_)}, n3{rest(x0_), 0, -share(x0_)};
  b0_ = n0.z, b1_ = n2.z;
  const double g0 = angle_between(-n0, n1), g1 = angle_between(-n1, n2);
  const double g2 = angle_between(-n2, n3), g3 = angle_between(-n3, n0);
  k_ = 2 * pi - g2 - g3;
  const double angle = g0 + g1 - k_;  // NaN: the point is in the plane of an edge
  solid_angle = angle > 0 ? angle : 0;
}

Vec3d SphericalRectangle::sample(double u, double v) const {
  const double angle = u * solid_angle + k_;
  const auto [sine, cosine] = sincos_of(angle);
  const double fu = (cosine * b0_ - b1_) / sine;
  const double cu = std::clamp(std::copysign(1 / std::sqrt(fu * fu + b0_ * b0_), fu), -1.0, 1.0);
  const double xu = std::clamp(-(cu * z0_) / std::sqrt(std::max(1 - cu * cu, 1e-300)), x0_, x1_);
  const double d = std::sqrt(xu * xu + z0_ * z0_);
  const double h0 = y0_ / std::sqrt(d * d + y0_ * y0_), h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
  const double hv = h0 + v * (h1 - h0), square = hv * hv;
  const double yv = square < 1 - 1e-12 ? hv * d / std::sqrt(1 - square) : y1_;
  return normalize(x_ * xu + y_ * yv + z_ * z0_);
}

}  // namespace tia
