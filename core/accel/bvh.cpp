#include "core/accel/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/input/stopped.h"

namespace tia {
namespace {

constexpr int bins = 16;
constexpr std::size_t largest_leaf = 8;
constexpr double node_cost = 1;  // of a test of two boxes, in tests of one thing

double component(const Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

struct Split {
  int axis = -1;  // none
  int bin = 0;    // the first of the second half
  double cost = std::numeric_limits<double>::infinity();
};

class Builder {
 public:
  Builder(const std::vector<Aabb>& boxes, const std::stop_token& stop)
      : boxes_(boxes), stop_(stop) {
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0U);
    if (!boxes.empty()) build(order_, 0, 1);
  }
  Bvh take() {
    Bvh bvh;
    if (!nodes_.empty()) collapse(0, bvh);
    bvh.order = std::move(order_);
    return bvh;
  }

 private:
  using Run = std::span<std::uint32_t>;

  // A binary tree in depth-first order: a node's first child follows it.
  struct Binary {
    Box32 box;
    double area = 0;
    std::uint32_t first = 0;  // inner: the second child; leaf: the first of its entries of `order`
    std::uint16_t count = 0;  // leaf: how many; 0: an inner node
  };

  // The descendants that a node of up to eight children has: again and again the one with the
  // largest surface, at first the node itself, gives way to its own two.
  std::vector<std::uint32_t> widened(std::uint32_t node) const {
    std::vector<std::uint32_t> children{node};
    while (children.size() < BoxSet::size) {
      const auto surface = [&](std::uint32_t i) {
        return nodes_[i].count == 0 ? nodes_[i].area : -1;
      };
      const auto widest = std::ranges::max_element(children, {}, surface);
      const std::uint32_t parent = *widest;
      if (nodes_[parent].count > 0) break;
      children.erase(widest);  // of equals the ones that wait longest: it stays shallow
      children.insert(children.end(), {parent + 1, nodes_[parent].first});
    }
    return children;
  }

  // Adds the subtree to the wide one. Returns: where it is.
  std::uint32_t collapse(std::uint32_t node, Bvh& bvh) const {
    end_if_asked(stop_);
    const auto at = static_cast<std::uint32_t>(bvh.nodes.size());
    bvh.nodes.emplace_back();
    for (const std::uint32_t each : widened(node)) {
      const Binary& child = nodes_[each];
      const std::uint32_t first = child.count > 0 ? child.first : collapse(each, bvh);
      Bvh::Node& wide = bvh.nodes[at];
      wide.first[wide.boxes.count] = first;
      wide.count[wide.boxes.count] = child.count;
      wide.boxes.add(child.box);
    }
    return at;
  }

  // Adds the tree over a run of `order` that starts at `first`.
  void build(Run run, std::size_t first, int depth) {
    Aabb all, centers;
    for (const std::uint32_t i : run) {
      all = around(all, boxes_[i]);
      centers = around(centers, boxes_[i].center());
    }
    const std::size_t node = nodes_.size();
    nodes_.push_back({rounded_outwards(all), all.half_area(), 0, 0});
    const Split split = depth < Bvh::deepest / 2 ? best_split(run, centers) : Split{};
    const double parted = node_cost * all.half_area() + split.cost;
    const double together = static_cast<double>(run.size()) * all.half_area();
    if (run.size() == 1 || (run.size() <= largest_leaf && !(parted < together)))
      return make_leaf(node, first, run.size());

    const std::size_t half = part(run, split, centers);
    build(run.first(half), first, depth + 1);
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    build(run.subspan(half), first + half, depth + 1);
  }

  void make_leaf(std::size_t node, std::size_t first, std::size_t count) {
    nodes_[node].first = static_cast<std::uint32_t>(first);
    nodes_[node].count = static_cast<std::uint16_t>(count);
  }

  static int bin_of(double center, double low, double size) {
    return std::clamp(static_cast<int>((center - low) / size * bins), 0, bins - 1);
  }

  Split best_split(Run run, const Aabb& centers) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      end_if_asked(stop_);  // a root has all boxes
      const double low = component(centers.min, axis), size = component(centers.size(), axis);
      if (!(size > 0) || !std::isfinite(bins / size)) continue;
      std::array<Aabb, bins> boxes;
      std::array<double, bins> counts{};
      for (const std::uint32_t i : run) {
        const int bin = bin_of(component(boxes_[i].center(), axis), low, size);
        boxes[static_cast<std::size_t>(bin)] =
            around(boxes[static_cast<std::size_t>(bin)], boxes_[i]);
        counts[static_cast<std::size_t>(bin)] += 1;
      }
      sweep(boxes, counts, axis, best);
    }
    return best;
  }

  // Costs of all splits between bins: from the right first, then against what is left of them.
  static void sweep(const std::array<Aabb, bins>& boxes, const std::array<double, bins>& counts,
                    int axis, Split& best) {
    std::array<double, bins> right{};
    Aabb box;
    double count = 0;
    for (std::size_t i = bins - 1; i > 0; --i) {
      box = around(box, boxes[i]);
      count += counts[i];
      right[i] = count > 0 ? count * box.half_area() : 0;
    }
    box = {};
    count = 0;
    for (std::size_t i = 0; i + 1 < bins; ++i) {
      box = around(box, boxes[i]);
      count += counts[i];
      if (count == 0) continue;
      const double cost = count * box.half_area() + right[i + 1];
      if (cost < best.cost) best = {axis, static_cast<int>(i) + 1, cost};
    }
  }

  // Returns: how many are in the first part. Equal centres cannot be told apart: halves of the
  // list.
  std::size_t part(Run run, const Split& split, const Aabb& centers) const {
    if (split.axis < 0) return run.size() / 2;
    const double low = component(centers.min, split.axis);
    const double size = component(centers.size(), split.axis);
    const auto second = std::stable_partition(run.begin(), run.end(), [&](std::uint32_t i) {
      return bin_of(component(boxes_[i].center(), split.axis), low, size) < split.bin;
    });
    return static_cast<std::size_t>(second - run.begin());
  }

  const std::vector<Aabb>& boxes_;
  const std::stop_token& stop_;
  std::vector<Binary> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

Bvh build_bvh(const std::vector<Aabb>& boxes, const std::stop_token& stop) {
  return Builder(boxes, stop).take();
}

}  // namespace tia
