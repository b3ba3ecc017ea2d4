#include "core/accel/world_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tia {
namespace {

constexpr std::size_t few = 16;

// A point as seen from anywhere, whose light does not fade.
bool is_plain_point(const Lamp& lamp) {
  const bool point =
      std::holds_alternative<PointForm>(lamp.form) || std::holds_alternative<SphereForm>(lamp.form);
  return point && lamp.fade_distance == 0 && lamp.places == nullptr;
}

// Whether it scatters light and does nothing else.
bool is_plain(const Matter& matter) {
  return !emits(matter.ambient.exact) && matter.brilliance == 1 && matter.specular == 0 &&
         matter.reflection == 0 && matter.transmission == 0 && matter.texture < 0;
}

bool is_few_balls(const World& world) {
  return world.balls.size() == world.parts.size() && world.copies.empty() &&
         world.balls.size() <= few && std::ranges::all_of(world.matters, is_plain) &&
         std::ranges::all_of(world.lamps, is_plain_point);
}

// By how much a map scales all lengths alike; nothing where it does not.
std::optional<double> similarity(const Affine& map) {
  constexpr double slack = 1e-14;
  const double xx = dot(map.x, map.x), yy = dot(map.y, map.y), zz = dot(map.z, map.z);
  const double worst =
      std::max({std::fabs(yy - xx), std::fabs(zz - xx), std::fabs(dot(map.x, map.y)),
                std::fabs(dot(map.y, map.z)), std::fabs(dot(map.z, map.x))});
  if (worst > slack * xx) return std::nullopt;
  return std::sqrt(xx);
}

Aabb bounds_of(const Form& form) {
  return std::visit([](const auto& own) { return bounds(own); }, form);
}

int work_of_form(const Form& form) {
  const auto work = [](const auto& own) {
    if constexpr (requires { work_of(own); }) return work_of(own);
    else return Part{}.work;
  };
  return std::visit(work, form);
}

}  // namespace

// ---- objects --------------------------------------------------------------------------------

int WorldBuilder::add_part(Form form, const Setting& at, int object) {
  Part part;
  part.to_object = at.place.inverse();
  const Aabb box = bounds_of(form);
  if (box.bounded()) part.middle = box.center();
  part.work = work_of_form(form);
  part.form = std::move(form);
  part.matter = at.matter;
  part.object = object;
  part.space = at.space;
  part.inverted = at.inverted;
  return pushed(world_.parts, std::move(part));
}

int WorldBuilder::add(Form form, const Setting& at) {
  const int part = add_part(std::move(form), at, world_.objects++);
  const Form& own = world_.part(part).form;
  if (const auto* plane = std::get_if<PlaneForm>(&own)) put(*plane, part, at);
  else if (const auto* sphere = std::get_if<Sphere>(&own)) put(*sphere, part, at);
  else put({Item::part, part}, bounds_of(at.place, bounds_of(own)), at.space);
  return part;
}

int WorldBuilder::add(const Mesh& mesh, const Setting& at) {
  MeshIndex index(mesh, stop_);
  Aabb box;
  for (const Vec3d& p : index.positions) box = around(box, at.place.point(p));
  const int part = add_part(Sphere{}, at, world_.objects++);
  world_.parts.back().mesh = pushed(world_.meshes, std::move(index));
  put({Item::mesh, part}, box, at.space);
  return part;
}

void WorldBuilder::add(Solid solid, const Aabb& box, int space) {
  for (const Solid::Step& step : solid.steps)
    solid.work += step.part >= 0 ? world_.part(step.part).work : 1;
  put({Item::solid, pushed(world_.solids, std::move(solid))}, box, space);
}

// A plane is a flat, too, wherever it is.
void WorldBuilder::put(const PlaneForm& plane, int part, const Setting& at) {
  const Vec3d normal = unit(world_.part(part).to_object.row(plane.frame.n));
  const PlaneForm flat{at.place.point(plane.point), onb_around(normal)};
  const int number = pushed(world_.flats, Flat{flat, part});
  world_.parts.back().flat = number;
  put({Item::flat, number}, bounds(flat), at.space);
}

// A sphere that stays round is a ball, too.
void WorldBuilder::put(const Sphere& sphere, int part, const Setting& at) {
  const auto scale = similarity(at.place);
  if (!scale) return put({Item::part, part}, bounds_of(at.place, bounds(sphere)), at.space);
  const Sphere round{at.place.point(sphere.center), sphere.radius * *scale};
  const int ball = pushed(world_.balls, Ball{round, part});
  world_.parts.back().ball = ball;
  put({Item::ball, ball}, bounds(round), at.space);
}

// ---- grids ----------------------------------------------------------------------------------

int WorldBuilder::begin_grid(const Repeat& repeat, const Aabb& box, const Setting& at) {
  const int inside = pushed(world_.spaces, Space{});
  const float slack = Copies::slack_of(repeat.swept(box));
  const int grid =
      pushed(world_.copies, Copies{at.place.inverse(), repeat, box, inside, at.space, slack});
  world_.spaces.back().copies = grid;
  return grid;
}

void WorldBuilder::end_grid(int number, const Setting& at) {
  const Copies& grid = world_.copies[static_cast<std::size_t>(number)];
  const auto scale = similarity(at.place);
  if (at.space == 0 && scale && is_small(grid)) return put_balls(number, at.place, *scale);
  put({Item::copies, number}, bounds_of(at.place, grid.repeat.swept(grid.box)), at.space);
}

// A small grid of balls is quicker found in the index of the world than by itself.
bool WorldBuilder::is_small(const Copies& grid) const {
  constexpr std::int64_t most = 8192;
  const std::vector<Item>& items = world_.space(grid.inside).items;
  return static_cast<std::int64_t>(items.size()) * grid.repeat.copies() <= most &&
         std::ranges::all_of(items, [](const Item& item) { return item.kind == Item::ball; });
}

void WorldBuilder::put_balls(int number, const Affine& place, double scale) {
  const Copies& grid = world_.copies[static_cast<std::size_t>(number)];
  for (const Item& item : world_.space(grid.inside).items) {
    const Ball one = world_.balls[static_cast<std::size_t>(item.index)];
    for (int copy = 0; copy < grid.repeat.copies(); ++copy) {
      const Vec3d center = place.point(one.sphere.center + grid.offset(copy));
      const Sphere round{center, one.sphere.radius * scale};
      const Ball ball{round, one.part, number, copy};
      put({Item::ball, pushed(world_.balls, ball)}, bounds(round), 0);
    }
  }
}

// ---- the index ------------------------------------------------------------------------------

void WorldBuilder::put(Item item, const Aabb& box, int space) {
  if (box.empty()) return;
  world_.space(space).items.push_back(item);
  boxes_[space].push_back(box);
}

void WorldBuilder::index(Space& space, const std::vector<Aabb>& boxes) {
  std::vector<Aabb> bounded;
  std::vector<std::uint32_t> which;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    space.boxes.push_back(rounded_outwards(boxes[i]));
    const auto item = static_cast<std::uint32_t>(i);
    if (!boxes[i].bounded()) {
      space.rest.push_back(item);
      continue;
    }
    bounded.push_back(boxes[i]);
    which.push_back(item);
  }
  space.bvh = build_bvh(bounded, stop_);
  for (std::uint32_t& each : space.bvh.order) each = which[each];
}

void WorldBuilder::finish() {
  for (std::size_t i = 0; i < world_.spaces.size(); ++i)
    index(world_.spaces[i], boxes_[static_cast<int>(i)]);
  world_.few_balls = is_few_balls(world_);
  for (const MeshIndex& mesh : world_.meshes) world_.degenerate += mesh.degenerate;
}

}  // namespace tia
