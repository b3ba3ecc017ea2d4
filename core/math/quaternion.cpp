#include "core/math/quaternion.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {

Quaternion normalized(const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0)) return {0, 0, 0, 1};
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Affine rotation_of(const Quaternion& q) {
  auto [x, y, z, w] = q;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  x /= length, y /= length, z /= length, w /= length;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)},
          {}};
}

Quaternion slerp(const Quaternion& from, const Quaternion& to, double share) {
  const Quaternion a = normalized(from), b = normalized(to);
  double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double side = cosine < 0 ? -1 : 1;  // q and -q are the same rotation
  cosine = std::min(1.0, cosine * side);
  const double angle = acos_of(cosine), sine = sin_of(angle);
  // Where the angle is so small, the sphere is flat to double's precision.
  const bool flat = sine < 1e-9;
  const double of_a = flat ? 1 - share : sin_of((1 - share) * angle) / sine;
  const double of_b = side * (flat ? share : sin_of(share * angle) / sine);
  Quaternion q{};
  for (std::size_t i = 0; i < 4; ++i) q[i] = of_a * a[i] + of_b * b[i];
  return normalized(q);
}

}  // namespace tia
