#include "core/accel/world/all_hits.h"

#include <algorithm>
#include <tuple>

#include "core/accel/mesh/mesh_search.h"

namespace tia {
namespace {

constexpr std::int64_t most_work = 4'000'000;

[[noreturn]] void fail(const std::string& allowed) {
  throw InputError({FaultKind::limit, "", std::nullopt, allowed});
}

// A query as those of mesh_search.h, without a limit.
template <class Add>
struct EveryTriangle {
  Add add;
  double limit = Aabb::far;
  void offer(double m, double triangle, bool here) const {
    if (here) add(m, triangle);
  }
};
template <class Add>
EveryTriangle(Add) -> EveryTriangle<Add>;

class Collector {
 public:
  Collector(const Geometry& geometry, std::vector<Meeting>& found, WorkCounter& work)
      : geometry_(geometry), found_(found), work_(work) {}

  void through(const Space& space, Packet<double>& packet) {
    for (const std::uint32_t i : space.rest) meet(space.items[i], packet);
    const auto meet_ball = [&](std::uint32_t i) { meet(geometry_.balls[i], packet); };
    if (space.balls.few()) std::ranges::for_each(space.balls.balls, meet_ball);
    else for_each_of(space.balls.bvh, packet, meet_ball);
    for_each_of(space.bvh, packet, [&](std::uint32_t i) { meet(space.items[i], packet); });
  }

 private:
  template <class Visit>
  void for_each_of(const Bvh& bvh, Packet<double>& packet, Visit visit) {
    traverse(bvh, packet.box, true, endless_, work_,
             [&](std::uint32_t first, std::uint32_t count, bool) {
               for (std::uint32_t i = first; i < first + count; ++i) visit(bvh.order[i]);
             });
  }
  void meet(const Item& item, Packet<double>& packet) {
    const auto at = static_cast<std::size_t>(item.index);
    switch (item.kind) {
      case Item::flat: return meet_primitive(geometry_.flats[at].primitive, packet);
      case Item::primitive: return meet_primitive(item.index, packet);
      case Item::mesh: return meet_mesh(item.index, packet);
      case Item::solid: return meet(geometry_.solids[at], packet);
      case Item::grid: return meet(geometry_.grids[at], packet);
      case Item::instance: {
        const InstanceGrid& grid = geometry_.grids[at];
        return meet(grid, item.number, packet.seen_through(grid.to_group));
      }
    }
  }
  void add(double t, int primitive, int element, const Packet<double>& packet,
           const std::optional<Bracket>& bracket = {}) {
    if (!(t > 0 && t < Aabb::far)) return;
    if (found_.size() == most_hits)
      fail(std::string("a ray that crosses at most ")
               .append(std::to_string(most_hits))
               .append(" surfaces"));
    found_.push_back(
        {.t = t, .primitive = primitive, .element = element, .instance = packet.instance});
    found_.back().bracket = bracket;
  }
  void meet(const Solid& solid, Packet<double>& packet) {
    work_.test(solid.work);
    const Line line = Lines<double>(packet.root)[0];
    for (const Boundary& each : spans(solid, geometry_.primitives, line, work_))
      add(each.t, each.primitive, each.element, packet, bracket_of(each, line));
  }
  // A solid's boundary is a crossing of one of its primitives, and has the same t to the bit.
  std::optional<Bracket> bracket_of(const Boundary& at, const Line& line) {
    const Primitive& primitive = geometry_.primitive(at.primitive);
    work_.test(primitive.work);
    std::optional<Bracket> found;
    work_.add(spans(primitive, line,
                    [&](double t, int element, const std::optional<Bracket>& bracket = {}) {
                      if (t == at.t && element == at.element) found = bracket;
                    }));
    return found;
  }
  void meet(const Ball& ball, Packet<double>& packet) {
    if (ball.grid < 0) return meet_primitive(ball.primitive, packet);
    const InstanceGrid& grid = geometry_.grids[static_cast<std::size_t>(ball.grid)];
    Packet<double> inside = packet.seen_through(grid.to_group)
                                .inside_instance(grid.offset(ball.instance), ball.instance);
    meet_primitive(ball.primitive, inside);
  }
  void meet_primitive(int primitive, Packet<double>& packet) {
    const Primitive& own = geometry_.primitive(primitive);
    work_.test(own.work);
    work_.add(crossings(own, Lines<double>(packet.root)[0],
                        [&](double t, int element, const std::optional<Bracket>& bracket = {}) {
                          add(t, primitive_of(own, primitive, element), element, packet, bracket);
                        }));
  }
  void meet_mesh(int primitive, Packet<double>& packet) {
    const Primitive& own = geometry_.primitive(primitive);
    const MeshIndex& mesh = *geometry_.meshes[static_cast<std::size_t>(own.mesh)];
    const MeshRay<double> ray(mesh, packet.seen_through(own.to_object).root, false, 0.0);
    EveryTriangle triangles{[&](double m, double triangle) {
      add(ray.t_of(m), primitive, static_cast<int>(triangle), packet);
    }};
    search<false>(mesh, ray, triangles, true, work_);
  }
  void meet(const InstanceGrid& grid, Packet<double>& packet) {
    const Packet<double> outside = packet.seen_through(grid.to_group);
    traverse(grid, outside.box, true, endless_, work_,
             [&](int number, bool) { meet(grid, number, outside); });
  }
  // One instance of the grid, in whose own space `outside` is.
  void meet(const InstanceGrid& grid, int number, const Packet<double>& outside) {
    const int before = outside.instance * static_cast<int>(grid.repeat.copies());
    Packet<double> packet = outside.inside_instance(grid.offset(number), before + number);
    through(geometry_.spaces[static_cast<std::size_t>(grid.inside)], packet);
  }

  const Geometry& geometry_;
  std::vector<Meeting>& found_;
  WorkCounter& work_;
  double endless_ = Aabb::far;
};

// Whether two triangles of one mesh are hit at the same point, on an edge or corner that they
// share. Their t are found in double, and differ by some 1e-16 over the sine between ray and
// triangle.
bool same_place(const World& world, const Meeting& a, const Meeting& b) {
  constexpr double slack = 1e-12;
  return a.primitive == b.primitive && a.instance == b.instance &&
         world.primitive(a.primitive).mesh >= 0 && b.t - a.t <= slack * b.t;
}

}  // namespace

std::vector<Meeting> all_hits(const World& world, const Ray<double>& ray) {
  std::vector<Meeting> found;
  std::int64_t done = 0;
  WorkCounter work([&](std::int64_t portion) {
    done += portion;
    if (done > most_work) fail("a ray that is tried on less: too much overlaps");
  });
  Packet<double> packet(ray);
  for (const Geometry* each : world.geometries())
    Collector(*each, found, work).through(each->spaces.front(), packet);
  std::sort(found.begin(), found.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.t, a.primitive, a.instance, a.element) <
           std::tie(b.t, b.primitive, b.instance, b.element);
  });
  const auto one = [&](const Meeting& a, const Meeting& b) { return same_place(world, a, b); };
  found.erase(std::unique(found.begin(), found.end(), one), found.end());
  std::erase_if(found, [&](const Meeting& at) {
    return is_passed(world, ray,
                     {at.t, static_cast<double>(at.primitive), static_cast<double>(at.element),
                      static_cast<double>(at.instance)});
  });
  for (Meeting& each : found) {
    each.point = ray.at(each.t);
    each.normal = normals_at(world, each.point, each.primitive, each.element, each.instance).ng;
    each.uv = uv_at(world, each.point, each.primitive, each.element, each.instance);
    if (!(dot(each.normal, each.normal) > 0))
      each.normal = -ray.direction;  // so small that its normal underflows
    each.front = dot(each.normal, ray.direction) < 0;
  }
  return found;
}

}  // namespace tia
