#include "core/shapes/formula/isosurface_cells.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/math/tolerances.h"
#include "core/parallel/stopped.h"
#include "core/shapes/subdivision.h"

namespace tia {
namespace {

using Box8 = std::array<Interval<Octet>, 3>;
using Slopes = Dual<Interval<Octet>, 3>;

constexpr std::size_t most_cells = 1 << 16;
// Boxes are traversed enlarged by this share of the region's size, and what is said of them is
// proven for twice the enlargement. So neighbours overlap, and a line cannot pass between two of
// them by rounding, nor leave what is proven.
constexpr double walked_room = tolerance::cell_box;

struct Pending {
  Aabb box;  // around the middle
  std::size_t node;
  int level;
};

Aabb with_room(const Aabb& box, double room) {
  const Vec3d more{room, room, room};
  return {box.min - more, box.max + more};
}

double component(const Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
double& component(Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// The box in eight, halved three times where it is longest.
std::array<Aabb, 8> eighths(const Aabb& box) {
  std::array<Aabb, 8> parts{box};
  for (std::size_t count = 1; count < 8; count *= 2) {
    const Vec3d size = parts[0].size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    for (std::size_t i = 0; i < count; ++i) {
      Aabb& low = parts[i];
      Aabb& high = parts[count + i] = low;
      component(low.max, axis) = component(high.min, axis) = component(low.center(), axis);
    }
  }
  return parts;
}

bool beyond(const Region& region, const Aabb& box) {
  const auto* ball = std::get_if<Sphere>(&region.kind);
  if (ball == nullptr) return false;
  const Vec3d nearest = upper(box.min, lower(box.max, ball->center));
  const Vec3d apart = nearest - ball->center;
  // The margin is far above the rounding of the squares, some 1e-15 of them.
  return dot(apart, apart) > ball->radius * ball->radius * (1 + 1e-9);
}

/// Bounds of the function in eight boxes.
struct EightBoxes {
  Octet low, high;     // f
  Octet value, error;  // f at the middles
  std::array<Octet, 3> slope, spread, reach;
  Definedness<Octet> where;
};

class CellBuilder {
 public:
  CellBuilder(const Program& function, const Region& region)
      : function_(function), region_(region), box_(bounds(region)) {
    all_.tree.middle = box_.center();
    const Vec3d size = box_.size();
    room_ = walked_room * std::max({size.x, size.y, size.z});
  }

  IsosurfaceCells build() {
    const Vec3d middle = all_.tree.middle;
    pending_.push_back({{box_.min - middle, box_.max - middle}, 0, 0});
    all_.tree.nodes.emplace_back();
    while (!pending_.empty()) {
      const Pending next = pending_.front();
      pending_.pop_front();
      give_way();
      split(next);
    }
    all_.tree.nodes.shrink_to_fit();
    all_.cells.shrink_to_fit();
    return std::move(all_);
  }

 private:
  void split(const Pending& from) {
    const std::array<Aabb, 8> parts = eighths(from.box);
    cost_ += function_.cost;
    const EightBoxes eight = proven(parts);
    const unsigned some = bits(eight.where.some), whole = bits(eight.where.whole);
    const unsigned above = bits(eight.low > Octet(0)), below = bits(eight.high < Octet(0));
    // A box in which f is below 0 where it is defined, but not defined everywhere, bounds the
    // solid.
    const unsigned held = some & ~above & ~(below & whole);
    for (std::size_t i = 0; i < 8; ++i) {
      if ((held >> i & 1) == 0 || beyond(region_, absolute(parts[i]))) continue;
      const IsosurfaceCell cell = cell_of(eight, i, (whole >> i & 1) != 0, parts[i]);
      put(parts[i], cell, from);
    }
  }
  Aabb absolute(const Aabb& box) const {
    return {box.min + all_.tree.middle, box.max + all_.tree.middle};
  }
  void put(const Aabb& box, const IsosurfaceCell& cell, const Pending& from) {
    const bool is_one = is_flat(cell);
    const Aabb walked = with_room(box, room_);
    if (is_one || from.level + 1 == detail::most_tree_levels || full()) {
      all_.tree.add_leaf(from.node, walked, all_.cells.size());
      all_.cells.push_back(cell);
      all_.flat += is_one ? 1 : 0;
    } else {
      const std::size_t own = all_.tree.nodes.size();
      all_.tree.nodes.emplace_back();
      all_.tree.add_node(from.node, walked, own);
      pending_.push_back({box, own, from.level + 1});
    }
  }
  bool full() const {
    const std::size_t to_come = 8 * (pending_.size() + 1);
    const double cost = cost_ + function_.cost * static_cast<double>(pending_.size() + 1);
    return all_.cells.size() + to_come > most_cells || cost > detail::most_tree_cost;
  }
  static bool is_flat(const IsosurfaceCell& cell) {
    // Scaled first, for their squares might underflow or overflow.
    const Vec3d spread = static_cast<Vec3d>(cell.spread), g = cell.gradient;
    const double steepest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
    const double scale = 1 / steepest;
    return cell.smooth && steepest > 0 &&
           length(spread * scale) <= detail::flat_enough * length(g * scale);
  }

  // The function over boxes, by its own intervals and by those of its slopes around the middle.
  EightBoxes proven(const std::array<Aabb, 8>& parts) const {
    std::array<Slopes, 3> variables;
    Box8 middles;
    EightBoxes eight;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 8> from, to, mid;
      for (std::size_t i = 0; i < 8; ++i) {
        const Aabb box = absolute(with_room(parts[i], 2 * room_));
        from[i] = component(box.min, axis), to[i] = component(box.max, axis);
        mid[i] = component(absolute(parts[i]).center(), axis);
      }
      const auto a = static_cast<std::size_t>(axis);
      const Octet low = Octet::load_unaligned(from.data()), high = Octet::load_unaligned(to.data());
      const Octet center = Octet::load_unaligned(mid.data());
      variables[a] = Slopes::variable({low, high}, a);
      middles[a] = {center, center};
      eight.reach[a] = interval::up(max_of(Octet(high - center), Octet(center - low)));
    }
    const Slopes whole = evaluate(function_, variables.data(), eight.where);
    Definedness<Octet> at_middles;
    const Interval<Octet> value = evaluate(function_, middles.data(), at_middles);
    eight.value = value.middle();
    eight.error = interval::up(Octet(value.width()));
    Octet most = eight.error;
    for (std::size_t a = 0; a < 3; ++a) {
      eight.slope[a] = whole.slope[a].middle();
      eight.spread[a] = interval::up(Octet(whole.slope[a].width()));
      most = interval::up(Octet(
          most + interval::up(Octet((abs_of(eight.slope[a]) + eight.spread[a]) * eight.reach[a]))));
    }
    // A comparison with NaN, where slopes are unbounded, leaves the function's own interval.
    const auto trusted = eight.where.whole && at_middles.whole;
    eight.low = select(trusted, max_of(Octet(eight.value - most), whole.value.lo), whole.value.lo);
    eight.high = select(trusted, min_of(Octet(eight.value + most), whole.value.hi), whole.value.hi);
    eight.where.whole = trusted;
    return eight;
  }

  IsosurfaceCell cell_of(const EightBoxes& eight, std::size_t lane_number, bool whole,
                         const Aabb& box) const {
    const int i = static_cast<int>(lane_number);
    const auto of = [&](const std::array<Octet, 3>& each) {
      return Vec3d{lane(each[0], i), lane(each[1], i), lane(each[2], i)};
    };
    IsosurfaceCell cell;
    const Vec3d spread = of(eight.spread), reach = of(eight.reach);
    cell.gradient = of(eight.slope);
    const double value = lane(eight.value, i);
    cell.offset = value - dot(cell.gradient, box.center());
    cell.spread = {rounded_up(spread.x), rounded_up(spread.y), rounded_up(spread.z)};
    const Vec3d far = upper(box.max, -box.min), steep = upper(cell.gradient, -cell.gradient);
    // 16 times 2^-52, for the dozen operations of the linear approximation.
    const double rounding = 0x1p-48 * (std::fabs(value) + dot(steep, far));
    cell.slack = (dot(spread, reach) + lane(eight.error, i)) * (1 + 0x1p-40) + rounding;
    cell.smooth = whole && std::isfinite(cell.slack) && std::isfinite(cell.offset);
    return cell;
  }

  const Program& function_;
  const Region& region_;
  Aabb box_;
  IsosurfaceCells all_;
  std::deque<Pending> pending_;
  double cost_ = 0, room_ = 0;
};

}  // namespace

IsosurfaceCells cells_of(const Program& function, const Region& region) {
  return CellBuilder(function, region).build();
}

}  // namespace tia
