#include "core/scene/projections/module_image.h"

#include <algorithm>

namespace tia {

std::array<double, 2> ScreenWarp::at(double u, double v) const {
  const double x = std::clamp(u, 0.0, 1.0) * (columns - 1);
  const double y = std::clamp(v, 0.0, 1.0) * (rows - 1);
  const int i = std::min(static_cast<int>(x), columns - 2);
  const int j = std::min(static_cast<int>(y), rows - 2);
  const double s = x - i, t = y - j;
  const auto point = [&](int column, int row) {
    return off[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column)];
  };
  const auto a = point(i, j), b = point(i + 1, j), c = point(i, j + 1), d = point(i + 1, j + 1);
  const auto between = [&](std::size_t k) {
    return (a[k] * (1 - s) + b[k] * s) * (1 - t) + (c[k] * (1 - s) + d[k] * s) * t;
  };
  return {between(0), between(1)};
}

template <>
void ModuleImage::shift(const Raster<double>& at, double& x, double& y) const {
  const auto by = warp->at((at.x + 1) / 2, (1 - at.y) / 2);
  x += by[0];
  y += by[1];
}
template <>
void ModuleImage::shift(const Raster<Octet>& at, Octet& x, Octet& y) const {
  std::array<double, Octet::size> at_x, at_y, each_x, each_y;
  at.x.store_unaligned(at_x.data()), at.y.store_unaligned(at_y.data());
  x.store_unaligned(each_x.data()), y.store_unaligned(each_y.data());
  for (std::size_t i = 0; i < Octet::size; ++i)
    shift(Raster<double>{at_x[i], at_y[i]}, each_x[i], each_y[i]);
  x = Octet::load_unaligned(each_x.data());
  y = Octet::load_unaligned(each_y.data());
}

}  // namespace tia
