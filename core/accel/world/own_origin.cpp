#include "core/accel/world/own_origin.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

constexpr double near = 64;  // so many sizes away, float keeps 18 of a size's 24 bits

double greatest(const Vec3d& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

}  // namespace

void Crowd::add(const Vec3d& center, double say) {
  sum_ = sum_ + center * say;
  says_ += say;
}

void Crowd::measure(const Vec3d& center, double say, double size) {
  sizes_ += (greatest(center - middle()) + size) * say;
}

Vec3d Crowd::origin() const {
  const Vec3d middle = this->middle();
  const double size = sizes_ / says_, away = greatest(middle);
  if (!(away > near * size && away < 1e300)) return {};  // NaN, where there is nothing
  if (!(size > 0)) return middle;                        // a single unbounded thing has no size
  const double step = std::exp2(std::ilogb(size));
  const auto stepped = [&](double x) { return std::round(x / step) * step; };
  return {stepped(middle.x), stepped(middle.y), stepped(middle.z)};
}

bool Crowd::is_surely_near() const {
  return greatest(middle()) <= near / 2 * (sizes_ / says_);  // NaN, where there is nothing
}

namespace {

class Settling {
 public:
  using Boxes = std::map<int, std::vector<Aabb>>;
  Settling(Geometry& geometry, Boxes& boxes) : geometry_(geometry), boxes_(boxes) {}

  void settle() {
    std::vector<Crowd> bounded(geometry_.spaces.size()), endless = bounded;
    for_each_bounded([&](auto space, const Vec3d& center, double size) {
      bounded[space].add(center, 1 / size);
    });
    for_each_bounded([&](auto space, const Vec3d& center, double size) {
      bounded[space].measure(center, 1 / size, size);
    });
    for_each_place([&](auto space, const Vec3d& place) { endless[space].add(place, 1); });
    for_each_place([&](auto space, const Vec3d& place) { endless[space].measure(place, 1, 0); });
    for (std::size_t i = 0; i < bounded.size(); ++i)
      origins_.push_back((bounded[i].empty() ? endless[i] : bounded[i]).origin());
    if (std::ranges::all_of(origins_, [](const Vec3d& to) { return to == Vec3d{}; })) return;
    geometry_.origin = origins_.front();
    move();
  }

 private:
  // Calls visit(space, center, size) for all that has bounds.
  template <class Visit>
  void for_each_bounded(Visit visit) const {
    for (std::size_t space = 0; space < geometry_.spaces.size(); ++space)
      for (const std::uint32_t i : geometry_.spaces[space].balls.balls) {
        const Sphere& ball = geometry_.balls[i].sphere;
        if (ball.radius != 0) visit(space, ball.center, 2 * std::fabs(ball.radius));
      }
    for (const auto& [space, boxes] : boxes_)
      for (const Aabb& box : boxes) {
        const double size = greatest(box.size());
        if (box.bounded() && size > 0) visit(static_cast<std::size_t>(space), box.center(), size);
      }
  }
  // Calls visit(space, place) for each primitive. This is used where all things are unbounded: they
  // have no sizes, and the distances between them take their place.
  template <class Visit>
  void for_each_place(Visit visit) const {
    for (const Primitive& primitive : geometry_.primitives) {
      const auto* plane = std::get_if<PlaneForm>(&primitive.form);
      visit(
          static_cast<std::size_t>(primitive.space),
          primitive.to_object.inverse().point(plane != nullptr ? plane->point : primitive.middle));
    }
  }

  const Vec3d& origin(int space) const { return origins_[static_cast<std::size_t>(space)]; }
  int space_of(const Ball& ball) const {
    return ball.grid >= 0 ? 0 : geometry_.primitive(ball.primitive).space;
  }

  // Subtracts the new origins from all coordinates, and adapts the transforms between the spaces.
  void move() {
    for (Primitive& primitive : geometry_.primitives) move(primitive);
    for (Ball& ball : geometry_.balls)
      ball.sphere.center = ball.sphere.center - origin(space_of(ball));
    for (Flat& flat : geometry_.flats)
      flat.plane.point = flat.plane.point - origin(geometry_.primitive(flat.primitive).space);
    for (InstanceGrid& grid : geometry_.grids) {
      grid.to_group = Affine::translation(-origin(grid.inside)) * grid.to_group *
                      Affine::translation(origin(grid.outside));
      if (origin(grid.inside) == Vec3d{}) continue;
      grid.box = moved(grid.box, origin(grid.inside));
      grid.slack = InstanceGrid::slack_of(grid.repeat.swept(grid.box));
    }
    for (auto& [space, boxes] : boxes_)
      if (origin(space) != Vec3d{})
        for (Aabb& box : boxes) box = moved(box, origin(space));
  }
  void move(Primitive& primitive) const {
    if (origin(primitive.space) == Vec3d{}) return;
    primitive.to_object = primitive.to_object * Affine::translation(origin(primitive.space));
    primitive.placed = primitive.to_object != Affine{};
  }
  // Corners near the new origin were rounded at the magnitude of the origin: by 2^-53 of it, and
  // the margin is eight times that.
  static Aabb moved(const Aabb& box, const Vec3d& to) {
    const double rounding = 0x1p-50 * greatest(to);
    const Vec3d more{rounding, rounding, rounding};
    return {box.min - to - more, box.max - to + more};
  }

  Geometry& geometry_;
  Boxes& boxes_;
  std::vector<Vec3d> origins_;  // of each space
};

}  // namespace

void settle(Geometry& geometry, std::map<int, std::vector<Aabb>>& boxes) {
  Settling(geometry, boxes).settle();
}

bool surely_keeps_origin(const Geometry& geometry) {
  const Space& world = geometry.spaces.front();
  const auto for_each = [&](const auto& visit) {
    for (const std::uint32_t i : world.balls.balls) {
      const Sphere& ball = geometry.balls[i].sphere;
      if (ball.radius != 0) visit(ball.center, 2 * std::fabs(ball.radius));
    }
    for (const Box32& box : world.boxes) {
      const Aabb own{Vec3d(box.min), Vec3d(box.max)};
      const double size = greatest(own.size());
      if (own.bounded() && size > 0) visit(own.center(), size);
    }
  };
  Crowd crowd;
  for_each([&](const Vec3d& center, double size) { crowd.add(center, 1 / size); });
  for_each([&](const Vec3d& center, double size) { crowd.measure(center, 1 / size, size); });
  return crowd.is_surely_near();
}

}  // namespace tia
