// Scene -> World: places are multiplied out, materials handed down, indices built.
#include <algorithm>
#include <cmath>

#include "core/accel/world.h"

namespace tia {
namespace {

constexpr std::size_t few = 16;

Vec3d rgb(const Color& c) { return {c.r, c.g, c.b}; }

bool emits(const Vec3d& light) { return light.x > 0 || light.y > 0 || light.z > 0; }

Matte matte_of(const Material& material) {
  const auto& finish = std::get<Finish>(material.kind);
  return {rgb(finish.color) * finish.diffuse, rgb(finish.emission)};
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

/// What an object takes from its ancestors.
struct Inherited {
  Affine place{};  ///< from the object's parent's space to the space of the world
  int matte = 0;
  int space = 0;
};

class Compiler {
 public:
  explicit Compiler(const Scene& scene) : scene_(scene) {
    world_.background = rgb(scene.background);
    world_.spaces.emplace_back();
    world_.mattes.push_back(tia::matte_of(Material{}));
    for (const auto& [name, material] : scene.materials) {
      named_.emplace(name, static_cast<int>(world_.mattes.size()));
      world_.mattes.push_back(tia::matte_of(material));
    }
  }

  World compile() {
    for (const Object& object : scene_.objects) add(object, {});
    for (const Light& light : scene_.lights) add(light);
    if (scene_.key_light) add(*scene_.key_light);
    for (Space& space : world_.spaces) index(space);
    world_.few_balls = world_.balls.size() == world_.parts.size() && world_.copies.empty() &&
                       world_.balls.size() <= few;
    for (const MeshIndex& mesh : world_.meshes) world_.degenerate += mesh.degenerate;
    return std::move(world_);
  }

 private:
  static constexpr auto pushed = [](auto& list, auto&& value) {
    list.push_back(std::forward<decltype(value)>(value));
    return static_cast<int>(list.size()) - 1;
  };

  int matte_index(const Object& object, int inherited) {
    if (!object.material) return inherited;
    if (const auto* name = std::get_if<std::string>(&*object.material)) return named_.at(*name);
    return pushed(world_.mattes, tia::matte_of(std::get<Material>(*object.material)));
  }
  Inherited below(const Object& object, const Inherited& above) {
    return {above.place * object.transform.affine(), matte_index(object, above.matte), above.space};
  }

  void add(const Object& object, const Inherited& above) {
    const Inherited own = below(object, above);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>) add_surface(prepare(kind), own);
          else add_kind(kind, own);
        },
        object.shape);
  }

  // ---- surfaces -------------------------------------------------------------------------------

  template <class F>
  int add_part(const F& form, const Inherited& own, int object) {
    Part part;
    part.form = form;
    part.to_object = own.place.inverse();
    const Aabb box = bounds(form);
    if (box.bounded()) part.middle = box.center();
    if constexpr (requires { work_of(form); }) part.work = work_of(form);
    part.matte = own.matte;
    part.object = object;
    part.space = own.space;
    return pushed(world_.parts, part);
  }
  template <class F>
  void add_surface(const F& form, const Inherited& own) {
    const int part = add_part(form, own, world_.objects++);
    put({Item::part, part}, bounds_of(own.place, bounds(form)), own.space);
  }
  // A sphere that stays round is a ball, too.
  void add_surface(const Sphere& sphere, const Inherited& own) {
    const int part = add_part(sphere, own, world_.objects++);
    const Vec3d center = own.place.point(sphere.center);
    if (const auto scale = similarity(own.place)) {
      const Sphere round{center, sphere.radius * *scale};
      const int ball = pushed(world_.balls, Ball{round, part});
      world_.parts.back().ball = ball;
      put({Item::ball, ball}, bounds(round), own.space);
    } else {
      put({Item::part, part}, bounds_of(own.place, bounds(sphere)), own.space);
    }
    const Constant emission = world_.matte_of(part).emission;
    if (emits(emission.exact)) add_lamps(center, emission, part);
  }
  // One lamp for each copy of a luminous ball.
  void add_lamps(const Vec3d& center, const Constant& color, int part) {
    std::int64_t copies = 1;
    for (int space = world_.part(part).space; world_.space(space).copies >= 0;) {
      const Copies& above = world_.copies[static_cast<std::size_t>(world_.space(space).copies)];
      copies *= above.repeat.copies();
      space = above.outside;
    }
    for (std::int64_t copy = 0; copy < copies; ++copy) {
      const Vec3d place = world_.to_space(world_.part(part).space, copy).inverse().point(center);
      world_.lamps.push_back({place, color, part, static_cast<int>(copy)});
    }
  }

  void add_kind(const Mesh& mesh, const Inherited& own) {
    MeshIndex index(mesh);
    Aabb box;
    for (const Vec3d& p : index.positions) box = around(box, own.place.point(p));
    const int part = add_part(Sphere{}, own, world_.objects++);
    world_.parts.back().mesh = pushed(world_.meshes, std::move(index));
    put({Item::mesh, part}, box, own.space);
  }

  // ---- composites -----------------------------------------------------------------------------

  void add_kind(const Group& group, const Inherited& own) {
    if (!group.repeat) {
      for (const Object& child : group.children) add(child, own);
      return;
    }
    const int inside = pushed(world_.spaces, Space{});
    Copies copies{own.place.inverse(), *group.repeat, {}, inside, own.space};
    for (const Object& child : group.children) copies.box = around(copies.box, bounds_of(child));
    const Aabb all = bounds_of(own.place, group.repeat->swept(copies.box));
    const int number = pushed(world_.copies, copies);
    world_.spaces.back().copies = number;
    for (const Object& child : group.children) add(child, {Affine{}, own.matte, inside});
    put({Item::copies, number}, all, own.space);
  }

  void add_kind(const Csg& csg, const Inherited& own) {
    Solid solid;
    const int object = world_.objects++;
    add_operands(csg.children, csg.operation, own, object, solid);
    Object whole;
    whole.shape = csg;
    for (const Solid::Step& step : solid.steps)
      solid.work += step.part >= 0 ? world_.part(step.part).work : 1;
    const int number = pushed(world_.solids, std::move(solid));
    put({Item::solid, number}, bounds_of(own.place, bounds_of(whole)), own.space);
  }
  void add_operands(const std::vector<Object>& children, Operation operation,
                    const Inherited& above, int object, Solid& solid) {
    for (std::size_t i = 0; i < children.size(); ++i) {
      add_operand(children[i], below(children[i], above), object, solid);
      if (i > 0) solid.steps.push_back({-1, operation});
    }
  }
  void add_operand(const Object& child, const Inherited& own, int object, Solid& solid) {
    if (const auto* csg = std::get_if<Csg>(&child.shape))
      return add_operands(csg->children, csg->operation, own, object, solid);
    if (const auto* children = children_of(child))
      return add_operands(*children, Operation::union_, own, object, solid);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>)
            solid.steps.push_back({add_part(prepare(kind), own, object), {}});
        },
        child.shape);
  }

  // ---- lights ---------------------------------------------------------------------------------

  void add(const Light& light) {
    if (!light.position()) return;  // a key light that no key has lit yet
    const Vec3d color = rgb(light.color) * light.intensity;
    if (const auto* ball = std::get_if<SphereLight>(&light.kind)) {
      const int matte = pushed(world_.mattes, Matte{{}, color});
      add_surface(Sphere{*ball->position, ball->radius}, {Affine{}, matte, 0});
    } else if (emits(color)) {
      world_.lamps.push_back({*light.position(), color});
    }
  }

  // ---- the index ------------------------------------------------------------------------------

  void put(Item item, const Aabb& box, int space) {
    if (box.empty()) return;
    Space& in = world_.space(space);
    in.items.push_back(item);
    boxes_[space].push_back(box);
  }
  void index(Space& space) {
    const int number = static_cast<int>(&space - world_.spaces.data());
    std::vector<Aabb> bounded;
    std::vector<std::uint32_t> which;
    const std::vector<Aabb>& boxes = boxes_[number];
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
    space.bvh = build_bvh(bounded);
    for (std::uint32_t& each : space.bvh.order) each = which[each];
  }

  const Scene& scene_;
  World world_;
  std::map<std::string, int> named_;
  std::map<int, std::vector<Aabb>> boxes_;  // one an item, space by space
};

}  // namespace

World compile(const Scene& scene) { return Compiler(scene).compile(); }

}  // namespace tia
