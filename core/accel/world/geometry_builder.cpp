#include "core/accel/world/geometry_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/accel/world/own_origin.h"

namespace tia {
namespace {

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
  const auto work = []<class F>(const F& own) {
    if constexpr (TellsWork<F>) return work_of(own);
    else return Part{}.work;
  };
  return std::visit(work, form);
}

}  // namespace

// ---- objects --------------------------------------------------------------------------------

int GeometryBuilder::add_part(Form form, const Setting& at, int object) {
  Part part;
  part.to_object = at.place.inverse();
  part.placed = part.to_object != Affine{};
  const Aabb box = bounds_of(form);
  if (box.bounded()) part.middle = box.center();
  part.work = work_of_form(form);
  forms_bytes_ += heap_of_form(form);
  if (forms_bytes_ > most_forms_bytes)
    throw InputError({FaultKind::limit, "/objects", std::nullopt,
                      "surfaces that are found with less: their cells, patches and voxels take at "
                      "most 256 MiB together"});
  part.form = std::move(form);
  part.matter = at.matter;
  part.object = object;
  part.space = at.space;
  part.inverted = at.inverted;
  return geometry_.first_part + pushed(geometry_.parts, std::move(part));
}

int GeometryBuilder::add(Form form, const Setting& at) {
  const int part = add_part(std::move(form), at, geometry_.objects++);
  const Form& own = geometry_.part(part).form;
  if (const auto* plane = std::get_if<PlaneForm>(&own)) put(*plane, part, at);
  else if (const auto* sphere = std::get_if<Sphere>(&own)) put(*sphere, part, at);
  else put({Item::part, part}, bounds_of(at.place, bounds_of(own)), at.space);
  return part;
}

int GeometryBuilder::add(SharedMesh mesh, const Setting& at) {
  Aabb box;
  for (const Vec3d& p : mesh->positions) box = around(box, at.place.point(p));
  // As much larger as the boxes of its triangles are.
  const double more =
      MeshIndex::room * mesh->unit * (length(at.place.x) + length(at.place.y) + length(at.place.z));
  box = {box.min - Vec3d{more, more, more}, box.max + Vec3d{more, more, more}};
  const int part = add_part(Sphere{}, at, geometry_.objects++);
  geometry_.degenerate += mesh->degenerate;
  geometry_.parts.back().mesh = pushed(geometry_.meshes, std::move(mesh));
  put({Item::mesh, part}, box, at.space);
  return part;
}

void GeometryBuilder::add_numbered(const std::vector<int>& matters) {
  Part part = geometry_.parts.back();
  geometry_.parts.back().numbers = static_cast<int>(matters.size());
  part.numbers = -1;
  for (const int matter : matters) {
    part.matter = matter;
    geometry_.parts.push_back(part);
  }
}

void GeometryBuilder::add(Solid solid, const Aabb& box, int space) {
  for (const Solid::Step& step : solid.steps)
    solid.work += step.part >= 0 ? geometry_.part(step.part).work : 1;
  put({Item::solid, pushed(geometry_.solids, std::move(solid))}, box, space);
}

// A plane is a flat, too, wherever it is.
void GeometryBuilder::put(const PlaneForm& plane, int part, const Setting& at) {
  const Vec3d normal = unit(geometry_.part(part).to_object.row(plane.frame.n));
  const PlaneForm flat{at.place.point(plane.point), onb_around(normal)};
  const int number = pushed(geometry_.flats, Flat{flat, part});
  geometry_.parts.back().flat = number;
  put({Item::flat, number}, bounds(flat), at.space);
}

// A sphere that stays round is a ball, too.
void GeometryBuilder::put(const Sphere& sphere, int part, const Setting& at) {
  const auto scale = similarity(at.place);
  if (!scale) return put({Item::part, part}, bounds_of(at.place, bounds(sphere)), at.space);
  const Sphere round{at.place.point(sphere.center), sphere.radius * *scale};
  geometry_.parts.back().ball = static_cast<int>(geometry_.balls.size());
  put(Ball{round, part}, at.space);
}

// ---- grids ----------------------------------------------------------------------------------

int GeometryBuilder::begin_grid(const Repeat& repeat, const Aabb& box, const Setting& at) {
  const int inside = pushed(geometry_.spaces, Space{});
  const float slack = Copies::slack_of(repeat.swept(box));
  const int grid =
      pushed(geometry_.copies, Copies{at.place.inverse(), repeat, box, inside, at.space, slack});
  geometry_.spaces.back().copies = grid;
  return grid;
}

void GeometryBuilder::end_grid(int number, const Setting& at) {
  const Copies& grid = geometry_.copies[static_cast<std::size_t>(number)];
  const auto scale = similarity(at.place);
  if (at.space == 0 && scale && is_small(grid)) return put_balls(number, at.place, *scale);
  put({Item::copies, number}, bounds_of(at.place, grid.repeat.swept(grid.box)), at.space);
}

// A small grid of balls is quicker found in the world's index than by itself.
bool GeometryBuilder::is_small(const Copies& grid) const {
  constexpr std::int64_t most = 8192;
  const Space& inside = geometry_.space(grid.inside);
  const auto balls = static_cast<std::int64_t>(inside.balls.balls.size());
  return inside.items.empty() && balls * grid.repeat.copies() <= most;
}

void GeometryBuilder::put_balls(int grid_number, const Affine& place, double scale) {
  const Copies& grid = geometry_.copies[static_cast<std::size_t>(grid_number)];
  for (const std::uint32_t number : geometry_.space(grid.inside).balls.balls) {
    const Ball one = geometry_.balls[number];
    for (int copy = 0; copy < grid.repeat.copies(); ++copy) {
      const Vec3d center = place.point(one.sphere.center + grid.offset(copy));
      const Sphere round{center, one.sphere.radius * scale};
      put(Ball{round, one.part, grid_number, copy}, 0);
    }
  }
}

void GeometryBuilder::settle() { tia::settle(geometry_, boxes_); }

// ---- the index ------------------------------------------------------------------------------

void GeometryBuilder::put(Item item, const Aabb& box, int space) {
  if (box.empty()) return;
  geometry_.space(space).items.push_back(item);
  boxes_[space].push_back(box);
}

void GeometryBuilder::put(const Ball& ball, int space) {
  const int number = pushed(geometry_.balls, ball);
  if (!bounds(ball.sphere).empty())
    geometry_.space(space).balls.balls.push_back(static_cast<std::uint32_t>(number));
}

namespace {
// So few are tried in turn: an index costs what it saves.
constexpr std::size_t few_things = 4;
}  // namespace

void GeometryBuilder::index(BallIndex& index) const {
  if (index.balls.size() <= few_things) return;
  std::vector<Box32> boxes;
  boxes.reserve(index.balls.size());
  for (const std::uint32_t i : index.balls)
    boxes.push_back(rounded_outwards(bounds(geometry_.balls[i].sphere)));
  index.bvh = build_bvh(boxes, workers_);
  for (std::uint32_t& each : index.bvh.order) each = index.balls[each];
  index.pack(geometry_.balls, workers_);
}

void GeometryBuilder::index(Space& space, const std::vector<Aabb>& boxes) const {
  std::vector<Box32> bounded;
  std::vector<std::uint32_t> which;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    space.boxes.push_back(rounded_outwards(boxes[i]));
    const auto item = static_cast<std::uint32_t>(i);
    if (boxes.size() <= few_things || !boxes[i].bounded()) {
      space.rest.push_back(item);
      continue;
    }
    bounded.push_back(space.boxes.back());
    which.push_back(item);
  }
  space.bvh = build_bvh(bounded, workers_);
  for (std::uint32_t& each : space.bvh.order) each = which[each];
}

void GeometryBuilder::finish() {
  for (std::size_t i = 0; i < geometry_.spaces.size(); ++i) {
    index(geometry_.spaces[i].balls);
    index(geometry_.spaces[i], boxes_[static_cast<int>(i)]);
  }
}

}  // namespace tia
