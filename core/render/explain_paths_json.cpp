// Explanations by paths as JSON, and what that may be.
#include "core/render/explain.h"
#include "core/render/explain_paths.h"
#include "core/render/explained_ray.h"

namespace tia {
namespace {

// ---- what is told -------------------------------------------------------------------------------

/// PathWriter: writes what is told of paths.
class PathWriter {
 public:
  PathWriter(const Explanation& all, const World& world) : all_(all), world_(world) {
    name_lights();
  }

  Value::Object path(const ExplainedPath& told) const {
    Value::Array vertices;
    for (const PathVertex& each : told.path.vertices) vertices.push_back(vertex(each));
    std::size_t at = 0;
    const PathVertex* const first = told.path.vertices.data();
    for_each_light(told.path, [&](const PathVertex& by, const GatheredLight& each,
                                  const std::string& expression, int) {
      at = static_cast<std::size_t>(&by - first);
      auto& own = *vertices[at].as<Value::Object>();
      own.back().second.as<Value::Array>()->push_back(light(each, by, expression));
    });
    Value::Object path{{"sample", told.sample},
                       {"color", triple_value(told.path.color)},
                       {"end", name_of(told.path.end)},
                       {"vertices", std::move(vertices)}};
    if (told.path.clamp < 1) path.emplace_back("clamp", told.path.clamp);
    if (told.path.wave > 0) path.emplace_back("wavelength_nm", told.path.wave);
    return path;
  }

  Value::Object surface(const PathSurface& over, int count) const {
    Value::Object told;
    add_object(told, "object", over.object);
    add_share(told, over, count);
    return told;
  }
  static void add_share(Value::Object& to, const PathShare& part, int count) {
    to.emplace_back("mean", write_value(part.mean));
    to.emplace_back("share", part.share);
    to.emplace_back("paths", part.paths);
    if (count > 1) to.emplace_back("error", write_value(part.error));
  }

 private:
  // Those without a surface stand among PathLights in the scene's order, the endless ones last.
  void name_lights() {
    const auto is_endless = [](const WorldLight& light) {
      return std::visit(
          []<class Form>(const Form&) {
            return std::same_as<Form, DirectionalForm> || std::same_as<Form, SunForm>;
          },
          light.form);
    };
    for (const bool endless : {false, true})
      for (const WorldLight& light : world_.lights)
        if (!light.name.empty() && light.primitive < 0 && is_endless(light) == endless)
          bare_names_.push_back(light.name);
    std::size_t bare = 0;
    for (int i = 0; i < world_.path_lights.size(); ++i) {
      const bool is_bare = world_.path_lights[i].primitive < 0;
      names_.push_back(is_bare ? bare_names_.at(bare++) : "");
    }
    for (const WorldSky& sky : world_.skies) names_.push_back(sky.name);
  }
  Vec3d in_scene(const Vec3f& p) const { return static_cast<Vec3d>(p) + world_.origin; }

  void add_object(Value::Object& to, const std::string& as, int object) const {
    to.emplace_back(as, all_.labels[static_cast<std::size_t>(object)].name);
    to.emplace_back(as == "object" ? "id" : as + "_id", object + 1);
  }
  void add_thing(Value::Object& to, const std::string& as, int primitive, std::int64_t copy) const {
    add_object(to, as, world_.primitive(primitive).object);
    add_copy(world_, to, as == "object" ? "copy" : "light_copy", primitive, copy);
  }
  static int primitive_of(const PathVertex& at) { return static_cast<int>(at.hit.primitive); }

  // Its lights follow, last.
  Value::Object vertex(const PathVertex& at) const {
    Value::Object vertex{{"ray", Value::Object{{"origin", write_value(in_scene(at.ray.origin))},
                                               {"direction", triple_value(at.ray.direction)}}},
                         {"throughput", triple_value(at.throughput)}};
    const bool hit = at.hit.t < infinity;
    if (hit) {
      vertex.emplace_back("t", at.hit.t);
      add_thing(vertex, "object", primitive_of(at), static_cast<std::int64_t>(at.hit.instance));
      vertex.emplace_back("normal", triple_value(at.normal));
    }
    if (hit || at.event) vertex.emplace_back("point", write_value(in_scene(at.point)));
    if (at.event) {
      vertex.emplace_back("event", name_of(*at.event));
      vertex.emplace_back("weight", triple_value(at.weight));
      vertex.emplace_back("pdf", at.pdf);
      vertex.emplace_back("survival", at.survival);
    }
    vertex.emplace_back("lights", Value::Array{});
    return vertex;
  }

  Value::Object light(const GatheredLight& light, const PathVertex& by,
                      const std::string& expression) const {
    Value::Object told{
        {"asked", light.asked}, {"value", triple_value(light.value)}, {"weight", light.weight}};
    if (!(light.value == none)) told.emplace_back("expression", expression);
    add_source(told, light, by);
    if (!light.asked) return told;
    if (!(light.bsdf == none)) told.emplace_back("event", name_of(light.event));
    told.emplace_back("point", write_value(in_scene(light.from)));
    told.emplace_back("direction", triple_value(light.direction));
    told.emplace_back("distance", light.distance < infinity ? Value(light.distance) : Value());
    if (light.chance > 0) told.emplace_back("chance", light.chance);
    told.emplace_back("pdf", light.pdf);
    told.emplace_back("bsdf", triple_value(light.bsdf));
    told.emplace_back("visible", light.visible);
    return told;
  }
  void add_source(Value::Object& to, const GatheredLight& light, const PathVertex& by) const {
    if (light.light == GatheredLight::own_surface)
      return add_thing(to, "light", primitive_of(by), static_cast<std::int64_t>(by.hit.instance));
    if (light.light == GatheredLight::background)
      return static_cast<void>(to.emplace_back("light", "/background"));
    const std::string& name = names_[static_cast<std::size_t>(light.light)];
    if (!name.empty()) return static_cast<void>(to.emplace_back("light", name));
    const PathLight& own = world_.path_lights[light.light];
    add_thing(to, "light", own.primitive, own.instance);
  }

  static constexpr Vec3f none{0, 0, 0};
  const Explanation& all_;
  const World& world_;
  std::vector<std::string> bare_names_{}, names_{};  // "": that of its object
};

Value::Array groups_value(const PathExplanation& all) {
  Value::Array groups;
  for (const PathGroup& each : all.groups) {
    Value::Object group{{"expression", each.expression}};
    PathWriter::add_share(group, each, all.count);
    groups.push_back(std::move(group));
  }
  return groups;
}

// ---- what that may be ---------------------------------------------------------------------------

Value vector_schema() { return plain_schema<Vec3d>(); }
Value amount_schema(const Spec& spec = {.min = 0}) { return plain_schema<double>(spec); }
Value word_schema() { return plain_schema<std::string>(); }
Value copies_schema() { return list_schema(plain_schema<std::array<int, 3>>({.min = 0})); }

Value light_schema() {
  const char* const asked = "of what was asked for";
  return object_schema(
      {{"expression", word_schema(), "that it counts for, where it adds anything", false},
       {"asked", plain_schema<bool>(), "whether the vertex asked a light, else met it by itself"},
       {"value", vector_schema(), "linear RGB: what it adds to the path's colour"},
       {"weight", amount_schema(), "that of multiple importance sampling"},
       {"light", word_schema(), "its name, or a JSON Pointer into the scene"},
       {"light_id", count_schema(1), "which of objects it is, where it is one", false},
       {"light_copy", copies_schema(), "which copy of that, as a hit's", false},
       {"event", plain_schema<PathEvent>(), "how the vertex sends it on, if it does", false},
       {"point", vector_schema(), "where it was asked for", false},
       {"direction", vector_schema(), "towards the light", false},
       {"distance", nullable_schema(amount_schema()), "null where it is infinite", false},
       {"chance", amount_schema({.min = 0, .max = 1}), "of choosing this light; not in fog", false},
       {"pdf", nullable_schema(amount_schema()),
        "of the point, by solid angle, in fog also by distance; of a light that is a point, of "
        "choosing it",
        false},
       {"bsdf", vector_schema(), "f |n.wi|, in fog the phase function", false},
       {"visible", amount_schema({.min = 0, .max = 1}), asked, false}});
}

Value vertex_schema(Definitions& named) {
  return schema_called("path_vertex", named, [&] {
    const Value ray =
        object_schema({{"origin", vector_schema()}, {"direction", vector_schema(), "of length 1"}});
    return object_schema(
        {{"ray", ray, "that leads to it"},
         {"throughput", vector_schema(), "what light counts that comes from there"},
         {"t", amount_schema(), "how far along the ray the surface is", false},
         {"object", word_schema(), "of the surface", false},
         {"id", count_schema(1), "which of objects that is", false},
         {"copy", copies_schema(), "which copy of that, as a hit's", false},
         {"normal", vector_schema(), "for shading", false},
         {"point", vector_schema(), "on the surface or, of the event volume, before it", false},
         {"event", plain_schema<PathEvent>(), "how the path goes on, or would", false},
         {"weight", vector_schema(), "f |n.wi| / pdf of that", false},
         {"pdf", amount_schema(), "of its direction, by solid angle; 0: it has a single one",
          false},
         {"survival", amount_schema({.min = 0, .max = 1}), "what Russian roulette left it", false},
         {"lights", list_schema(light_schema()), "in the order in which they are added"}});
  });
}

Value sample_schema(Definitions& named) {
  return object_schema(
      {{"sample", count_schema()},
       {"color", vector_schema(),
        "linear RGB: the sum of all values, in their order, times clamp; the picture's sample, bit "
        "for bit"},
       {"clamp", amount_schema({.min = 0, .max = 1}), "what options.clamp left of it", false},
       {"wavelength_nm", amount_schema(), "of a path that glass has parted by colour", false},
       {"end", plain_schema<PathEnd>(), "why it does not go on"},
       {"vertices", list_schema(vertex_schema(named))}});
}

Value share_schema(std::vector<SchemaMember> members) {
  for (SchemaMember& each : std::vector<SchemaMember>{
           {"mean", vector_schema(), "linear RGB, over all paths"},
           {"error", vector_schema(), "the standard error of that, as of independent paths", false},
           {"share", plain_schema<double>(),
            "of the luminance; of few paths through glass that parts colours it may be negative"},
           {"paths", count_schema(), "how many have such light"}})
    members.push_back(std::move(each));
  return object_schema(members);
}
Value group_schema() {
  return share_schema(
      {{"expression", word_schema(),
        "from the eye: D diffuse, G glossy, S specular, T transmitted, V volume, E what emits; *E: "
        "all longer ones"}});
}
Value surface_schema() {
  return share_schema({{"object", word_schema()}, {"id", count_schema(1), "which of objects"}});
}

}  // namespace

Value::Object value_of(const PathExplanation& all) {
  std::vector<PathWriter> writers;
  for (const World& world : all.worlds) writers.emplace_back(all.ray, world);
  Value::Object answer = value_of(all.ray);
  Value::Array samples;
  for (const ExplainedPath& each : all.paths)
    samples.push_back(writers[static_cast<std::size_t>(each.sample) % writers.size()].path(each));
  answer.emplace_back("count", all.count);
  answer.emplace_back("mean", triple_value(all.mean));
  answer.emplace_back("groups", groups_value(all));
  Value::Array over;
  for (const PathSurface& each : all.surfaces)
    over.push_back(writers.front().surface(each, all.count));
  answer.emplace_back("over", std::move(over));
  answer.emplace_back("samples", std::move(samples));
  return answer;
}

std::vector<SchemaMember> paths_schema(Definitions& named) {
  return {
      {"count", count_schema(1), "of path: how many paths there are", false},
      {"mean", vector_schema(),
       "of path: linear RGB, that of the colours of all; the picture's pixel, bit for bit", false},
      {"groups", list_schema(group_schema()),
       "of path: its light by light path expressions, the greatest share first", false},
      {"over", list_schema(surface_schema()),
       "of path: what of its light came to the first thing met over a further surface, by the "
       "object of that: the nearest that did more than let it through; 16 at most",
       false},
      {"samples", list_schema(sample_schema(named)),
       "of path: some of the paths, in the picture's own arithmetic", false}};
}

}  // namespace tia
