#include "core/lights/light_importance.h"

namespace tia {

double LightBounds::importance(const Vec3d& p, const Vec3d& n) const {
  const auto words = words_of(*this);
  return importance_of(Shine<double>::of([&](std::size_t k) { return words[k]; }), p, n);
}

}  // namespace tia
