#include "core/lights/spherical.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

template <class S>
S angle_between(const Vec3<S>& a, const Vec3<S>& b) {
  return atan2_of(length(cross(a, b)), dot(a, b));
}
// As std::clamp() and std::max(): x, where they do not compare.
template <class S>
S clamped(const S& x, const S& low, const S& high) {
  return select(x < low, low, select(high < x, high, x));
}
template <class S>
S at_least(const S& x, const S& low) {
  return select(x < low, low, x);
}
double with_sign_of(double x, double sign) { return std::copysign(x, sign); }
Octet with_sign_of(const Octet& x, const Octet& sign) {
  return Octet::map([](const auto& a, const auto& b) { return xsimd::copysign(a, b); }, x, sign);
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

template <class S>
SphericalRectangle<S>::SphericalRectangle(const Vec3<S>& to_corner, const Vec3d& u, const Vec3d& v)
    : x_(normalize(u)), y_(normalize(v)), z_(cross(x_, y_)) {
  using std::sqrt;
  const auto along = [&](const Vec3d& axis) { return dot(to_corner, static_cast<Vec3<S>>(axis)); };
  x0_ = along(x_), y0_ = along(y_), height_ = along(z_);
  z0_ = select(height_ > S(0), -height_, height_);
  x1_ = x0_ + S(length(u)), y1_ = y0_ + S(length(v));
  // The angles inside are those between the planes through the edges, whose normals these are.
  const S zero(0);
  const auto share = [&](const S& edge) { return edge / sqrt(edge * edge + z0_ * z0_); };
  const auto rest = [&](const S& edge) { return z0_ / sqrt(edge * edge + z0_ * z0_); };
  const Vec3<S> n0{zero, rest(y0_), -share(y0_)}, n1{-rest(x1_), zero, share(x1_)};
  const Vec3<S> n2{zero, -rest(y1_), share(y1_)}, n3{rest(x0_), zero, -share(x0_)};
  b0_ = n0.z, b1_ = n2.z;
  const S g0 = angle_between(-n0, n1), g1 = angle_between(-n1, n2);
  const S g2 = angle_between(-n2, n3), g3 = angle_between(-n3, n0);
  k_ = S(2 * pi) - g2 - g3;
  const S angle = g0 + g1 - k_;  // NaN: the point is in the plane of an edge
  solid_angle = select(angle > zero, angle, zero);
}

template <class S>
Vec3<S> SphericalRectangle<S>::sample(const S& u, const S& v) const {
  using std::sqrt;
  const S one(1), angle = u * solid_angle + k_;
  const auto [sine, cosine] = sincos_of(angle);
  const S fu = (cosine * b0_ - b1_) / sine;
  const S cu = clamped(with_sign_of(one / sqrt(fu * fu + b0_ * b0_), fu), S(-1), one);
  const S xu = clamped(-(cu * z0_) / sqrt(at_least(one - cu * cu, S(1e-300))), x0_, x1_);
  const S d = sqrt(xu * xu + z0_ * z0_);
  const S h0 = y0_ / sqrt(d * d + y0_ * y0_), h1 = y1_ / sqrt(d * d + y1_ * y1_);
  const S hv = h0 + v * (h1 - h0), square = hv * hv;
  const S yv = select(square < S(1 - 1e-12), hv * d / sqrt(one - square), y1_);
  const auto out = [](const Vec3d& axis, const S& by) { return static_cast<Vec3<S>>(axis) * by; };
  return normalize(out(x_, xu) + out(y_, yv) + out(z_, height_));
}

template struct SphericalRectangle<double>;
template struct SphericalRectangle<Octet>;

}  // namespace tia
