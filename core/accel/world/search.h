// The traversal of the world by rays: of its geometries, of their spaces and trees, and of all
// kinds of things in them. What is looked for is defined by the query (queries.h).
#pragma once

#include <algorithm>
#include <bit>
#include <limits>

#include "core/accel/world/lane_hits.h"
#include "core/accel/world/queries.h"
#include "core/accel/world/world.h"
#include "core/boxes/lone_traversal.h"

namespace tia {

/// Search: tries rays on everything in a space that may change the query's answer. If `quick`, the
/// rays of a packet of which only few are left go on one by one, each tried on several things at
/// once. Otherwise every thing is tried on all rays. The answers are the same to the bit.
template <class Real, class Query, bool quick = (lanes<Real> > 1)>
class Search {
 public:
  Search(const Geometry& geometry, Query& query, WorkCounter& work)
      : geometry_(geometry), query_(query), work_(work) {}

  void through(const Space& space, Packet<Real>& packet, Mask<Real> active) {
    for (const std::uint32_t i : space.rest) {
      work_.test();
      const Mask<Real> here = active && packet.box.enters(space.boxes[i], query_.limit());
      if (any(here)) meet(space.items[i], packet, here);
    }
    if (space.balls.few()) {
      for (const std::uint32_t i : space.balls.balls) meet(geometry_.balls[i], packet, active);
    }
    through(
        space.balls.bvh, packet, active,
        [&](std::uint32_t first, std::uint32_t count, Mask<Real> here) {
          meet_balls(space.balls, first, count, packet, here);
        },
        [&](std::uint32_t node, const auto& here) { alone(space.balls, node, packet, here); });
    through(
        space.bvh, packet, active,
        [&](std::uint32_t first, std::uint32_t count, Mask<Real> here) {
          meet_items(space, first, count, packet, here);
        },
        [&](std::uint32_t node, const auto& here) {
          one_by_one(packet, here,
                     [&](Packet<float>& ray, auto& search) { search.below(space, node, ray); });
        });
  }

  /// A single ray through the subtree below a node.
  void below(const Space& space, std::uint32_t node, Packet<float>& ray) {
    with_lone_ray(ray.box, 0, [&](const auto& lone) {
      traverse(space.bvh, node, lone, query_.limit(), work_,
               [&](std::uint32_t first, std::uint32_t count, bool) {
                 meet_items(space, first, count, ray, true);
               });
    });
  }

 private:
  template <class Leaf, class Alone>
  void through(const Bvh& bvh, Packet<Real>& packet, Mask<Real> active, Leaf leaf, Alone alone) {
    if constexpr (!quick) {
      traverse(bvh, packet.box, active, query_.limit(), work_, leaf);
    } else if constexpr (lanes<Real> == 1) {
      if (!bvh.nodes.empty()) alone(0U, active);
    } else {
      if (bvh.nodes.empty()) return;
      if (scattered(packet.box, active) || count(active) <= few_lanes) return alone(0, active);
      const RayInterval interval(packet.box, active);
      traverse(bvh, packet.box, interval, active, query_.limit(), work_, leaf, few_lanes, alone);
    }
  }
  // Calls work(ray, search) for the ray of each lane, with a query and a search of its own.
  template <class Work>
  void one_by_one(const Packet<Real>& packet, Mask<Real> here, Work work) {
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = query_.one(i);
      Packet<float> ray = packet.one(i);
      Search<float, decltype(own), true> search(geometry_, own, work_);
      work(ray, search);
      query_.set_one(i, own);
    }
  }

  // ---- balls ----------------------------------------------------------------------------------

  void meet_balls(const BallIndex& balls, std::uint32_t first, std::uint32_t count,
                  Packet<Real>& packet, Mask<Real> here) {
    for (std::uint32_t i = first; i < first + count; ++i)
      meet(geometry_.balls[balls.bvh.order[i]], packet, here);
  }
  // Each ray by itself through the subtree below a node.
  void alone(const BallIndex& balls, std::uint32_t node, const Packet<Real>& packet,
             Mask<Real> here) {
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = query_.one(i);
      const RootRay<FloatRegister> ray(packet.root.one(i));
      with_lone_ray(packet.box, i, [&](const auto& lone) {
        traverse(balls.bvh, node, lone, own.limit(), work_,
                 [&](std::uint32_t first, std::uint32_t count, bool) {
                   meet_balls(balls, first, count, ray, packet.instance, own);
                 });
      });
      query_.set_one(i, own);
    }
  }
  template <class OneQuery>
  void meet_balls(const BallIndex& balls, std::uint32_t first, std::uint32_t count,
                  const RootRay<FloatRegister>& ray, int instance, OneQuery& query) {
    constexpr auto step = static_cast<std::uint32_t>(lanes<FloatRegister>);
    using P = Precise<FloatRegister>;
    const double* const words = balls.packed.leaf(first);
    for (std::uint32_t from = 0; from < count; from += step) {
      work_.test();
      const auto word = [&](std::uint32_t k) {
        return P::load_unaligned(words + k * count + from);
      };
      const FloatRegister t =
          intersect_sphere<FloatRegister>({word(0), word(1), word(2)}, word(3), ray);
      // Where there is no limit, still none of those that are missed.
      const FloatRegister most(std::min(query.limit(), std::numeric_limits<float>::max()));
      unsigned left = bits(t <= most) & ((1U << (count - from)) - 1);
      for (; left != 0; left &= left - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
        const auto ball = std::bit_cast<BallNumber>(words[4 * count + from + i]);
        if (query.skips(ball.primitive, instance + ball.instance)) continue;
        query.offer(lane(t, static_cast<int>(i)), static_cast<float>(ball.primitive), 0.0F,
                    instance + ball.instance, true);
      }
    }
  }

  // ---- everything else ------------------------------------------------------------------------

  void meet_items(const Space& space, std::uint32_t first, std::uint32_t count,
                  Packet<Real>& packet, Mask<Real> entered) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::uint32_t item = space.bvh.order[i];
      Mask<Real> here = entered;
      if (count > 1) here = here && packet.box.enters(space.boxes[item], query_.limit());
      if (any(here)) meet(space.items[item], packet, here);
    }
  }
  void meet(const Item& item, Packet<Real>& packet, Mask<Real> here) {
    switch (item.kind) {
      case Item::flat: return meet(geometry_.flats[at(item)], packet, here);
      case Item::primitive: return meet_primitive(item.index, packet, here);
      case Item::mesh: return meet_mesh(item.index, packet, here);
      case Item::solid: return meet(geometry_.solids[at(item)], packet, here);
      case Item::grid: return meet(geometry_.grids[at(item)], packet, here);
      case Item::instance: {
        const InstanceGrid& grid = geometry_.grids[at(item)];
        return meet(grid, item.number, packet.seen_through(grid.to_group), here);
      }
    }
  }
  static std::size_t at(const Item& item) { return static_cast<std::size_t>(item.index); }
  static Real number(int i) { return Real(static_cast<float>(i)); }

  [[gnu::flatten]] void meet(const Ball& ball, Packet<Real>& packet, Mask<Real> here) {
    const int instance = packet.instance + ball.instance;
    if (query_.skips(ball.primitive, instance)) return;
    work_.test();
    const Real t = intersect(ball.sphere, packet.root);
    query_.offer(t, number(ball.primitive), Real(0), instance, here);
  }
  [[gnu::flatten]] void meet(const Flat& flat, Packet<Real>& packet, Mask<Real> here) {
    work_.test();
    const Real t = intersect(flat.plane, packet.root);
    query_.offer(t, number(flat.primitive), Real(0), packet.instance, here);
  }

  void offer(const LaneHits<Real>& hits, const Packet<Real>& packet, Mask<Real> here) {
    query_.offer(hits.t, hits.primitive, hits.element, packet.instance, here && hits.t > Real(0));
  }
  void meet_primitive(int primitive, Packet<Real>& packet, Mask<Real> here) {
    if (query_.skips(primitive, packet.instance)) return;
    const Primitive& own = geometry_.primitive(primitive);
    work_.test(count(here) * own.work);
    if constexpr ((lanes<Real>) > 1) {
      if (goes_in_eights(own))
        return offer(hits_in_eights(own, primitive, packet.root, here, query_.limit(), work_),
                     packet, here);
    }
    const auto nearest = [&](const Line& line, double t_max) -> Boundary {
      const auto [hit, more] = nearest_crossing(own, line, t_max);
      work_.add(more);
      return {hit.t, primitive_of(own, primitive, hit.element), hit.element};
    };
    offer(hits_by_lanes(packet.root, here, query_.limit(), nearest), packet, here);
  }
  void meet(const Solid& solid, Packet<Real>& packet, Mask<Real> here) {
    work_.test(count(here) * solid.work);
    const auto first = [&](const Line& line, double) -> Boundary {
      for (const Boundary& each : spans(solid, geometry_.primitives, line, work_))
        if (each.t > 0) return each;
      return {Aabb::far, 0, 0};
    };
    offer(hits_by_lanes(packet.root, here, query_.limit(), first), packet, here);
  }

  void meet_mesh(int primitive, Packet<Real>& packet, Mask<Real> here) {
    if (query_.skips(primitive, packet.instance)) return;
    const Primitive& own = geometry_.primitive(primitive);
    const MeshIndex& mesh = *geometry_.meshes[static_cast<std::size_t>(own.mesh)];
    const bool placed = own.placed;
    const MeshRay<Real> ray(mesh, placed ? packet.seen_through(own.to_object).root : packet.root,
                            !placed && packet.unit_length, extent_of(packet));
    auto triangles = query_.in(ray);
    here = here && triangles.limit > Real(0);
    search<quick>(mesh, ray, triangles, here, work_);
    query_.take(triangles, ray, primitive, packet.instance, here);
  }
  // The largest coordinate of the rays' origins in world space; 0 in the space of a group, where it
  // is not known.
  static Real extent_of(const Packet<Real>& packet) {
    if (!packet.unit_length) return Real(0);
    const auto& o = packet.root.origin;
    return max_of(max_of(abs_of(narrow<Real>(o.x)), abs_of(narrow<Real>(o.y))),
                  abs_of(narrow<Real>(o.z)));
  }

  void meet(const InstanceGrid& grid, Packet<Real>& packet, Mask<Real> here) {
    const Packet<Real> outside = packet.seen_through(grid.to_group);
    traverse(grid, outside.box, here, query_.limit(), work_,
             [&](int number, Mask<Real> entered) { meet(grid, number, outside, entered); });
  }
  // One instance of the grid, in whose own space `outside` is.
  void meet(const InstanceGrid& grid, int number, const Packet<Real>& outside, Mask<Real> here) {
    const int before = outside.instance * static_cast<int>(grid.repeat.copies());
    Packet<Real> packet = outside.inside_instance(grid.offset(number), before + number);
    const Space& space = geometry_.spaces[static_cast<std::size_t>(grid.inside)];
    // If the group has a single thing, the instance's box is its box and has been tried already.
    if (space.items.size() == 1 && space.balls.balls.empty())
      meet(space.items.front(), packet, here);
    else through(space, packet, here);
  }

  const Geometry& geometry_;
  Query& query_;
  WorkCounter& work_;
};

/// Tries the rays on everything in a geometry that may change the query's answer.
template <class Real, class Query>
void search(const Geometry& geometry, Packet<Real>& packet, Mask<Real> active, Query& query,
            WorkCounter& work) {
  if (geometry.primitives.empty()) return;
  Search<Real, Query>(geometry, query, work).through(geometry.spaces.front(), packet, active);
}
/// The same in the world.
template <class Real, class Query>
void search(const World& world, const Ray<Real>& ray, Mask<Real> active, Query& query,
            WorkCounter& work) {
  Packet<Real> packet(ray);
  for (const Geometry* geometry : world.geometries())
    search(*geometry, packet, active, query, work);
}

}  // namespace tia
