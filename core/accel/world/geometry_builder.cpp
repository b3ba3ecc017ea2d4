#include "core/accel/world/geometry_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/accel/world/own_origin.h"

namespace tia {
namespace {

// The factor by which a map scales all lengths; nothing where it scales some more than others. The
// slack is 45 roundings of double, more than a dozen products of maps leave.
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
    else return Primitive{}.work;
  };
  return std::visit(work, form);
}

}  // namespace

// ---- objects --------------------------------------------------------------------------------

int GeometryBuilder::add_primitive(Form form, const Setting& at, int object) {
  Primitive primitive;
  primitive.to_object = at.place.inverse();
  primitive.placed = primitive.to_object != Affine{};
  const Aabb box = bounds_of(form);
  if (box.bounded()) primitive.middle = box.center();
  primitive.work = work_of_form(form);
  forms_bytes_ += heap_of_form(form);
  if (forms_bytes_ > most_forms_bytes)
    throw InputError({FaultKind::limit, "/objects", std::nullopt,
                      "surfaces that are found with less: their cells, patches and voxels take at "
                      "most 256 MiB together"});
  primitive.form = std::move(form);
  primitive.shading = at.shading;
  primitive.object = object;
  primitive.space = at.space;
  primitive.inverted = at.inverted;
  primitive.culls = at.culls;
  return geometry_.first_primitive + pushed(geometry_.primitives, std::move(primitive));
}

int GeometryBuilder::add(Form form, const Setting& at) {
  const int primitive = add_primitive(std::move(form), at, geometry_.objects++);
  const Form& own = geometry_.primitive(primitive).form;
  if (const auto* plane = std::get_if<PlaneForm>(&own)) put(*plane, primitive, at);
  else if (const auto* sphere = std::get_if<Sphere>(&own)) put(*sphere, primitive, at);
  else put({Item::primitive, primitive}, bounds_of(at.place, bounds_of(own)), at.space);
  return primitive;
}

int GeometryBuilder::add(SharedMesh mesh, const Setting& at) {
  Aabb box;
  for (std::size_t i = 0; i < mesh->positions.size(); ++i)
    box = around(box, at.place.point(mesh->positions[i]));
  // Enlarged like the boxes of its triangles.
  const double more = tolerance::mesh_box * mesh->unit *
                      (length(at.place.x) + length(at.place.y) + length(at.place.z));
  box = {box.min - Vec3d{more, more, more}, box.max + Vec3d{more, more, more}};
  const int primitive = add_primitive(Sphere{}, at, geometry_.objects++);
  geometry_.degenerate += mesh->degenerate;
  geometry_.primitives.back().colored = !mesh->colors.empty();
  geometry_.primitives.back().mesh = pushed(geometry_.meshes, std::move(mesh));
  put({Item::mesh, primitive}, box, at.space);
  return primitive;
}

void GeometryBuilder::add_numbered(const std::vector<int>& shadings) {
  Primitive primitive = geometry_.primitives.back();
  geometry_.primitives.back().numbers = static_cast<int>(shadings.size());
  primitive.numbers = -1;
  for (const int shading : shadings) {
    primitive.shading = shading;
    geometry_.primitives.push_back(primitive);
  }
}

void GeometryBuilder::add(Solid solid, const Aabb& box, int space) {
  for (const Solid::Step& step : solid.steps)
    solid.work += step.primitive >= 0 ? geometry_.primitive(step.primitive).work : 1;
  put({Item::solid, pushed(geometry_.solids, std::move(solid))}, box, space);
}

// A plane is a flat as well under every transform.
void GeometryBuilder::put(const PlaneForm& plane, int primitive, const Setting& at) {
  const Vec3d normal = unit(geometry_.primitive(primitive).to_object.row(plane.frame.n));
  const PlaneForm flat{at.place.point(plane.point), onb_around(normal)};
  const int number = pushed(geometry_.flats, Flat{flat, primitive});
  geometry_.primitives.back().flat = number;
  put({Item::flat, number}, bounds(flat), at.space);
}

// A sphere that its transform leaves round is a ball as well.
void GeometryBuilder::put(const Sphere& sphere, int primitive, const Setting& at) {
  const auto scale = similarity(at.place);
  if (!scale)
    return put({Item::primitive, primitive}, bounds_of(at.place, bounds(sphere)), at.space);
  const Sphere round{at.place.point(sphere.center), sphere.radius * *scale};
  geometry_.primitives.back().ball = static_cast<int>(geometry_.balls.size());
  put(Ball{round, primitive}, at.space);
}

// ---- grids ----------------------------------------------------------------------------------

int GeometryBuilder::begin_grid(const Repeat& repeat, const Aabb& box, const Setting& at) {
  const int inside = pushed(geometry_.spaces, Space{});
  const float slack = InstanceGrid::slack_of(repeat.swept(box));
  const int grid = pushed(geometry_.grids,
                          InstanceGrid{at.place.inverse(), repeat, box, inside, at.space, slack});
  geometry_.spaces.back().grid = grid;
  return grid;
}

void GeometryBuilder::end_grid(int number, const Setting& at) {
  const InstanceGrid& grid = geometry_.grids[static_cast<std::size_t>(number)];
  const Space& inside = geometry_.space(grid.inside);
  const std::int64_t copies = grid.repeat.copies();
  const auto balls = static_cast<std::int64_t>(inside.balls.balls.size());
  const auto scale = similarity(at.place);
  if (at.space == 0 && scale && inside.items.empty() && takes(balls * copies))
    return put_balls(number, at.place, *scale);
  if (grid.box.bounded() && takes(copies)) return put_instances(number, at.place, at.space);
  put({Item::grid, number}, bounds_of(at.place, grid.repeat.swept(grid.box)), at.space);
}

// Whether so many copies are entered in a tree one by one, where they are found faster than through
// their grid. All of them together stay few, because a short text may have many such grids.
bool GeometryBuilder::takes(std::int64_t copies) {
  constexpr std::int64_t most = 8192, most_together = 65536;
  if (copies > most || copies_ + copies > most_together) return false;
  copies_ += copies;
  return true;
}

void GeometryBuilder::put_instances(int number, const Affine& place, int space) {
  const InstanceGrid& grid = geometry_.grids[static_cast<std::size_t>(number)];
  for (int instance = 0; instance < grid.repeat.copies(); ++instance) {
    const Vec3d offset = grid.offset(instance);
    const Aabb box{grid.box.min + offset, grid.box.max + offset};
    put({Item::instance, number, instance}, bounds_of(place, box), space);
  }
}

void GeometryBuilder::put_balls(int grid_number, const Affine& place, double scale) {
  const InstanceGrid& grid = geometry_.grids[static_cast<std::size_t>(grid_number)];
  for (const std::uint32_t number : geometry_.space(grid.inside).balls.balls) {
    const Ball one = geometry_.balls[number];
    for (int instance = 0; instance < grid.repeat.copies(); ++instance) {
      const Vec3d center = place.point(one.sphere.center + grid.offset(instance));
      const Sphere round{center, one.sphere.radius * scale};
      put(Ball{round, one.primitive, grid_number, instance}, 0);
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
// Up to so many are tried one after another, because a tree would cost as much as it saves.
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
