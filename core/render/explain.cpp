#include "core/render/explain.h"

#include "core/input/codec.h"

namespace tia {

Explanation explain(const Scene& scene, const Ray<double>& ray) {
  const World world = compile(scene);
  const std::vector<ObjectLabel> labels = object_labels(scene);
  Explanation explanation{ray, {}};
  for (const Meeting& each : all_hits(world, ray)) {
    const auto object = static_cast<std::size_t>(world.part(each.part).object);
    explanation.hits.push_back({labels[object], each});
  }
  return explanation;
}

Value::Object value_of(const Explanation& explanation) {
  const auto& [origin, direction] = explanation.ray;
  Value::Array hits;
  for (const auto& [object, at] : explanation.hits)
    hits.push_back(Value::Object{{"t", at.t},
                                 {"object", object.name},
                                 {"type", object.type},
                                 {"point", write_value(at.point)},
                                 {"normal", write_value(at.normal)},
                                 {"uv", Value::Array{at.uv.u, at.uv.v}},
                                 {"front", at.front}});
  return {{"ray",
           Value::Object{{"origin", write_value(origin)}, {"direction", write_value(direction)}}},
          {"hits", std::move(hits)}};
}

}  // namespace tia
