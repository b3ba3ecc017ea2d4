#include "core/shapes/composite/group.h"

#include "core/input/codec.h"

namespace tia {

// In double: three counts of 2^24 overflow an integer.
std::int64_t Repeat::copies() const {
  const double product = double(count[0]) * count[1] * count[2];
  return product > double(most) ? most + 1 : static_cast<std::int64_t>(product);
}

void Repeat::check(const Place& at, Faults& faults) const {
  const bool in_place = (count[0] > 1 && step.x == 0) || (count[1] > 1 && step.y == 0) ||
                        (count[2] > 1 && step.z == 0);
  if (in_place)
    faults.add({FaultKind::out_of_range, at.at("step").pointer(), write_value(step),
                "not 0 where there is more than one copy"});
}

Aabb Repeat::swept(const Aabb& box) const {
  if (box.empty() || !box.bounded()) return box;
  const Vec3d last = offset(count[0] - 1, count[1] - 1, count[2] - 1);
  return around(box, Aabb{box.min + last, box.max + last});
}

}  // namespace tia
