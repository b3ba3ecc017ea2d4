// An explanation as JSON.
#include "core/render/explain.h"
#include "core/render/explained_ray.h"

namespace tia {
namespace {

Value::Object ray_value(const Vec3d& origin, const Vec3d& direction) {
  return {{"origin", write_value(origin)}, {"direction", write_value(direction)}};
}

class Writer {
 public:
  explicit Writer(const Explanation& all) : all_(all) {}

  Value::Array hits() const {
    Value::Array hits;
    for (const Meeting& at : all_.hits) {
      const ObjectLabel& object = label_of(at.primitive);
      Value::Object hit{{"t", at.t},
                        {"object", object.name},
                        {"id", id_of(at.primitive)},
                        {"type", object.type},
                        {"point", write_value(at.point)},
                        {"normal", write_value(at.normal)},
                        {"uv", Value::Array{at.uv.u, at.uv.v}},
                        {"front", at.front}};
      add_copy(all_.world, hit, "copy", at.primitive, at.instance);
      if (at.bracket) hit.emplace_back("root", root(*at.bracket));
      hits.push_back(std::move(hit));
    }
    return hits;
  }

  Value::Array objects() const {
    Value::Array objects;
    for (const auto& [number, pointer] : all_.pointers) {
      const ObjectLabel& label = all_.labels[static_cast<std::size_t>(number)];
      objects.push_back(Value::Object{
          {"id", number + 1}, {"name", label.name}, {"pointer", pointer}, {"type", label.type}});
    }
    return objects;
  }

  Value::Array notes() const {
    Value::Array notes;
    for (const auto& [pointer, about] : all_.notes)
      notes.push_back(Value::Object{{"pointer", pointer}, {"about", about}});
    return notes;
  }

  Value::Object node(const RayNode& node) const {
    const bool hit = node.hit.t < infinity;
    Value::Array terms;
    for (const Term& each : node.terms) terms.push_back(term(each));
    Value::Object object;  // moved into, for a list of initializers would copy whole subtrees
    object.emplace_back(
        "ray", ray_value(in_scene(node.ray.origin), static_cast<Vec3d>(node.ray.direction)));
    object.emplace_back("depth", node.depth);
    object.emplace_back("winner", hit ? Value(label_of(primitive_of(node.hit)).name) : Value());
    if (hit) {
      object.emplace_back("winner_id", id_of(primitive_of(node.hit)));
      add_copy(all_.world, object, "winner_copy", primitive_of(node.hit),
               static_cast<std::int64_t>(node.hit.instance));
    }
    object.emplace_back("terms", std::move(terms));
    object.emplace_back("color", triple_value(node.color));
    if (hit) {
      object.emplace_back("t", node.hit.t);
      object.emplace_back("point", write_value(in_scene(node.point)));
      object.emplace_back("normal", triple_value(node.normal));
    }
    if (!(node.transmittance == Vec3f{1, 1, 1}))
      object.emplace_back("transmittance", triple_value(node.transmittance));
    return object;
  }

 private:
  static Value::Object root(const Bracket& bracket) {
    Value::Object root{{"bracket", Value::Array{bracket.from, bracket.to}},
                       {"how", std::string(bracket.how)}};
    if (bracket.degree > 0) root.emplace_back("degree", bracket.degree);
    return root;
  }
  // A point of the world where the scene has it.
  Vec3d in_scene(const Vec3f& p) const { return static_cast<Vec3d>(p) + all_.world.origin; }
  static int primitive_of(const Hit<float>& hit) { return static_cast<int>(hit.primitive); }
  const ObjectLabel& label_of(int primitive) const {
    return all_.labels[static_cast<std::size_t>(all_.world.primitive(primitive).object)];
  }
  // The number in the image of the integrator `object`.
  int id_of(int primitive) const { return all_.world.primitive(primitive).object + 1; }
  std::string light_name(const WorldLight& light) const {
    if (light.primitive >= 0) return label_of(light.primitive).name;
    return light.name;
  }

  Value::Object term(const Term& term) const {
    Value::Object object{
        {"name", name_of(term.name)}, {"weight", term.weight}, {"value", triple_value(term.value)}};
    if (term.light.light >= 0) add_light(term.light, object);
    if (term.node) object.emplace_back("node", node(*term.node));
    return object;
  }
  void add_light(const LightRecord& record, Value::Object& object) const {
    const WorldLight& light = all_.world.lights[static_cast<std::size_t>(record.light)];
    object.emplace_back("light", light_name(light));
    if (light.primitive >= 0) {
      object.emplace_back("light_id", id_of(light.primitive));
      add_copy(all_.world, object, "light_copy", light.primitive, light.instance);
    }
    // A directional light's is infinite, which JSON has no number for.
    object.emplace_back(
        "distance", record.middle.distance < infinity ? Value(record.middle.distance) : Value());
    object.emplace_back("direction", triple_value(record.middle.wi));
    object.emplace_back("n_dot_l", record.n_dot_l);
    object.emplace_back("visible", record.visible);
    object.emplace_back("fade", record.fade * record.middle.strength);
    if (!record.blocker) return;
    object.emplace_back("blocker", name_of_primitive(*record.blocker));
    if (*record.blocker < 0) return;
    object.emplace_back("blocker_id", id_of(*record.blocker));
    add_copy(all_.world, object, "blocker_copy", *record.blocker, record.blocker_instance);
  }
  Value name_of_primitive(int primitive) const {
    return primitive < 0 ? Value() : Value(label_of(primitive).name);
  }

  const Explanation& all_;
};

}  // namespace

Value::Object value_of(const Explanation& all) {
  const Writer writer(all);
  Value::Object answer, tree, ray = ray_value(all.ray.origin, all.ray.direction);
  if (all.tree) tree = writer.node(*all.tree);
  if (all.pixel) {
    const auto& at = *all.pixel;
    answer.emplace_back("pixel", Value::Array{at.x, at.y});
    answer.emplace_back("sample", at.sample);
    if (at.view)
      answer.emplace_back("view", Value::Object{{"number", at.view->number},
                                                {"name", at.view->name},
                                                {"pixel", Value::Array{at.view->x, at.view->y}}});
    auto& through = all.tree ? std::get<Value::Object>(tree.front().second.is) : ray;
    through.emplace_back("raster", Value::Array{at.raster.u, at.raster.v});
    through.emplace_back("ndc", Value::Array{at.ndc.u, at.ndc.v});
    through.emplace_back("screen", Value::Array{at.screen.u, at.screen.v});
  }
  answer.emplace_back("ray", std::move(ray));
  answer.emplace_back("hits", writer.hits());
  if (all.tree) answer.emplace_back("tree", std::move(tree));
  answer.emplace_back("objects", writer.objects());
  if (!all.notes.empty()) answer.emplace_back("notes", writer.notes());
  return answer;
}

}  // namespace tia
