// Scene -> World: places are multiplied out, materials handed down, indices built.
#include <algorithm>
#include <cmath>

#include "core/accel/world.h"

namespace tia {
namespace {

constexpr std::size_t few = 16;

Vec3d rgb(const Color& c) { return {c.r, c.g, c.b}; }

// A point as seen from anywhere, whose light does not fade.
bool is_plain_point(const Lamp& lamp) {
  const bool point =
      std::holds_alternative<PointForm>(lamp.form) || std::holds_alternative<SphereForm>(lamp.form);
  return point && lamp.fade_distance == 0 && lamp.places == nullptr;
}

bool emits(const Vec3d& light) { return light.x > 0 || light.y > 0 || light.z > 0; }

// Whether it scatters light and does nothing else.
bool is_plain(const Matter& matter) {
  return !emits(matter.ambient.exact) && matter.brilliance == 1 && matter.specular == 0 &&
         matter.reflection == 0 && matter.transmission == 0 && matter.texture < 0;
}

Matter matter_of(const Finish& finish, const Vec3d& ambient_light) {
  const Vec3d color = finish.texture ? Vec3d{1, 1, 1} : rgb(finish.color);
  Matter matter;
  matter.albedo = color * finish.diffuse;
  matter.ambient = color * ambient_light * finish.ambient;
  matter.emission = rgb(finish.emission);
  matter.absorption = rgb(finish.absorption);
  matter.brilliance = finish.brilliance;
  matter.specular = finish.specular;
  matter.exponent = 1 / finish.roughness;
  matter.reflection = finish.reflection;
  matter.transmission = finish.transmission;
  matter.ior = finish.ior;
  matter.fresnel = finish.fresnel;
  return matter;
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
  int matter = 0;
  int space = 0;
  bool inverted = false;  ///< whether it is cut out of a solid
};

class Compiler {
 public:
  explicit Compiler(const Scene& scene) : scene_(scene) {
    world_.background = rgb(scene.background);
    world_.transparent_shadows = scene.options.transparent_shadows;
    world_.spaces.emplace_back();
    world_.matters.push_back(matter_of(Material{}));
    for (const auto& [name, material] : scene.materials) {
      named_.emplace(name, static_cast<int>(world_.matters.size()));
      world_.matters.push_back(matter_of(material));
    }
  }

  World compile() {
    for (const Object& object : scene_.objects) add(object, {});
    add_lights();
    for (Space& space : world_.spaces) index(space);
    world_.few_balls = world_.balls.size() == world_.parts.size() && world_.copies.empty() &&
                       world_.balls.size() <= few &&
                       std::ranges::all_of(world_.matters, is_plain) &&
                       std::ranges::all_of(world_.lamps, is_plain_point);
    for (const MeshIndex& mesh : world_.meshes) world_.degenerate += mesh.degenerate;
    return std::move(world_);
  }

 private:
  static constexpr auto pushed = [](auto& list, auto&& value) {
    list.push_back(std::forward<decltype(value)>(value));
    return static_cast<int>(list.size()) - 1;
  };

  Matter matter_of(const Material& material) {
    const auto& finish = std::get<Finish>(material.kind);
    Matter matter = tia::matter_of(finish, rgb(scene_.ambient_light));
    if (finish.texture) matter.texture = pushed(world_.textures, prepare(*finish.texture));
    return matter;
  }
  int matter_index(const Object& object, int inherited) {
    if (!object.material) return inherited;
    if (const auto* name = std::get_if<std::string>(&*object.material)) return named_.at(*name);
    return pushed(world_.matters, matter_of(std::get<Material>(*object.material)));
  }
  Inherited below(const Object& object, const Inherited& above) {
    return {above.place * object.transform.affine(), matter_index(object, above.matter),
            above.space, above.inverted};
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
    part.matter = own.matter;
    part.object = object;
    part.space = own.space;
    part.inverted = own.inverted;
    return pushed(world_.parts, part);
  }
  // A plane is a flat, too, wherever it is.
  void add_surface(const PlaneForm& plane, const Inherited& own) {
    const int part = add_part(plane, own, world_.objects++);
    const Vec3d normal = unit(world_.parts.back().to_object.row(plane.frame.n));
    const PlaneForm flat{own.place.point(plane.point), onb_around(normal)};
    const int number = pushed(world_.flats, Flat{flat, part});
    world_.parts.back().flat = number;
    put({Item::flat, number}, bounds(flat), own.space);
  }
  template <class F>
  void add_surface(const F& form, const Inherited& own) {
    const int part = add_part(form, own, world_.objects++);
    put({Item::part, part}, bounds_of(own.place, bounds(form)), own.space);
  }
  // A luminous one is a light.
  void add_surface(const Sphere& sphere, const Inherited& own) {
    const int part = add_ball(sphere, own);
    const Constant emission = world_.matter_of(part).emission;
    if (emits(emission.exact)) add_lamps(own.place.point(sphere.center), emission, part);
  }
  // A sphere that stays round is a ball, too. Returns: its part.
  int add_ball(const Sphere& sphere, const Inherited& own) {
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
    return part;
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
      Lamp lamp{PointForm{place}, place, color};
      lamp.part = part;
      lamp.copy = static_cast<int>(copy);
      world_.lamps.push_back(lamp);
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
    Copies copies{own.place.inverse(), *group.repeat, {}, inside, own.space, 0};
    for (const Object& child : group.children) copies.box = around(copies.box, bounds_of(child));
    const Aabb swept = group.repeat->swept(copies.box);
    copies.slack = Copies::slack_of(swept);
    const Aabb all = bounds_of(own.place, swept);
    const int number = pushed(world_.copies, copies);
    world_.spaces.back().copies = number;
    for (const Object& child : group.children) add(child, {Affine{}, own.matter, inside, false});
    const auto scale = similarity(own.place);
    if (own.space == 0 && scale && is_small(number)) put_balls(number, own.place, *scale);
    else put({Item::copies, number}, all, own.space);
  }
  // A small grid of balls is quicker found in the index of the world than by itself.
  bool is_small(int number) {
    constexpr std::int64_t most = 8192;
    const Copies& grid = world_.copies[static_cast<std::size_t>(number)];
    const std::vector<Item>& items = world_.space(grid.inside).items;
    return static_cast<std::int64_t>(items.size()) * grid.repeat.copies() <= most &&
           std::ranges::all_of(items, [](const Item& item) { return item.kind == Item::ball; });
  }
  void put_balls(int number, const Affine& place, double scale) {
    const Copies& grid = world_.copies[static_cast<std::size_t>(number)];
    for (const Item& item : world_.space(grid.inside).items) {
      const Ball one = world_.balls[static_cast<std::size_t>(item.index)];
      for (int copy = 0; copy < grid.repeat.copies(); ++copy) {
        const Vec3d center = place.point(one.sphere.center + grid.offset(copy));
        const Sphere round{center, one.sphere.radius * scale};
        put({Item::ball, pushed(world_.balls, Ball{round, one.part, number, copy})}, bounds(round),
            0);
      }
    }
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
      Inherited own = below(children[i], above);
      if (i > 0 && operation == Operation::difference) own.inverted = !own.inverted;
      add_operand(children[i], own, object, solid);
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

  void add_lights() {
    Vec3d skies{};
    bool sky = false;
    const auto add = [&](const Light& light, const std::string& name) {
      if (light.awaited() != nullptr) return;  // a key light that no key has lit yet
      const Vec3d color = rgb(light.color) * light.intensity;
      if (std::holds_alternative<SkyLight>(light.kind)) {
        skies = skies + color;
        sky = true;
      }
      std::visit([&](const auto& kind) { add_light(kind, light, color, name); }, light.kind);
    };
    for (std::size_t i = 0; i < scene_.lights.size(); ++i)
      add(scene_.lights[i], "/lights/" + std::to_string(i));
    if (scene_.key_light) add(*scene_.key_light, "/key_light");
    if (sky) world_.background = skies;
  }
  template <class Kind>
  void add_light(const Kind& kind, const Light& light, const Vec3d& color,
                 const std::string& name) {
    if constexpr (MovableLight<Kind>) {
      Lamp lamp{prepare(kind), light.place().value_or(Vec3d{}), color};
      if (light.fade_distance) lamp.fade_distance = *light.fade_distance;
      lamp.fade_power = light.fade_power;
      lamp.name = name;
      if constexpr (requires { kind.samples; }) {
        lamp.places = places(kind.samples);
        lamp.part = static_cast<int>(world_.parts.size());
        Matter glow;
        glow.emission = color;
        add_luminous(kind, {Affine{}, pushed(world_.matters, glow), 0, false});
      }
      if (emits(color)) world_.lamps.push_back(lamp);
    }
  }
  std::shared_ptr<const Strata> places(int samples) {
    if (samples == 1) return nullptr;
    std::shared_ptr<const Strata>& shared = strata_[samples];
    if (!shared) shared = std::make_shared<const Strata>(samples);
    return shared;
  }
  void add_luminous(const SphereLight& light, const Inherited& own) {
    add_ball(Sphere{*light.position, light.radius}, own);
  }
  void add_luminous(const QuadLight& light, const Inherited& own) {
    Mesh mesh;
    const Vec3d corners[] = {*light.corner, *light.corner + light.u,
                             *light.corner + light.u + light.v, *light.corner + light.v};
    for (const Vec3d& p : corners)
      mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    mesh.indices.values = {0, 1, 2, 0, 2, 3};
    add_kind(mesh, own);
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
  std::map<int, std::shared_ptr<const Strata>> strata_;
  std::map<int, std::vector<Aabb>> boxes_;  // one an item, space by space
};

}  // namespace

World compile(const Scene& scene) { return Compiler(scene).compile(); }

}  // namespace tia
