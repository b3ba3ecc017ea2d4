#include "core/accel/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

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
  explicit Builder(const std::vector<Aabb>& boxes) : boxes_(boxes) {
    bvh_.order.resize(boxes.size());
    std::iota(bvh_.order.begin(), bvh_.order.end(), 0U);
    if (!boxes.empty()) build(bvh_.order, 0, 1);
  }
  Bvh take() { return std::move(bvh_); }

 private:
  using Run = std::span<std::uint32_t>;

  // Adds the tree over a run of `order` that starts at `first`.
  void build(Run run, std::size_t first, int depth) {
    Aabb all, centers;
    for (const std::uint32_t i : run) {
      all = around(all, boxes_[i]);
      centers = around(centers, boxes_[i].center());
    }
    const std::size_t node = bvh_.nodes.size();
    bvh_.nodes.push_back({rounded_outwards(all), 0, 0, 0});
    const Split split = depth < Bvh::deepest / 2 ? best_split(run, centers) : Split{};
    const double parted = node_cost * all.half_area() + split.cost;
    const double together = static_cast<double>(run.size()) * all.half_area();
    if (run.size() == 1 || (run.size() <= largest_leaf && !(parted < together)))
      return make_leaf(node, first, run.size());

    const std::size_t half = part(run, split, centers);
    bvh_.nodes[node].axis = static_cast<std::uint16_t>(std::max(split.axis, 0));
    build(run.first(half), first, depth + 1);
    bvh_.nodes[node].first = static_cast<std::uint32_t>(bvh_.nodes.size());
    build(run.subspan(half), first + half, depth + 1);
  }

  void make_leaf(std::size_t node, std::size_t first, std::size_t count) {
    bvh_.nodes[node].first = static_cast<std::uint32_t>(first);
    bvh_.nodes[node].count = static_cast<std::uint16_t>(count);
  }

  static int bin_of(double center, double low, double size) {
    return std::clamp(static_cast<int>((center - low) / size * bins), 0, bins - 1);
  }

  Split best_split(Run run, const Aabb& centers) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
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
  Bvh bvh_;
};

}  // namespace

Bvh build_bvh(const std::vector<Aabb>& boxes) { return Builder(boxes).take(); }

}  // namespace tia
