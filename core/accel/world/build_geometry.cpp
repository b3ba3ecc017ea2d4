// A scene's objects -> Geometry. Transforms are multiplied out, and materials are inherited.
#include "core/accel/world/geometry_builder.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

class Compiler {
 public:
  Compiler(const Scene& scene, const Workers& workers, const MeshSource& mesh)
      : scene_(scene), workers_(workers), mesh_(mesh) {
    geometry_.shadings.push_back(shading_of(Material{}));
    for (const auto& [name, material] : scene.materials) {
      named_.emplace(name, static_cast<int>(geometry_.shadings.size()));
      geometry_.shadings.push_back(shading_of(material));
    }
  }

  PlacedObjects place() {
    for (const Object& object : scene_.objects) add(object, {});
    return {std::move(geometry_), builder_.boxes()};
  }

  Geometry compile() {
    for (const Object& object : scene_.objects) add(object, {});
    list_unasked();
    builder_.settle();
    for (WorldLight& light : geometry_.lights)
      light = at_center(light, light.middle.exact - geometry_.origin);
    for (PathLight& light : geometry_.areas) move_by(light, -geometry_.origin);
    builder_.finish();
    return std::move(geometry_);
  }

 private:
  ShadingParameters shading_of(const Material& material) {
    ShadingParameters shading = tia::shading_of(material, rgb_of(scene_.ambient_light));
    if (const Texture* texture = texture_of(material))
      shading.texture = pushed(geometry_.textures, prepare(*texture));
    if (auto form = textured_form_of(material, rgb_of(scene_.ambient_light)))
      shading.form = pushed(geometry_.forms, std::move(*form));
    geometry_.see_through = geometry_.see_through || shading.see_through;
    geometry_.passable = geometry_.see_through || geometry_.passable || shading.one_sided;
    return shading;
  }
  int shading_index(const MaterialRef& material) {
    if (const auto* name = std::get_if<std::string>(&material)) return named_.at(*name);
    return pushed(geometry_.shadings, shading_of(*std::get<Boxed<Material>>(material)));
  }
  Setting below(const Object& object, const Setting& above) {
    return {above.place * object.transform.affine(),
            object.material ? shading_index(*object.material) : above.shading, above.space,
            above.inverted, above.culls};
  }

  void add(const Object& object, const Setting& above) {
    workers_.end_if_asked();
    const Setting own = below(object, above);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>) add_surface(prepare(kind), own);
          else add_kind(kind, own);
        },
        object.shape);
    if (std::holds_alternative<Mesh>(object.shape) || is_surface(object.shape))
      add_areas(object.shape, own.place, static_cast<int>(geometry_.primitives.size()) - 1);
    add_numbered(object);
  }
  // Domain: the object's primitive has just been added.
  void add_numbered(const Object& object) {
    if (numbered_materials(object).empty()) return;
    std::vector<int> shadings;
    for (const MaterialRef& material : numbered_materials(object))
      shadings.push_back(shading_index(material));
    builder_.add_numbered(shadings);
  }

  void list_unasked() {
    std::vector<bool> asked(geometry_.primitives.size());
    for (const PathLight& area : geometry_.areas)
      asked[static_cast<std::size_t>(area.primitive)] = true;
    auto& [count, first] = geometry_.unasked;
    int last = -1;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const int object = geometry_.primitives[i].object;
      const auto shading = static_cast<std::size_t>(geometry_.primitives[i].shading);
      if (asked[i] || object == last || !emits(geometry_.shadings[shading].emission.exact))
        continue;
      last = object, ++count;
      if (first.size() < Unasked::most_told) first.push_back(object);
    }
  }

  // ---- surfaces -------------------------------------------------------------------------------

  // A luminous surface that has a light_center is a light at that point as well.
  template <IsForm F>
  void add_surface(const F& form, const Setting& own) {
    const int primitive = builder_.add(form, own);
    if constexpr (LightsFromCenter<F>) {
      const ShadingParameters& shading = geometry_.shading_of(primitive);
      const Constant emission = shading.emission.exact * shading.opacity;
      if (emits(emission.exact))
        add_lights(own.place.point(light_center(form)), emission, primitive);
    }
  }
  std::int64_t instances_of(int primitive) const {
    std::int64_t instances = 1;
    for (int space = geometry_.primitive(primitive).space; geometry_.space(space).grid >= 0;) {
      const InstanceGrid& above =
          geometry_.grids[static_cast<std::size_t>(geometry_.space(space).grid)];
      instances *= above.repeat.copies();
      space = above.outside;
    }
    return instances;
  }
  static bool is_surface(const Shape& shape) {
    return std::visit([]<class Kind>(const Kind&) { return IsSurface<Kind>; }, shape);
  }
  bool emits_by_point(const ShadingParameters& shading) const {
    if (shading.see_through) return true;
    if (shading.form < 0) return false;
    const auto& maps = geometry_.forms[static_cast<std::size_t>(shading.form)].maps;
    return maps && emission_varies(*maps);
  }
  // What a luminous shape can be asked for by its area, for each instance. One that rays may pass
  // sends out less from some points than from others, and is left to chance.
  void add_areas(const Shape& shape, const Affine& place, int primitive) {
    const ShadingParameters& shading = geometry_.shading_of(primitive);
    const Constant emission = shading.emission;
    if (!emits(emission.exact) || emits_by_point(shading)) return;
    const std::int64_t instances = instances_of(primitive);
    if (instances > static_cast<std::int64_t>(most_areas)) return;
    for (std::int64_t instance = 0; instance < instances; ++instance) {
      const int space = geometry_.primitive(primitive).space;
      PathLight light{PointForm{}, emission, primitive, static_cast<int>(instance)};
      tia::add_areas(shape, geometry_.to_space(space, instance).inverse() * place, light,
                     geometry_.areas);
    }
  }
  // Adds one light for each instance of the surface.
  void add_lights(const Vec3d& center, const Constant& color, int primitive) {
    const std::int64_t instances = instances_of(primitive);
    for (std::int64_t instance = 0; instance < instances; ++instance) {
      const Vec3d place = geometry_.to_space(geometry_.primitive(primitive).space, instance)
                              .inverse()
                              .point(center);
      WorldLight light{{}, {}, color};
      light.primitive = primitive;
      light.instance = static_cast<int>(instance);
      geometry_.lights.push_back(at_center(light, place));
    }
  }
  static WorldLight at_center(WorldLight light, const Vec3d& place) {
    light.form = PointForm{place};
    light.middle = place;
    return light;
  }

  void add_kind(const Mesh& mesh, const Setting& own) {
    SharedMesh& index = indices_[lists_of(mesh)];
    if (!index) index = mesh_(mesh, workers_);
    builder_.add(index, own);
  }

  // ---- composites -----------------------------------------------------------------------------

  void add_kind(const Group& group, const Setting& own) {
    if (!group.repeat) {
      for (const Object& child : group.children) add(child, own);
      return;
    }
    Aabb box;
    for (const Object& child : group.children) box = around(box, bounds_.of(child));
    const int grid = builder_.begin_grid(*group.repeat, box, own);
    const int inside = geometry_.grids[static_cast<std::size_t>(grid)].inside;
    for (const Object& child : group.children)
      add(child, {Affine{}, own.shading, inside, false, own.culls});
    builder_.end_grid(grid, own);
  }

  void add_kind(const Walls& walls, const Setting& own) {
    for (const Object& child : children_in(walls)) add(child, own);
  }

  void add_kind(const PlacedModel& model, const Setting& own) {
    Setting inside = own;
    inside.culls = model.culling;
    for (const Object& child : children_in(model)) add(child, inside);
  }

  void add_kind(const Csg& csg, const Setting& own) {
    Solid solid;
    const int object = geometry_.objects++;
    add_operands(csg.children, csg.operation, own, object, solid);
    builder_.add(std::move(solid), bounds_of(own.place, bounds_.of(csg)), own.space);
  }
  using Operands = std::span<const Object>;
  void add_operands(Operands children, Operation operation, const Setting& above, int object,
                    Solid& solid) {
    if (operation != Operation::difference)
      return add_balanced(children, operation, above, object, solid);
    // The first operand less the union of all others.
    add_operand(children.front(), below(children.front(), above), object, solid);
    if (children.size() == 1) return;
    Setting taken_away = above;
    taken_away.inverted = !taken_away.inverted;
    add_balanced(children.subspan(1), Operation::union_, taken_away, object, solid);
    solid.steps.push_back({-1, operation});
  }
  // Merges both halves first, then these with each other. Merged one after another, each operand
  // would be merged with the long list of spans of all before it.
  void add_balanced(Operands children, Operation operation, const Setting& above, int object,
                    Solid& solid) {
    if (children.size() == 1)
      return add_operand(children.front(), below(children.front(), above), object, solid);
    const std::size_t half = children.size() / 2;
    add_balanced(children.first(half), operation, above, object, solid);
    add_balanced(children.subspan(half), operation, above, object, solid);
    solid.steps.push_back({-1, operation});
  }
  void add_operand(const Object& child, const Setting& own, int object, Solid& solid) {
    workers_.end_if_asked();
    if (const auto* csg = std::get_if<Csg>(&child.shape))
      return add_operands(csg->children, csg->operation, own, object, solid);
    if (const auto* children = children_of(child))
      return add_operands(*children, Operation::union_, own, object, solid);
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (IsSurface<Kind>)
            solid.steps.push_back({builder_.add_primitive(prepare(kind), own, object), {}});
        },
        child.shape);
    add_numbered(child);
  }

  const Scene& scene_;
  const Workers& workers_;
  const MeshSource& mesh_;
  ObjectBounds bounds_;
  Geometry geometry_;
  GeometryBuilder builder_{geometry_, workers_};
  std::map<std::string, int> named_;
  std::map<MeshLists, SharedMesh> indices_;  // of meshes that share their lists one
};

}  // namespace

Geometry geometry_of(const Scene& scene, const Workers& workers, const MeshSource& mesh) {
  return Compiler(scene, workers, mesh).compile();
}

PlacedObjects placed_objects(const Scene& scene, const Workers& workers) {
  return Compiler(scene, workers, indexed).place();
}

}  // namespace tia
