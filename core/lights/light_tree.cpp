#include "core/lights/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/lights/light_importance.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

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

struct LightTree::Node {
  LightBounds bounds;
  int left = -1, right = -1;
  int light = -1;  // of a leaf

  using Range = std::vector<int>::iterator;
  static int build(const std::vector<LightBounds>& lights, Range from, Range to,
                   std::vector<Node>& nodes);
};

int LightTree::Node::build(const std::vector<LightBounds>& lights, Range from, Range to,
                           std::vector<Node>& nodes) {
  const auto of = [&](int i) -> const LightBounds& { return lights[static_cast<std::size_t>(i)]; };
  const auto at = nodes.size();
  nodes.emplace_back();
  if (to - from == 1) {
    nodes[at].bounds = of(*from), nodes[at].light = *from;
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
  const int left = build(lights, from, middle, nodes), right = build(lights, middle, to, nodes);
  nodes[at].left = left, nodes[at].right = right;
  nodes[at].bounds = around(nodes[static_cast<std::size_t>(left)].bounds,
                            nodes[static_cast<std::size_t>(right)].bounds);
  return static_cast<int>(at);
}

LightTree::LightTree(const std::vector<LightBounds>& lights) : leaf_of_(lights.size(), -1) {
  std::vector<int> order;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i].power > 0) order.push_back(static_cast<int>(i));
  if (order.empty()) return;
  std::vector<Node> nodes;
  nodes.reserve(2 * order.size());
  Node::build(lights, order.begin(), order.end(), nodes);
  pack(nodes, 0, -1);
}

// Returns: the family below a node. A light that is alone has nothing beside it.
int LightTree::pack(const std::vector<Node>& nodes, int node, int parent) {
  const int family = static_cast<int>(families_.size());
  families_.emplace_back().parent = parent;
  const Node& above = nodes[static_cast<std::size_t>(node)];
  if (above.light >= 0) return put(nodes, node, family, 0), family;
  put(nodes, above.left, family, 0);
  put(nodes, above.right, family, 1);
  return family;
}

void LightTree::put(const std::vector<Node>& nodes, int number, int family, std::size_t lane) {
  const Node& node = nodes[static_cast<std::size_t>(number)];
  const auto of = [&]() -> Family& { return families_[static_cast<std::size_t>(family)]; };
  const auto words = words_of(node.bounds);
  for (std::size_t k = 0; k < Family::words; ++k) of().word[k][lane] = words[k];
  const int place = static_cast<int>(Family::lanes) * family + static_cast<int>(lane);
  if (node.light >= 0) {
    leaf_of_[static_cast<std::size_t>(node.light)] = place;
    of().children[lane] = {Child::light, node.light};
  } else if (lane < 2) {
    const std::size_t pair = 2 * lane + 2;
    of().children[lane] = {Child::pair, static_cast<int>(pair)};
    put(nodes, node.left, family, pair);
    put(nodes, node.right, family, pair + 1);
  } else {
    const int below = pack(nodes, number, place);
    of().children[lane] = {Child::family, below};
  }
}

/// Weights: how much the lanes of a family may give a point. They are computed when they are asked
/// for, all that are in one register together.
class LightTree::Weights {
 public:
  Weights(const Family& family, const Vec3d& p, const Vec3d& n) : family_(family), p_(p), n_(n) {}

  double operator[](std::size_t lane) {
    const std::size_t first = lane / size * size;
    if (first != first_) weigh(first);
    return each_[lane - first];
  }

 private:
  static constexpr std::size_t size = DoubleRegister::size;
  static_assert(size % 2 == 0 && Family::lanes % size == 0);

  void weigh(std::size_t first) {
    const auto load = [&](std::size_t k) {
      return DoubleRegister::load_unaligned(&family_.word[k][first]);
    };
    importance_of(Shine<DoubleRegister>::of(load), p_, n_).store_unaligned(each_.data());
    first_ = first;
  }

  const Family& family_;
  const Vec3d &p_, &n_;
  std::size_t first_ = Family::lanes;  // of those in each_; lanes: none yet
  std::array<double, size> each_;
};

LightTree::Choice LightTree::choose(const Vec3d& p, const Vec3d& n, double u) const {
  if (families_.empty()) return {};
  double chance = 1;
  Child child{Child::family, 0};
  while (child.kind == Child::family) {
    const Family& family = families_[static_cast<std::size_t>(child.index)];
    Weights each(family, p, n);
    child = {Child::pair, 0};
    while (child.kind == Child::pair) {
      auto lane = static_cast<std::size_t>(child.index);
      const double a = each[lane], b = each[lane + 1];
      if (!(a + b > 0)) return {};
      const double share = a / (a + b);
      if (u < share) {
        u /= share, chance *= share;
      } else {
        u = (u - share) / (1 - share), chance *= b / (a + b), ++lane;
      }
      child = family.children[lane];
    }
  }
  return {child.index, chance};
}

double LightTree::chance(int light, const Vec3d& p, const Vec3d& n) const {
  int at = leaf_of_[static_cast<std::size_t>(light)];
  double chance = at < 0 ? 0 : 1;
  while (at >= 0 && chance > 0) {
    const Family& family = families_[static_cast<std::size_t>(at) / Family::lanes];
    Weights each(family, p, n);
    // The pair of the lane, and then the pair above it.
    for (std::size_t lane = static_cast<std::size_t>(at) % Family::lanes;; lane = lane / 2 - 1) {
      const double own = each[lane], rest = each[lane ^ 1];
      chance *= own + rest > 0 ? own / (own + rest) : 0;
      if (lane < 2 || !(chance > 0)) break;
    }
    at = family.parent;
  }
  return chance;
}

}  // namespace tia
