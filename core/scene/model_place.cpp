#include "core/scene/model_place.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tia {

Affine upright(UpAxis up) {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  switch (up) {
    case UpAxis::z: return {x, -z, y, {}};
    case UpAxis::minus_z: return {x, z, -y, {}};
    case UpAxis::minus_y: return {x, -y, -z, {}};
    case UpAxis::x: return {y, -x, z, {}};
    case UpAxis::minus_x: return {-y, x, z, {}};
    case UpAxis::y: break;
  }
  return {};
}

Affine fitted(const Fit& fit, const Aabb& box) {
  const Vec3d room = fit.max - fit.min, size = box.size();
  constexpr double none = std::numeric_limits<double>::infinity();
  double scale = none;
  for (const auto& [has, needs] : {std::pair{room.x, size.x}, {room.y, size.y}, {room.z, size.z}})
    if (needs > 0) scale = std::min(scale, has / needs);
  if (scale == none) scale = 1;
  const Vec3d spare = room - size * scale;
  const Vec3d aligned{spare.x * fit.align.x, spare.y * fit.align.y, spare.z * fit.align.z};
  Affine map = Affine::scaling({scale, scale, scale});
  map.offset = fit.min + aligned - box.min * scale;
  return map;
}

}  // namespace tia
