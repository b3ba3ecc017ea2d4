// The search of rays through the world: its geometries, their spaces with their indices, and all
// kinds of things in them. What is searched for is the query's business.
#pragma once

#include <array>

#include "core/accel/trace.h"

namespace tia {

// ---- queries: what a search through the world is for ----------------------------------------

/// The nearest hit with t > 0; at equal t the object, copy and element that comes first.
template <class Real>
struct Nearest {
  Hit<Real> hit{};
  int own = -1, own_copy = 0;  ///< the part that does not count; -1: none

  const Real& limit() const { return hit.t; }
  bool skips(int part, int copy) const { return part == own && copy == own_copy; }
  void offer(const Real& t, const Real& part, const Real& element, int copy, Mask<Real> here) {
    const Real number(static_cast<float>(copy));
    const auto first = [](const Real& a, const Real& b, Mask<Real> after) -> Mask<Real> {
      return a < b || (a == b && after);
    };
    const Mask<Real> earlier =
        first(part, hit.part, first(number, hit.copy, element < hit.element));
    const Mask<Real> nearer = here && first(t, hit.t, t < Real(infinity) && earlier);
    hit.t = select(nearer, t, hit.t);
    hit.part = select(nearer, part, hit.part);
    hit.element = select(nearer, element, hit.element);
    hit.copy = select(nearer, number, hit.copy);
  }
};

/// Whether anything but one part of one copy stands between the ray's origin and t_max.
template <class Real>
struct AnyHit {
  Real t_max;  ///< below 0 where something does: then nothing is left to look for
  int own = -1, own_copy = 0;

  const Real& limit() const { return t_max; }
  Mask<Real> blocked() const { return t_max < Real(0); }
  bool skips(int part, int copy) const { return part == own && copy == own_copy; }
  void offer(const Real& t, const Real&, const Real&, int, Mask<Real> here) {
    t_max = select(here && t < t_max, Real(-1), t_max);
  }
};

// ---- the search -----------------------------------------------------------------------------

/// Tries the rays on everything of a space that may answer the query.
template <class Real, class Query>
class Search {
 public:
  Search(const Geometry& geometry, Query& query, Effort& effort)
      : geometry_(geometry), query_(query), effort_(effort) {}

  void through(const Space& space, Packet<Real>& packet, Mask<Real> active) {
    for (const std::uint32_t i : space.rest) meet(space.items[i], packet, active);
    traverse(space.bvh, packet.box, active, query_.limit(), effort_,
             [&](std::uint32_t i, Mask<Real> here, bool alone) {
               // A ball tells as soon as its box does.
               const Item& item = space.items[i];
               if (!alone && item.kind != Item::ball)
                 here = here && packet.box.enters(space.boxes[i], query_.limit());
               if (any(here)) meet(item, packet, here);
             });
  }

  /// The same without the index, which costs more than the boxes of a few.
  void through_few(const Space& space, Packet<Real>& packet, Mask<Real> active) {
    for (std::size_t i = 0; i < space.items.size(); ++i) {
      effort_.test();
      const Mask<Real> here = active && packet.box.enters(space.boxes[i], query_.limit());
      if (any(here)) meet(space.items[i], packet, here);
    }
  }

 private:
  static constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  using Lanes = std::array<LaneOf<Real>, n>;

  void meet(const Item& item, Packet<Real>& packet, Mask<Real> here) {
    switch (item.kind) {
      case Item::ball: return meet(geometry_.balls[at(item)], packet, here);
      case Item::flat: return meet(geometry_.flats[at(item)], packet, here);
      case Item::part: return meet_part(item.index, packet, here);
      case Item::mesh: return meet_mesh(item.index, packet, here);
      case Item::solid: return meet(geometry_.solids[at(item)], packet, here);
      case Item::copies: return meet(geometry_.copies[at(item)], packet, here);
    }
  }
  static std::size_t at(const Item& item) { return static_cast<std::size_t>(item.index); }
  static Real number(int i) { return Real(static_cast<float>(i)); }

  [[gnu::flatten]] void meet(const Ball& ball, Packet<Real>& packet, Mask<Real> here) {
    const int copy = packet.copy + ball.copy;
    if (query_.skips(ball.part, copy)) return;
    effort_.test();
    const Real t = intersect(ball.sphere, packet.root);
    query_.offer(t, number(ball.part), Real(0), copy, here);
  }
  [[gnu::flatten]] void meet(const Flat& flat, Packet<Real>& packet, Mask<Real> here) {
    effort_.test();
    const Real t = intersect(flat.plane, packet.root);
    query_.offer(t, number(flat.part), Real(0), packet.copy, here);
  }

  // Lane by lane in double; `work` is what each costs.
  template <class F>
  void meet_lanes(Packet<Real>& packet, Mask<Real> here, std::int64_t work, F crossing_of) {
    effort_.test(count(here) * work);
    Lanes t, part, element;
    t.fill(infinity);
    part.fill(0);
    element.fill(0);
    const Lines<Real> lines(packet.root);
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const Boundary hit = crossing_of(lines[lane]);
      t[lane] = static_cast<LaneOf<Real>>(hit.t);
      part[lane] = static_cast<LaneOf<Real>>(hit.part);
      element[lane] = static_cast<LaneOf<Real>>(hit.element);
    }
    const Real at = load<Real>(t.data());
    query_.offer(at, load<Real>(part.data()), load<Real>(element.data()), packet.copy,
                 here && at > Real(0));
  }
  void meet_part(int part, Packet<Real>& packet, Mask<Real> here) {
    if (query_.skips(part, packet.copy)) return;
    const Part& own = geometry_.part(part);
    meet_lanes(packet, here, own.work, [&](const Line& line) -> Boundary {
      const Crossing hit = nearest_crossing(own, line);
      return {hit.t, part, hit.element};
    });
  }
  void meet(const Solid& solid, Packet<Real>& packet, Mask<Real> here) {
    meet_lanes(packet, here, solid.work, [&](const Line& line) -> Boundary {
      for (const Boundary& each : spans(solid, geometry_.parts, line))
        if (each.t > 0) return each;
      return {Aabb::far, 0, 0};
    });
  }

  void meet_mesh(int part, Packet<Real>& packet, Mask<Real> here) {
    if (query_.skips(part, packet.copy)) return;
    const Part& own = geometry_.part(part);
    const MeshIndex& mesh = *geometry_.meshes[static_cast<std::size_t>(own.mesh)];
    Packet<Real> inside = packet.seen_through(own.to_object);
    const RayFrame<Precise<Real>> frame = frame_of(inside);
    traverse(mesh.bvh, inside.box, here, query_.limit(), effort_,
             [&](std::uint32_t triangle, Mask<Real> entered, bool) {
               effort_.test();
               const Real t = intersect<Real>(mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                                              mesh.corner(triangle, 2), frame);
               query_.offer(t, number(part), number(static_cast<int>(triangle)), packet.copy,
                            entered);
             });
  }

  void meet(const Copies& grid, Packet<Real>& packet, Mask<Real> here) {
    const Packet<Real> outside = packet.seen_through(grid.to_group);
    const int before = packet.copy * static_cast<int>(grid.repeat.copies());
    const Space& space = geometry_.spaces[static_cast<std::size_t>(grid.inside)];
    traverse(grid, outside.box, here, query_.limit(), effort_, [&](int copy, Mask<Real> entered) {
      Packet<Real> inside = outside.inside_copy(grid.offset(copy), before + copy);
      // The box of a copy of one thing is that thing's.
      if (space.items.size() == 1) meet(space.items.front(), inside, entered);
      else through(space, inside, entered);
    });
  }

  const Geometry& geometry_;
  Query& query_;
  Effort& effort_;
};

/// Tries the rays on everything of the world that may answer the query.
template <class Real, class Query>
void search(const World& world, const Ray<Real>& ray, Mask<Real> active, Query& query,
            Effort& effort) {
  Packet<Real> packet(ray);
  Search<Real, Query>(*world.of_objects, query, effort)
      .through(world.of_objects->spaces.front(), packet, active);
  constexpr std::size_t few = 4;
  const Space& lights = world.of_lights.spaces.front();
  if (lights.items.empty()) return;
  Search<Real, Query> among_lights(world.of_lights, query, effort);
  if (lights.items.size() <= few) among_lights.through_few(lights, packet, active);
  else among_lights.through(lights, packet, active);
}

}  // namespace tia
