// What one viewer sees of an array of projectors behind a screen.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/projections/module_image.h"

namespace tia {

/// ModuleSlice: of the viewer at x = `viewer` on the observers' line. The line from his eye through
/// a point of the screen meets that of the modules at x - (viewer - x) behind / distance: he sees
/// the ray of the module nearest to there, beyond the outermost by more than half of a gap none.
/// A warp says which of a module's pixels shows a point, not what is seen there.
struct ModuleSlice {
  ModuleImage wall;  ///< but for one module and its warp
  double viewer = 0;
  std::shared_ptr<const std::vector<double>> modules{};  ///< their x, ascending; at least two

  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    const S x = at.x * S(wall.half_width), y = at.y * S(wall.half_height);
    const S meets = x - (S(viewer) - x) * S(wall.behind / wall.distance);
    LocalRay<S> ray = wall.through(x, y, nearest(meets));
    ray.seen = meets >= S(first()) && meets <= S(last());
    return ray;
  }
  PixelCone cone(int width, int height) const { return wall.cone(width, height); }

 private:
  double nearest(double x) const;
  Octet nearest(const Octet& x) const;
  double first() const { return modules->front() - (modules->at(1) - modules->front()) / 2; }
  double last() const {
    return modules->back() + (modules->back() - modules->at(modules->size() - 2)) / 2;
  }
};

}  // namespace tia
