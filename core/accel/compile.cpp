// Scene -> World: places are multiplied out, materials handed down, lights lit.
#include "core/accel/world_builder.h"
#include "core/input/stopped.h"

namespace tia {
namespace {

Vec3d rgb(const Color& c) { return {c.r, c.g, c.b}; }

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

class Compiler {
 public:
  Compiler(const Scene& scene, const std::stop_token& stop) : scene_(scene), stop_(stop) {
    world_.background = rgb(scene.background);
    world_.transparent_shadows = scene.options.transparent_shadows;
    world_.matters.push_back(matter_of(Material{}));
    for (const auto& [name, material] : scene.materials) {
      named_.emplace(name, static_cast<int>(world_.matters.size()));
      world_.matters.push_back(matter_of(material));
    }
  }

  World compile() {
    for (const Object& object : scene_.objects) add(object, {});
    add_lights();
    builder_.finish();
    return std::move(world_);
  }

 private:
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
  Setting below(const Object& object, const Setting& above) {
    return {above.place * object.transform.affine(), matter_index(object, above.matter),
            above.space, above.inverted};
  }

  void add(const Object& object, const Setting& above) {
    end_if_asked(stop_);
    const Setting own = below(object, above);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>) add_surface(prepare(kind), own);
          else add_kind(kind, own);
        },
        object.shape);
  }

  // ---- surfaces -------------------------------------------------------------------------------

  template <class F>
  void add_surface(const F& form, const Setting& own) {
    builder_.add(form, own);
  }
  // A luminous one is a light.
  void add_surface(const Sphere& sphere, const Setting& own) {
    const int part = builder_.add(sphere, own);
    const Constant emission = world_.matter_of(part).emission;
    if (emits(emission.exact)) add_lamps(own.place.point(sphere.center), emission, part);
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

  void add_kind(const Mesh& mesh, const Setting& own) { builder_.add(mesh, own); }

  // ---- composites -----------------------------------------------------------------------------

  void add_kind(const Group& group, const Setting& own) {
    if (!group.repeat) {
      for (const Object& child : group.children) add(child, own);
      return;
    }
    Aabb box;
    for (const Object& child : group.children) box = around(box, bounds_of(child));
    const int grid = builder_.begin_grid(*group.repeat, box, own);
    const int inside = world_.copies[static_cast<std::size_t>(grid)].inside;
    for (const Object& child : group.children) add(child, {Affine{}, own.matter, inside, false});
    builder_.end_grid(grid, own);
  }

  void add_kind(const Csg& csg, const Setting& own) {
    Solid solid;
    const int object = world_.objects++;
    add_operands(csg.children, csg.operation, own, object, solid);
    Object whole;
    whole.shape = csg;
    builder_.add(std::move(solid), bounds_of(own.place, bounds_of(whole)), own.space);
  }
  void add_operands(const std::vector<Object>& children, Operation operation, const Setting& above,
                    int object, Solid& solid) {
    for (std::size_t i = 0; i < children.size(); ++i) {
      Setting own = below(children[i], above);
      if (i > 0 && operation == Operation::difference) own.inverted = !own.inverted;
      add_operand(children[i], own, object, solid);
      if (i > 0) solid.steps.push_back({-1, operation});
    }
  }
  void add_operand(const Object& child, const Setting& own, int object, Solid& solid) {
    if (const auto* csg = std::get_if<Csg>(&child.shape))
      return add_operands(csg->children, csg->operation, own, object, solid);
    if (const auto* children = children_of(child))
      return add_operands(*children, Operation::union_, own, object, solid);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>)
            solid.steps.push_back({builder_.add_part(prepare(kind), own, object), {}});
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
  void add_luminous(const SphereLight& light, const Setting& own) {
    builder_.add(Sphere{*light.position, light.radius}, own);
  }
  void add_luminous(const QuadLight& light, const Setting& own) {
    Mesh mesh;
    const Vec3d corners[] = {*light.corner, *light.corner + light.u,
                             *light.corner + light.u + light.v, *light.corner + light.v};
    for (const Vec3d& p : corners)
      mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    mesh.indices.values = {0, 1, 2, 0, 2, 3};
    builder_.add(mesh, own);
  }

  const Scene& scene_;
  const std::stop_token& stop_;
  World world_;
  WorldBuilder builder_{world_, stop_};
  std::map<std::string, int> named_;
  std::map<int, std::shared_ptr<const Strata>> strata_;
};

}  // namespace

World compile(const Scene& scene, const std::stop_token& stop) {
  return Compiler(scene, stop).compile();
}

}  // namespace tia
