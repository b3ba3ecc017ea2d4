#include "core/scene/view.h"

#include <array>
#include <cmath>

namespace tia {
namespace {

// The pixel's point on the raster from -1 to 1: as View::column and View::row have it.
template <class S>
Raster<S> raster_of(const View& view, const S& px, const S& py) {
  const S w(static_cast<double>(view.width)), h(static_cast<double>(view.height));
  return {(px + px + S(1.0) - w) / w, (h - (py + py) - S(1.0)) / h};
}

template <class S>
Vec3<S> in_frame(const View& view, const Vec3<S>& local) {
  const auto of = [](const Vec3d& axis) { return static_cast<Vec3<S>>(axis); };
  return of(view.right) * local.x + of(view.up) * local.y - of(view.axis) * local.z;
}

// In space, from a local one of the view's form.
template <class S>
LocalRay<S> ray_of(const View& view, const Raster<S>& at) {
  return std::visit(
      [&](const auto& form) -> LocalRay<S> {
        if constexpr (std::is_same_v<std::decay_t<decltype(form)>, FlatView>) {
          return {};  // of no flat view
        } else {
          const LocalRay<S> local = form.ray(at);
          return {static_cast<Vec3<S>>(view.origin) + in_frame(view, local.origin),
                  in_frame(view, local.direction), local.seen};
        }
      },
      view.curved);
}

Vec3f rounded(const Vec3d& v) { return lift<float>(v); }

}  // namespace

template <>
SeenRay<double> curved_ray(const View& view, const double& x, const double& y, const double& dx,
                           const double& dy) {
  const auto ray = ray_of(view, raster_of(view, x + dx, y + dy));
  return {{ray.origin, ray.direction}, ray.seen};
}
template <>
SeenRay<float> curved_ray(const View& view, const float& x, const float& y, const float& dx,
                          const float& dy) {
  const auto [ray, seen] = curved_ray<double>(view, x, y, dx, dy);
  return {{rounded(ray.origin), rounded(ray.direction)}, seen};
}

// Eight lanes at a time.
template <>
SeenRay<Wide> curved_ray(const View& view, const Wide& x, const Wide& y, const Wide& dx,
                         const Wide& dy) {
  constexpr std::size_t n = Wide::size;
  std::array<double, n> px, py;
  (widen(x) + widen(dx)).store_unaligned(px.data());
  (widen(y) + widen(dy)).store_unaligned(py.data());
  std::array<std::array<float, n>, 6> numbers;
  std::array<float, n> seen;
  for (std::size_t i = 0; i < n; i += Octet::size) {
    const auto ray =
        ray_of(view, raster_of(view, Octet::load_unaligned(&px[i]), Octet::load_unaligned(&py[i])));
    const Octet* parts[] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z,
                            &ray.direction.x, &ray.direction.y, &ray.direction.z};
    std::array<double, Octet::size> each;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      parts[k]->store_unaligned(each.data());
      for (std::size_t j = 0; j < each.size(); ++j) numbers[k][i + j] = static_cast<float>(each[j]);
    }
    const unsigned there = bits(ray.seen);
    for (std::size_t j = 0; j < each.size(); ++j) seen[i + j] = static_cast<float>(there >> j & 1U);
  }
  const auto lanes_of = [&](std::size_t k) { return Wide::load_unaligned(numbers[k].data()); };
  return {{{lanes_of(0), lanes_of(1), lanes_of(2)}, {lanes_of(3), lanes_of(4), lanes_of(5)}},
          Wide::load_unaligned(seen.data()) > Wide(0)};
}

PixelCone cone_of(const View& view) {
  return std::visit(
      [&](const auto& form) -> PixelCone {
        if constexpr (std::is_same_v<std::decay_t<decltype(form)>, FlatView>) {
          const double across = 2 * length(view.right) / view.width;
          const double side = std::sqrt(across * (2 * length(view.up) / view.height));
          return view.orthographic() ? PixelCone{side, 0} : PixelCone{0, side};
        } else {
          return form.cone(view.width, view.height);
        }
      },
      view.curved);
}

// At the depth of forward's tip, the window's middle is nearer to the eye's own side by as much as
// the eye has moved, in shares of the depth.
View moved_eye(const View& view, const Vec3d& by, double depth) {
  View moved = view;
  moved.origin = view.origin + by;
  moved.forward = view.forward - by * (dot(view.forward, view.axis) / depth);
  if (view.orthographic()) moved.forward = normalize(moved.forward);
  return moved;
}

}  // namespace tia
