// How much lights may give a point, by their bounds: one text for one node of a tree and for a
// register of them.
#pragma once

#include <array>
#include <cmath>

#include "core/lights/light_bounds.h"
#include "core/math/double_register.h"

namespace tia {

template <class Real>
[[gnu::always_inline]] inline Real sine_of(const Real& cosine) {
  using std::sqrt;
  return sqrt(max_of(Real(1.0) - cosine * cosine, Real(0.0)));
}
/// The cosine of max(0, a - b).
template <class Real>
[[gnu::always_inline]] inline Real cos_of_rest(const Real& sin_a, const Real& cos_a,
                                               const Real& sin_b, const Real& cos_b) {
  return select(cos_a > cos_b, Real(1.0), cos_a * cos_b + sin_a * sin_b);
}
template <class Real>
[[gnu::always_inline]] inline Real clamped(const Real& cosine) {
  return min_of(Real(1.0), max_of(Real(-1.0), cosine));
}

/// Shine: what the importance of lights needs of their bounds.
template <class Real>
struct Shine {
  Vec3<Real> center, axis;
  Real radius_square, power, cos_o, sin_o, cos_e;
  Real two_sided;  ///< 1, or else 0

  /// Of the words of words_of. Domain: word(k) returns the k-th.
  template <class Word>
  [[gnu::always_inline]] static Shine of(Word word) {
    return {{word(0), word(1), word(2)},
            {word(3), word(4), word(5)},
            word(6),
            word(7),
            word(8),
            word(9),
            word(10),
            word(11)};
  }
};
inline std::array<double, 12> words_of(const LightBounds& b) {
  const Vec3d center = b.box.center(), half = b.box.size() * 0.5, &axis = b.axis;
  return {center.x,        center.y, center.z, axis.x,           axis.y,  axis.z,
          dot(half, half), b.power,  b.cos_o,  sine_of(b.cos_o), b.cos_e, b.two_sided ? 1.0 : 0.0};
}

/// LightBounds::importance of each lane, the same to the bit.
template <class Real>
[[gnu::always_inline]] inline Real importance_of(const Shine<Real>& lights, const Vec3d& at,
                                                 const Vec3d& normal) {
  using std::sqrt;
  const Vec3<Real> p(at), n(normal), way = p - lights.center;
  const Real zero(0.0), one(1.0), square = dot(way, way);
  const Real distance_square = max_of(lights.radius_square, square);
  // From within the ball around the box the lights may be anywhere.
  const Mask<Real> inside = square <= lights.radius_square;
  const Vec3<Real> wi = select<Real>(square > zero, way * (one / sqrt(square)), {zero, zero, one});
  const Real cos_b = select(inside, -one, sqrt(one - lights.radius_square / square));
  const Real sin_b = sine_of(cos_b);
  const Real cosine = clamped(dot(lights.axis, wi)), &cos_o = lights.cos_o, &sin_o = lights.sin_o;
  const Real cos_w = select(lights.two_sided > zero, abs_of(cosine), cosine);
  const Mask<Real> within = cos_w > cos_o;
  Real cos_x = one, sin_x = zero;
  if (any(!within)) {
    const Real sin_w = sine_of(cos_w);
    cos_x = cos_of_rest(sin_w, cos_w, sin_o, cos_o);
    sin_x = select(within, zero, max_of(sin_w * cos_o - cos_w * sin_o, zero));
  }
  const Real facing = select(inside, one, cos_of_rest(sin_x, cos_x, sin_b, cos_b));
  const Real cos_i = abs_of(clamped(dot(wi, n)));
  const Mask<Real> any_side(normal == Vec3d{});
  const Real lit =
      select(inside || any_side, one, cos_of_rest(sine_of(cos_i), cos_i, sin_b, cos_b));
  const Real share = max_of(lights.power * facing * lit / distance_square, zero);
  return select(distance_square > zero, select(facing <= lights.cos_e, zero, share), lights.power);
}

}  // namespace tia
