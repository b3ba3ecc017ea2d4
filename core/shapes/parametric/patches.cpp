#include "core/shapes/parametric/patches.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/math/tolerances.h"
#include "core/parallel/stopped.h"
#include "core/shapes/subdivision.h"

namespace tia {
namespace {

constexpr std::size_t most_patches = 1 << 15;
// A patch of this share of the whole surface is divided no further, flat or not: at a pole none
// would ever be flat.
constexpr double smallest = 0x1p-14;

using PatchSlopes = Dual<Interval<Octet>, 2>;

double square(const Vec3d& v) { return dot(v, v); }
double longest(const Aabb& box) {
  const Vec3d size = box.size();
  return std::max({size.x, size.y, size.z});
}

/// One coordinate of eight pieces.
struct Coordinate {
  Octet low, high, middle, by_u, by_v, spread_u, spread_v;

  Coordinate(const PatchSlopes& over, const Interval<Octet>& at, const Octet& half_u,
             const Octet& half_v, const OctetMask& smooth) {
    middle = at.middle();
    by_u = over.slope[0].middle();
    by_v = over.slope[1].middle();
    spread_u = interval::up(Octet(over.slope[0].width()));
    spread_v = interval::up(Octet(over.slope[1].width()));
    const Octet reach = interval::up(Octet(at.width())) + (abs_of(by_u) + spread_u) * half_u +
                        (abs_of(by_v) + spread_v) * half_v;
    const Octet room = interval::up(reach, 0x1p-48);
    low = select(smooth, max_of(Octet(middle - room), over.value.lo), over.value.lo);
    high = select(smooth, min_of(Octet(middle + room), over.value.hi), over.value.hi);
  }
};

template <class F>
Octet octet_of(const std::array<Rectangle, 8>& where, F f) {
  std::array<double, 8> each;
  for (std::size_t i = 0; i < 8; ++i) each[i] = f(where[i]);
  return Octet::load_unaligned(each.data());
}

Vec3d lane_of(const std::array<Coordinate, 3>& all, Octet Coordinate::*member, std::size_t i) {
  const int k = static_cast<int>(i);
  return {lane(all[0].*member, k), lane(all[1].*member, k), lane(all[2].*member, k)};
}

class PatchBuilder {
 public:
  PatchBuilder(const Program& surface, const Rectangle& domain) : surface_(surface) {
    SurfacePatch whole;
    whole.where = domain;
    // Nothing is known yet of which side is longer.
    whole.by_u = {1 / domain.half_u, 0, 0};
    whole.by_v = {0, 1 / domain.half_v, 0};
    pending_.push_back({whole, 0, 0});
    nodes_.emplace_back();
  }

  SurfacePatches build() {
    while (!pending_.empty()) {
      const Pending next = pending_.front();
      pending_.pop_front();
      give_way();
      split(next);
    }
    return tree();
  }

 private:
  struct Pending {
    SurfacePatch patch;
    std::size_t node;
    int level;
  };
  struct Node {
    std::array<Aabb, 8> box;  // empty: no child
    std::array<std::size_t, 8> child{};
    std::array<bool, 8> is_leaf{};
  };

  void split(const Pending& from) {
    cost_ += surface_.cost;
    const auto pieces = pieces_of(surface_, eighths(from.patch));
    if (from.level == 0)
      for (const SurfacePiece& each : pieces)
        if (!each.box.empty() && each.box.bounded()) size_ = std::max(size_, longest(each.box));
    for (std::size_t i = 0; i < 8; ++i)
      if (!pieces[i].box.empty()) put(pieces[i], from, i);
  }
  void put(const SurfacePiece& piece, const Pending& from, std::size_t i) {
    const bool last = from.level + 1 == detail::most_tree_levels || full();
    const bool bounded = piece.box.bounded();
    if (last && !bounded) return;
    Node& node = nodes_[from.node];
    node.box[i] = piece.box;
    if (last || (bounded && small_enough(piece))) {
      node.child[i] = patches_.size();
      node.is_leaf[i] = true;
      patches_.push_back(piece.patch);
    } else {
      const std::size_t own = nodes_.size();
      node.child[i] = own;
      pending_.push_back({piece.patch, own, from.level + 1});
      nodes_.emplace_back();
    }
  }
  bool full() const {
    const std::size_t to_come = 8 * (pending_.size() + 1);
    const double cost = cost_ + surface_.cost * static_cast<double>(pending_.size() + 1);
    return patches_.size() + to_come > most_patches || cost > detail::most_tree_cost;
  }
  bool small_enough(const SurfacePiece& piece) const {
    const SurfacePatch& p = piece.patch;
    if (longest(piece.box) <= smallest * size_) return true;
    // Nor may the two slopes be nearly one.
    constexpr double most = detail::flat_enough * detail::flat_enough;
    const double area = square(cross(p.by_u, p.by_v));
    return p.smooth && square(p.spread_u) <= most * square(p.by_u) &&
           square(p.spread_v) <= most * square(p.by_v) &&
           area > 0.05 * square(p.by_u) * square(p.by_v);
  }

  // From the leaves up: a node's box is what its children's are.
  SurfacePatches tree() {
    std::vector<Aabb> boxes(nodes_.size());
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      for (std::size_t i = 0; i < 8; ++i) {
        Aabb& box = nodes_[n].box[i];
        if (box.empty()) continue;
        if (!nodes_[n].is_leaf[i]) box = boxes[nodes_[n].child[i]];
        if (!box.empty()) boxes[n] = around(boxes[n], box);
      }
    }
    SurfacePatches all;
    all.box = boxes.front();
    all.patches = std::move(patches_);
    if (all.box.empty()) return all;
    all.tree.middle = all.box.center();
    all.tree.nodes.resize(nodes_.size());
    const double size = longest(all.box) * tolerance::cell_box;
    const Vec3d more{size, size, size};
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      for (std::size_t i = 0; i < 8; ++i) {
        const Aabb& box = nodes_[n].box[i];
        if (box.empty()) continue;
        const Aabb own{box.min - more - all.tree.middle, box.max + more - all.tree.middle};
        if (nodes_[n].is_leaf[i]) all.tree.add_leaf(n, own, nodes_[n].child[i]);
        else all.tree.add_node(n, own, nodes_[n].child[i]);
      }
    return all;
  }

  const Program& surface_;
  std::deque<Pending> pending_;
  std::vector<Node> nodes_;
  std::vector<SurfacePatch> patches_;
  double size_ = 0, cost_ = 0;
};

}  // namespace

std::array<SurfacePiece, 8> pieces_of(const Program& surface,
                                      const std::array<Rectangle, 8>& where) {
  using I = Interval<Octet>;
  const Octet u = octet_of(where, [](const Rectangle& r) { return r.u; });
  const Octet v = octet_of(where, [](const Rectangle& r) { return r.v; });
  const Octet half_u = octet_of(where, [](const Rectangle& r) { return r.half_u; });
  const Octet half_v = octet_of(where, [](const Rectangle& r) { return r.half_v; });
  const std::array<I, 2> at{I(u, u), I(v, v)};
  Definedness<Octet> everywhere, in_the_middle;
  const I* const slots = run(surface, at.data(), in_the_middle);
  std::array<I, 3> middles;
  for (std::size_t k = 0; k < 3; ++k) middles[k] = slots[surface.results[k]];
  const std::array<PatchSlopes, 2> box{
      PatchSlopes::variable(interval::outwards(Octet(u - half_u), Octet(u + half_u)), 0),
      PatchSlopes::variable(interval::outwards(Octet(v - half_v), Octet(v + half_v)), 1)};
  const PatchSlopes* const over = run(surface, box.data(), everywhere);
  const OctetMask smooth = everywhere.whole && in_the_middle.whole;
  const auto coordinate = [&](std::size_t k) {
    return Coordinate(over[surface.results[k]], middles[k], half_u, half_v, smooth);
  };
  const std::array<Coordinate, 3> all{coordinate(0), coordinate(1), coordinate(2)};

  std::array<SurfacePiece, 8> pieces;
  const unsigned some = bits(everywhere.some), smooth_bits = bits(smooth);
  for (std::size_t i = 0; i < 8; ++i) {
    if ((some >> i & 1) == 0) continue;
    SurfacePatch& patch = pieces[i].patch;
    patch = {where[i],
             lane_of(all, &Coordinate::middle, i),
             lane_of(all, &Coordinate::by_u, i),
             lane_of(all, &Coordinate::by_v, i),
             lane_of(all, &Coordinate::spread_u, i),
             lane_of(all, &Coordinate::spread_v, i),
             false};
    const double slopes = square(patch.spread_u) + square(patch.spread_v) + square(patch.middle);
    patch.smooth = (smooth_bits >> i & 1) != 0 && std::isfinite(slopes);
    pieces[i].box = {lane_of(all, &Coordinate::low, i), lane_of(all, &Coordinate::high, i)};
  }
  return pieces;
}

std::array<Rectangle, 8> eighths(const SurfacePatch& patch) {
  // As steep as they may be: over a whole turn the middle slope is 0.
  const double u = std::sqrt(square(patch.by_u)) + std::sqrt(square(patch.spread_u));
  const double v = std::sqrt(square(patch.by_v)) + std::sqrt(square(patch.spread_v));
  const bool known = std::isfinite(u) && std::isfinite(v) && u + v > 0;
  std::array<Rectangle, 8> parts{patch.where};
  for (std::size_t count = 1; count < 8; count *= 2) {
    const double long_u = parts[0].half_u * (known ? u : 1);
    const double long_v = parts[0].half_v * (known ? v : 1);
    for (std::size_t i = 0; i < count; ++i) {
      Rectangle &low = parts[i], &high = parts[count + i] = low;
      double Rectangle::*const middle = long_u >= long_v ? &Rectangle::u : &Rectangle::v;
      double Rectangle::*const half = long_u >= long_v ? &Rectangle::half_u : &Rectangle::half_v;
      low.*half /= 2;
      high.*half /= 2;
      low.*middle -= low.*half;
      high.*middle += high.*half;
    }
  }
  return parts;
}

SurfacePatches patches_of(const Program& surface, const Rectangle& domain) {
  return PatchBuilder(surface, domain).build();
}

}  // namespace tia
