#include "core/radio/curved_path.h"

#include <array>
#include <cmath>

#include "core/math/onb.h"

namespace tia {
namespace {

/// AimedRay: a ray by way of given mirrors: where each leg starts, and whither it goes.
struct AimedRay {
  std::vector<RadioInteraction> at;
  std::vector<Vec3d> starts, ways;
  double length = 0;  ///< up to the last mirror

  Vec3d end(std::size_t leg, double reach) const { return starts[leg] + ways[leg] * reach; }
};

/// MirrorCourse: from a transmitter by mirrors to a receiver.
class MirrorCourse {
 public:
  MirrorCourse(const RadioWorld& world, const Vec3d& from, const Vec3d& to,
               const MirrorSequence& mirrors)
      : world_(world), from_(from), to_(to), mirrors_(mirrors) {}

  std::optional<AimedRay> shoot(const Vec3d& direction) const {
    AimedRay ray{{}, {from_}, {direction}, 0};
    for (std::size_t i = 0; i < mirrors_.size(); ++i) {
      const bool from_curved = i > 0 && mirrors_[i - 1].facet < 0;
      const auto met = world_.meet_mirror(ray.starts.back(), ray.ways.back(), mirrors_[i].facet,
                                          mirrors_[i].body, from_curved);
      if (!met) return std::nullopt;
      const double slope = dot(met->normal, ray.ways.back());
      ray.at.push_back({RadioKind::reflection, met->body, met->element, met->point, met->normal,
                        std::fabs(slope), 0});
      ray.length += met->distance;
      ray.starts.push_back(met->point);
      ray.ways.push_back(normalize(ray.ways.back() - met->normal * (2 * slope)));
    }
    return ray;
  }

  const Vec3d& from() const { return from_; }
  const Vec3d& to() const { return to_; }

 private:
  const RadioWorld& world_;
  const Vec3d from_, to_;
  const MirrorSequence& mirrors_;
};

/// Tube: a ray and its four neighbours.
struct Tube {
  static constexpr double step = 1e-6;  // radians: its square times what bends is what is lost
  AimedRay middle;
  std::array<AimedRay, 4> around;  // +u, -u, +v, -v
};
Vec3d turned(const Onb& basis, double u, double v) {
  return unit(basis.n + basis.u * u + basis.v * v);
}
std::optional<Tube> tube_of(const MirrorCourse& course, const Vec3d& direction) {
  const Onb basis = onb_around(direction);
  constexpr double h = Tube::step;
  const std::array<Vec2d, 4> steps{{{h, 0}, {-h, 0}, {0, h}, {0, -h}}};
  Tube tube;
  auto middle = course.shoot(direction);
  if (!middle) return std::nullopt;
  tube.middle = std::move(*middle);
  for (std::size_t i = 0; i < 4; ++i) {
    auto ray = course.shoot(turned(basis, steps[i].u, steps[i].v));
    if (!ray) return std::nullopt;
    tube.around[i] = std::move(*ray);
  }
  return tube;
}

// Two by two, of a leg's cross section: how places across it change with the launch direction.
struct Spread {
  double uu, uv, vu, vv;
  double area() const { return uu * vv - uv * vu; }
};
Spread spread_at(const Tube& tube, std::size_t leg, double reach) {
  const Onb across = onb_around(tube.middle.ways[leg]);
  const auto slope = [&](std::size_t plus) {
    const Vec3d change = tube.around[plus].end(leg, reach) - tube.around[plus + 1].end(leg, reach);
    return across.local(change * (0.5 / Tube::step));
  };
  const Vec3d u = slope(0), v = slope(2);
  return {u.x, v.x, u.y, v.y};
}

// How many times the tube's area changes its sign along a leg: it is quadratic in the reach.
int caustics_on(const Tube& tube, std::size_t leg, double reach) {
  const double start = spread_at(tube, leg, 0).area(), end = spread_at(tube, leg, reach).area();
  const double half = spread_at(tube, leg, reach / 2).area();
  const double bend = 2 * (start - 2 * half + end), slope = end - start - bend;
  if ((start > 0) != (end > 0) && start != 0) return 1;
  if (bend == 0) return 0;
  const double lowest = -slope / (2 * bend);  // where both roots are, or none
  const double there = start + slope * lowest / 2;
  return lowest > 0 && lowest < 1 && start * there < 0 ? 2 : 0;
}

int caustics_of(const Tube& tube, double last_reach) {
  int count = 0;
  const std::size_t last = tube.middle.starts.size() - 1;
  for (std::size_t leg = 1; leg <= last; ++leg)
    count += caustics_on(
        tube, leg,
        leg == last ? last_reach : length(tube.middle.starts[leg + 1] - tube.middle.starts[leg]));
  return count;
}

RadioPath path_along(const MirrorCourse& course, const Tube& tube, double reach) {
  RadioPath path{course.from(), course.to(), tube.middle.at, tube.middle.length + reach};
  const std::size_t last = tube.middle.starts.size() - 1;
  path.tube = std::sqrt(std::fabs(spread_at(tube, last, reach).area()));
  path.caustics = caustics_of(tube, reach);
  return path;
}

}  // namespace

std::optional<RadioPath> curved_path(const RadioWorld& world, const RadioPath& near,
                                     const Vec3d& direction, const MirrorSequence& mirrors) {
  constexpr int most_steps = 30;
  const MirrorCourse course(world, near.from, near.to, mirrors);
  Vec3d way = direction;
  double before = Aabb::far;
  for (int i = 0; i < most_steps; ++i) {
    const auto tube = tube_of(course, way);
    if (!tube) return std::nullopt;
    const std::size_t last = tube->middle.starts.size() - 1;
    const Vec3d left = course.to() - tube->middle.starts[last];
    const double reach = dot(left, tube->middle.ways[last]);
    const Vec3d miss = onb_around(tube->middle.ways[last]).local(left);
    const double aside = std::sqrt(miss.x * miss.x + miss.y * miss.y);
    const bool stays = !(aside < before / 2);
    if (!(reach > 0)) return std::nullopt;
    if (aside <= world.slack() && stays) return path_along(course, *tube, reach);
    before = aside;
    const Spread slope = spread_at(*tube, last, reach);
    const double area = slope.area();
    if (area == 0) return std::nullopt;
    const double u = (slope.vv * miss.x - slope.uv * miss.y) / area,
                 v = (slope.uu * miss.y - slope.vu * miss.x) / area;
    const double size = std::sqrt(u * u + v * v), most = 0.2;  // radians: no step leaps away
    const double share = size > most ? most / size : 1;
    way = turned(onb_around(way), u * share, v * share);
  }
  return std::nullopt;
}

}  // namespace tia
