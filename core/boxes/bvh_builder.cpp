#include "core/boxes/bvh_builder.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "core/boxes/bins.h"

namespace tia {
namespace {

using detail::Bins;
using detail::BinScale;
using detail::Eight;
using detail::Extent;
using detail::Run;
using detail::Scales;
using detail::Split;

constexpr std::size_t largest_leaf = Bvh::largest_leaf;
constexpr std::size_t shared_work = 1 << 16;  // boxes that are worth dividing among workers

class Builder {
 public:
  Builder(std::span<const Box32> boxes, const Workers& workers)
      : workers_(workers), list_(uninitialised(boxes.size())), spare_(uninitialised(boxes.size())) {
    all_.count = boxes.size();
    std::mutex mutex;
    workers_.for_each_share(boxes.size(), [&](std::size_t from, std::size_t to) {
      Run own;
      for (std::size_t i = from; i < to; ++i) {
        list_[i] = Extent::of(boxes[i], static_cast<std::uint32_t>(i));
        own.box.take(list_[i]);
        own.centers.take_center(list_[i]);
      }
      const std::lock_guard lock(mutex);
      all_.box.take(own.box);
      all_.centers.take(own.centers);
    });
  }

  Bvh build() {
    Bvh bvh;
    if (all_.count == 0) return bvh;
    workers_.end_if_asked();
    const std::vector<Subtree> subtrees = build_top(bvh.nodes);
    workers_.for_each(static_cast<int>(subtrees.size()), [&](int i) {
      const Subtree& each = subtrees[static_cast<std::size_t>(i)];
      add_node(each.run, each.depth, *each.nodes);
    });
    std::size_t total = bvh.nodes.size();
    for (const Subtree& each : subtrees) total += each.nodes->size();
    bvh.nodes.reserve(total);
    for (const Subtree& each : subtrees) append(each, bvh.nodes);
    bvh.nodes.shrink_to_fit();
    bvh.order.resize(all_.count);
    workers_.for_each_share(all_.count, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) bvh.order[i] = list_[i].id();
    });
    return bvh;
  }

 private:
  using Nodes = HugeVector<Bvh::Node>;
  using Children = std::vector<Run>;

  // What one worker builds by itself, to be hung in at a child of the top.
  struct Subtree {
    Run run;
    int depth;
    std::uint32_t parent, child;
    std::unique_ptr<Nodes> nodes = std::make_unique<Nodes>();
  };

  // Nodes of so many boxes that the subtrees below are to be shared: few, and as many whoever
  // works.
  std::vector<Subtree> build_top(Nodes& nodes) {
    std::vector<Subtree> below;
    const std::size_t large = std::max(all_.count / 16, shared_work);
    const auto add = [&](auto& self, const Run& run, int depth) -> std::uint32_t {
      const auto at = static_cast<std::uint32_t>(nodes.size());
      nodes.emplace_back();
      for (const Run& child : parted(run, depth)) {
        const auto slot = nodes[at].boxes.count;
        add_child(child, nodes[at]);
        if (child.count > large)
          nodes[at].children[slot] = BvhChild::node(self(self, child, depth + 1));
        else if (child.count > largest_leaf) below.push_back({child, depth + 1, at, slot});
      }
      return at;
    };
    add(add, all_, 1);
    return below;
  }
  static void append(const Subtree& subtree, Nodes& nodes) {
    const auto offset = static_cast<std::uint32_t>(nodes.size());
    nodes[subtree.parent].children[subtree.child] = BvhChild::node(offset);
    for (Bvh::Node& node : *subtree.nodes) {
      for (unsigned i = 0; i < node.boxes.count; ++i) {
        BvhChild& child = node.children[i];
        if (!child.is_leaf()) child = BvhChild::node(child.first() + offset);
      }
      nodes.push_back(node);
    }
  }

  std::uint32_t add_node(const Run& run, int depth, Nodes& nodes) {
    const auto at = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    for (const Run& child : parted(run, depth)) {
      const auto slot = nodes[at].boxes.count;
      add_child(child, nodes[at]);
      if (child.count <= largest_leaf) continue;
      const std::uint32_t below = add_node(child, depth + 1, nodes);
      nodes[at].children[slot] = BvhChild::node(below);
    }
    return at;
  }
  static void add_child(const Run& run, Bvh::Node& node) {
    const auto slot = node.boxes.count;
    node.boxes.add(run.box.box());
    if (run.count <= largest_leaf)
      node.children[slot] = BvhChild::leaf(static_cast<std::uint32_t>(run.first),
                                           static_cast<std::uint32_t>(run.count));
  }

  // The children of a node: again and again the widest, at first the node itself, gives way to its
  // own two.
  Children parted(const Run& run, int depth) {
    Children children{run};
    while (children.size() < BoxSet::size) {
      const auto width = [&](const Run& each) {
        return each.count > smallest ? each.box.half_area() : -1;
      };
      const auto widest = std::ranges::max_element(children, {}, width);
      if (widest->count <= smallest) break;
      const Run whole = *widest;
      children.erase(
          widest);  // of equal ones those that were added first, which keeps the tree shallow
      part(whole, depth, children);
    }
    return children;
  }

  // Adds both parts of a run to the children.
  void part(const Run& run, int depth, Children& children) {
    workers_.end_if_asked();
    const Scales scales = scales_of(run.centers);
    const Split split = depth < Bvh::deepest / 2 ? best_split(run, scales) : Split{};
    if (split.cost < infinity) return part(run, split, scales[split.axis], children);
    const std::size_t half = run.count / 2;  // no split separates equal centres
    for (const auto& [first, count] :
         {std::pair(run.first, half), std::pair(run.first + half, run.count - half)}) {
      Run& each = children.emplace_back(Run{first, count});
      for (std::size_t i = first; i < first + count; ++i) {
        each.box.take(list_[i]);
        each.centers.take_center(list_[i]);
      }
    }
  }
  // Each box is written to both sides, and the end of one of them is moved. A branch could not be
  // predicted.
  void part(const Run& run, const Split& split, const BinScale& scale, Children& children) {
    Extent* const list = &list_[run.first];
    Extent* const spare = &spare_[run.first];
    std::size_t low = 0, high = 0;
    std::array<Extent, 2> centers{Extent::nothing(), Extent::nothing()};
    constexpr float out_of_the_way[] = {0, infinity};
    for (std::size_t i = 0; i < run.count; ++i) {
      // In a register all the while: a copy in pieces would have to be waited for.
      const Eight each = detail::load(list[i].least);
      const bool is_high = scale.bin(list[i].center(split.axis)) >= split.bin;
      each.store_unaligned(list[low].least.data());
      each.store_unaligned(spare[high].least.data());
      low += !is_high;
      high += is_high;
      centers[0].take_center(each, out_of_the_way[is_high]);
      centers[1].take_center(each, out_of_the_way[!is_high]);
    }
    std::copy(spare, spare + high, list + low);
    children.push_back({run.first, low, split.boxes[0], centers[0]});
    children.push_back({run.first + low, high, split.boxes[1], centers[1]});
  }

  Split best_split(const Run& run, const Scales& scales) const {
    const Bins all = bins_of(run, scales);
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (scales[axis].parts) sweep(all, axis, best);
    for (std::size_t i = 0; i < detail::bins; ++i)
      best.boxes[i >= best.bin].take(all.boxes[best.axis][i]);
    return best;
  }
  Bins bins_of(const Run& run, const Scales& scales) const {
    Bins all;
    const auto add = [&](Bins& to, std::size_t from, std::size_t end) {
      for (std::size_t i = run.first + from; i < run.first + end; ++i) to.add(list_[i], scales);
    };
    if (run.count <= shared_work) {
      add(all, 0, run.count);
      return all;
    }
    std::mutex mutex;
    workers_.for_each_share(run.count, [&](std::size_t from, std::size_t end) {
      Bins own;
      add(own, from, end);
      const std::lock_guard lock(mutex);
      all.add(own);  // in any order: the least and the sums are the same
    });
    return all;
  }

  const Workers& workers_;
  // Memory that nobody fills before it is used: that would be as long as a level of the tree.
  struct Free {
    std::size_t count;
    void operator()(Extent* list) const { HugePages<Extent>().deallocate(list, count); }
  };
  using List = std::unique_ptr<Extent[], Free>;
  static List uninitialised(std::size_t count) {
    return {count == 0 ? nullptr : HugePages<Extent>().allocate(count), Free{count}};
  }
  List list_, spare_;
  Run all_;
  static constexpr std::size_t smallest = 6;  // runs up to this size become leaves
};

}  // namespace

Bvh build_bvh(std::span<const Box32> boxes, const Workers& workers) {
  return Builder(boxes, workers).build();
}

}  // namespace tia
