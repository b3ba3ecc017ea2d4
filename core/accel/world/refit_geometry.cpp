#include "core/accel/world/refit_geometry.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/accel/world/geometry_builder.h"
#include "core/accel/world/own_origin.h"
#include "core/boxes/refit_bvh.h"

namespace tia {
namespace {

// Whether it is one surface, or a group of such that is not repeated.
bool is_of_surfaces(const Object& object) {
  if (const auto* group = std::get_if<Group>(&object.shape))
    return !group->repeat && std::ranges::all_of(group->children, is_of_surfaces);
  return std::visit([]<class Kind>(const Kind&) { return IsSurface<Kind>; }, object.shape);
}

// How many objects it counts as in a geometry.
int objects_in(const Object& object) {
  if (!is_many(object)) return 1;
  const auto& children = *children_of(object);
  return std::accumulate(children.begin(), children.end(), 0,
                         [](int sum, const Object& child) { return sum + objects_in(child); });
}

bool is_bounded(const Box32& box) {
  return box.min.x > -infinity && box.min.y > -infinity && box.min.z > -infinity &&
         box.max.x < infinity && box.max.y < infinity && box.max.z < infinity;
}

/// Refit: one geometry, and what of the scene is put into it.
class Refit {
 public:
  Refit(Geometry& geometry, const Scene& scene, const std::vector<std::size_t>& moved,
        const Workers& workers)
      : geometry_(geometry), world_(geometry.spaces.front()), workers_(workers) {
    if (geometry.origin == Vec3d{}) fits_ = find_primitives(scene, moved);
    if (!fits_) return;
    Scene part;
    part.materials = scene.materials;
    part.ambient_light = scene.ambient_light;
    std::vector<Object> objects;
    for (const std::size_t each : moved) objects.push_back(scene.objects[each]);
    part.objects = std::move(objects);
    now_ = placed_objects(part, workers);
  }

  bool operator()() {
    if (!fits_ || !is_alike() || !put_items()) return false;
    put_primitives();
    if (!surely_keeps_origin(geometry_)) return false;
    if (!moved_items_.empty())
      refit_bvh(world_.bvh, moved_items_, [&](std::uint32_t i) { return world_.boxes[i]; });
    BallIndex& balls = world_.balls;
    if (moved_balls_.empty() || balls.few()) return true;
    refit_bvh(balls.bvh, moved_balls_,
              [&](std::uint32_t i) { return rounded_outwards(bounds(geometry_.balls[i].sphere)); });
    balls.pack(geometry_.balls, workers_);
    return true;
  }

 private:
  Primitive& before(std::size_t i) {
    return geometry_.primitives[static_cast<std::size_t>(where_[i])];
  }

  // The numbers of the moved objects' primitives, in the order in which they are placed anew.
  bool find_primitives(const Scene& scene, const std::vector<std::size_t>& moved) {
    const std::vector<Object>& objects = scene.objects;
    int object = 0;
    std::size_t next = 0;
    for (const std::size_t each : moved) {
      if (!is_of_surfaces(objects[each])) return false;
      for (; next < each; ++next) object += objects_in(objects[next]);
      const int end = object + objects_in(objects[each]);
      const auto first =
          std::ranges::lower_bound(geometry_.primitives, object, {}, &Primitive::object);
      for (auto own = first; own != geometry_.primitives.end() && own->object < end; ++own)
        where_.push_back(static_cast<int>(own - geometry_.primitives.begin()));
    }
    return true;
  }

  // Whether all that is there now was there before in the same form, with the same material.
  bool is_alike() {
    const Geometry& now = now_.geometry;
    if (now.primitives.size() != where_.size() || !now.areas.empty() || !now.lights.empty())
      return false;
    for (std::size_t i = 0; i < where_.size(); ++i) {
      const Primitive &own = now.primitives[i], &was = before(i);
      if (own.form.index() != was.form.index() || own.numbers != was.numbers ||
          (own.ball < 0) != (was.ball < 0) || (own.flat < 0) != (was.flat < 0))
        return false;
      if (own.ball >= 0 &&
          (has_no_bounds(ball_of(now, own)) || has_no_bounds(ball_of(geometry_, was))))
        return false;
    }
    return true;
  }
  static const Sphere& ball_of(const Geometry& geometry, const Primitive& primitive) {
    return geometry.balls[static_cast<std::size_t>(primitive.ball)].sphere;
  }
  static bool has_no_bounds(const Sphere& ball) { return bounds(ball).empty(); }

  // Items in both stand in the order of their primitives. Returns: whether there are as many.
  bool put_items() {
    std::map<std::pair<Item::Kind, int>, std::size_t> boxes;
    for (const Item& item : now_.geometry.spaces.front().items) {
      const std::size_t box = boxes.size();
      boxes.emplace(std::pair(item.kind, number_before(item)), box);
    }
    if (boxes.empty()) return true;
    moved_items_.resize(world_.items.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < world_.items.size(); ++i) {
      const auto now = boxes.find({world_.items[i].kind, world_.items[i].index});
      if (now == boxes.end()) continue;
      const Box32 box = rounded_outwards(now_.boxes[now->second]);
      if (is_bounded(box) != is_bounded(world_.boxes[i])) return false;
      world_.boxes[i] = box;
      moved_items_[i] = true;
      ++found;
    }
    return found == boxes.size();
  }
  int number_before(const Item& item) {
    const auto index = static_cast<std::size_t>(item.index);
    if (item.kind != Item::flat) return where_[index];
    return before(static_cast<std::size_t>(now_.geometry.flats[index].primitive)).flat;
  }

  void put_primitives() {
    for (std::size_t i = 0; i < where_.size(); ++i) {
      Primitive &now = now_.geometry.primitives[i], &own = before(i);
      own.form = std::move(now.form);
      own.to_object = now.to_object;
      own.placed = now.placed;
      own.middle = now.middle;
      own.work = now.work;
      if (own.flat >= 0)
        geometry_.flats[static_cast<std::size_t>(own.flat)].plane =
            now_.geometry.flats[static_cast<std::size_t>(now.flat)].plane;
      if (own.ball < 0) continue;
      const auto ball = static_cast<std::size_t>(own.ball);
      geometry_.balls[ball].sphere = ball_of(now_.geometry, now);
      moved_balls_.resize(geometry_.balls.size());
      moved_balls_[ball] = true;
    }
  }

  Geometry& geometry_;
  Space& world_;
  const Workers& workers_;
  bool fits_ = false;
  PlacedObjects now_;       // the moved objects
  std::vector<int> where_;  // each of their primitives in the geometry
  std::vector<bool> moved_items_, moved_balls_;
};

}  // namespace

bool refit(Geometry& geometry, const Scene& scene, const std::vector<std::size_t>& moved,
           const Workers& workers) {
  return Refit(geometry, scene, moved, workers)();
}

}  // namespace tia
