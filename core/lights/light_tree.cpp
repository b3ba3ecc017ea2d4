#include "core/lights/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/onb.h"

namespace tia {
namespace {

double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }
// The cosine of max(0, a - b).
double cos_of_rest(double sin_a, double cos_a, double sin_b, double cos_b) {
  return cos_a > cos_b ? 1 : cos_a * cos_b + sin_a * sin_b;
}
double clamped(double cosine) { return std::clamp(cosine, -1.0, 1.0); }

/// DirectionCone: directions within an angle of an axis. The smallest around two.
struct DirectionCone {
  Vec3d axis;
  double cosine;
};
DirectionCone around(const DirectionCone& a, const DirectionCone& b) {
  const double of_a = acos_of(clamped(a.cosine)), of_b = acos_of(clamped(b.cosine));
  const double between = acos_of(clamped(dot(a.axis, b.axis)));
  if (std::min(between + of_b, pi) <= of_a) return a;
  if (std::min(between + of_a, pi) <= of_b) return b;
  const double whole = (of_a + between + of_b) / 2;
  const Vec3d across = cross(a.axis, b.axis);
  if (whole >= pi || dot(across, across) == 0) return {a.axis, -1};
  const auto [sine, cosine] = sincos_of(whole - of_a);
  const Vec3d aside = cross(unit(across), a.axis);
  return {normalize(a.axis * cosine + aside * sine), cos_of(whole)};
}

// How much two halves cost by surface, power and the directions that they shine in.
// Source: Conty Estevez, Kulla (2018), 4.1.
double cost_of(const LightBounds& b, double stretch) {
  const double o = acos_of(clamped(b.cos_o)), e = acos_of(clamped(b.cos_e));
  const double w = std::min(o + e, pi), sine = sine_of(b.cos_o);
  const double shone =
      2 * pi * (1 - b.cos_o) + pi / 2 * (2 * w * sine - cos_of(o - 2 * w) - 2 * o * sine + b.cos_o);
  // A box of no surface still has its points apart.
  const Vec3d size = b.box.size();
  const double surface = b.box.half_area() + 1e-3 * dot(size, size);
  return b.power * shone * stretch * surface;
}

double component(const Vec3d& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Split: where the lights of a range are parted.
struct Split {
  double cost = Aabb::far;
  std::size_t axis = 0;
  int bucket = 0;
};
constexpr int buckets = 12;
int bucket_of(const LightBounds& light, const Aabb& middles, std::size_t axis) {
  const double low = component(middles.min, axis), size = component(middles.size(), axis);
  const double share = (component(light.box.center(), axis) - low) / size;
  return std::clamp(static_cast<int>(share * buckets), 0, buckets - 1);
}

// The cheapest of the splits between equal buckets along the axes.
Split best_split(const std::vector<LightBounds>& lights, std::vector<int>::iterator from,
                 std::vector<int>::iterator to, const Aabb& middles, const Aabb& box) {
  const auto of = [&](int i) -> const LightBounds& { return lights[static_cast<std::size_t>(i)]; };
  const Vec3d size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(component(middles.size(), axis) > 0)) continue;
    std::array<LightBounds, buckets> each;
    for (auto& bounds : each) bounds.power = 0;
    for (auto i = from; i != to; ++i) {
      LightBounds& bucket = each[static_cast<std::size_t>(bucket_of(of(*i), middles, axis))];
      bucket = around(bucket, of(*i));
    }
    std::array<LightBounds, buckets> after = each;
    for (std::size_t i = buckets - 1; i-- > 0;) after[i] = around(each[i], after[i + 1]);
    LightBounds before = each[0];
    for (int i = 1; i < buckets; ++i) {
      const LightBounds& behind = after[static_cast<std::size_t>(i)];
      const double stretch = longest / component(size, axis);
      const double cost = before.power > 0 && behind.power > 0
                              ? cost_of(before, stretch) + cost_of(behind, stretch)
                              : Aabb::far;
      if (cost < best.cost) best = {cost, axis, i};
      before = around(before, each[static_cast<std::size_t>(i)]);
    }
  }
  return best;
}

}  // namespace

double LightBounds::importance(const Vec3d& p, const Vec3d& n) const {
  const Vec3d half = box.size() * 0.5, way = p - box.center();
  const double radius_square = dot(half, half), square = dot(way, way);
  const double distance_square = std::max(square, radius_square);
  if (!(distance_square > 0)) return power;
  // From within the ball around the box the lights may be anywhere.
  const bool inside = square <= radius_square;
  const Vec3d wi = square > 0 ? way * (1 / std::sqrt(square)) : Vec3d{0, 0, 1};
  const double cos_b = inside ? -1 : std::sqrt(1 - radius_square / square);
  const double sin_b = sine_of(cos_b);
  double cos_w = clamped(dot(axis, wi));
  if (two_sided) cos_w = std::fabs(cos_w);
  const double sin_w = sine_of(cos_w), sin_o = sine_of(cos_o);
  const double cos_x = cos_of_rest(sin_w, cos_w, sin_o, cos_o);
  const double sin_x = cos_w > cos_o ? 0 : std::max(0.0, sin_w * cos_o - cos_w * sin_o);
  const double facing = inside ? 1 : cos_of_rest(sin_x, cos_x, sin_b, cos_b);
  if (facing <= cos_e) return 0;
  const double cos_i = std::fabs(clamped(dot(wi, n)));
  const double lit = inside || n == Vec3d{} ? 1 : cos_of_rest(sine_of(cos_i), cos_i, sin_b, cos_b);
  return std::max(0.0, power * facing * lit / distance_square);
}

LightBounds around(const LightBounds& a, const LightBounds& b) {
  if (a.power == 0) return b;
  if (b.power == 0) return a;
  const DirectionCone cone = around(DirectionCone{a.axis, a.cos_o}, DirectionCone{b.axis, b.cos_o});
  return {around(a.box, b.box), a.power + b.power,          cone.axis,
          cone.cosine,          std::min(a.cos_e, b.cos_e), a.two_sided || b.two_sided};
}

LightTree::LightTree(const std::vector<LightBounds>& lights) : leaf_of_(lights.size(), -1) {
  std::vector<int> order;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i].power > 0) order.push_back(static_cast<int>(i));
  nodes_.reserve(2 * order.size());
  if (!order.empty()) build(lights, order.begin(), order.end(), -1);
}

int LightTree::build(const std::vector<LightBounds>& lights, Range from, Range to, int parent) {
  const auto of = [&](int i) -> const LightBounds& { return lights[static_cast<std::size_t>(i)]; };
  const auto at = nodes_.size();
  nodes_.emplace_back().parent = parent;
  if (to - from == 1) {
    leaf_of_[static_cast<std::size_t>(*from)] = static_cast<int>(at);
    nodes_[at].bounds = of(*from), nodes_[at].light = *from;
    return static_cast<int>(at);
  }
  Aabb middles, box;
  for (auto i = from; i != to; ++i)
    middles = around(middles, of(*i).box.center()), box = around(box, of(*i).box);
  const Split best = best_split(lights, from, to, middles, box);
  auto middle = from + (to - from) / 2;
  if (best.cost < Aabb::far)
    middle = std::stable_partition(
        from, to, [&](int i) { return bucket_of(of(i), middles, best.axis) < best.bucket; });
  if (middle == from || middle == to) middle = from + (to - from) / 2;
  const int left = build(lights, from, middle, static_cast<int>(at));
  const int right = build(lights, middle, to, static_cast<int>(at));
  nodes_[at].left = left, nodes_[at].right = right;
  nodes_[at].bounds = around(nodes_[static_cast<std::size_t>(left)].bounds,
                             nodes_[static_cast<std::size_t>(right)].bounds);
  return static_cast<int>(at);
}

LightTree::Choice LightTree::choose(const Vec3d& p, const Vec3d& n, double u) const {
  if (nodes_.empty()) return {};
  double chance = 1;
  const Node* node = nodes_.data();
  while (node->light < 0) {
    const Node &left = nodes_[static_cast<std::size_t>(node->left)],
               &right = nodes_[static_cast<std::size_t>(node->right)];
    const double a = left.bounds.importance(p, n), b = right.bounds.importance(p, n);
    if (!(a + b > 0)) return {};
    const double share = a / (a + b);
    if (u < share) {
      node = &left, u /= share, chance *= share;
    } else {
      node = &right, u = (u - share) / (1 - share), chance *= b / (a + b);
    }
  }
  if (node == nodes_.data() && !(node->bounds.importance(p, n) > 0)) return {};
  return {node->light, chance};
}

double LightTree::chance(int light, const Vec3d& p, const Vec3d& n) const {
  const int leaf = leaf_of_[static_cast<std::size_t>(light)];
  if (leaf < 0) return 0;
  const Node* node = &nodes_[static_cast<std::size_t>(leaf)];
  double chance = node->parent < 0 && !(node->bounds.importance(p, n) > 0) ? 0 : 1;
  while (node->parent >= 0 && chance > 0) {
    const Node& above = nodes_[static_cast<std::size_t>(node->parent)];
    const bool is_left = &nodes_[static_cast<std::size_t>(above.left)] == node;
    const Node& other = nodes_[static_cast<std::size_t>(is_left ? above.right : above.left)];
    const double own = node->bounds.importance(p, n), rest = other.bounds.importance(p, n);
    chance *= own + rest > 0 ? own / (own + rest) : 0;
    node = &above;
  }
  return chance;
}

}  // namespace tia
