#include "core/models/describe.h"

#include "core/models/animation.h"
#include "core/models/describe_material.h"
#include "core/models/pose.h"

namespace tia {
namespace {

Value point_value(const Vec3d& p) { return Value::Array{p.x, p.y, p.z}; }
Value number_value(std::size_t count) { return static_cast<double>(count); }

template <class List, class F>
Value listed_by(const List& list, F f) {
  Value::Array all;
  for (const auto& each : list) all.push_back(f(each));
  return all;
}
Value name_value(const std::string& name) { return name; }

Value bounds_value(const Model& model) {
  const Aabb box = bounds_of(model, pose_of(model));
  if (box.empty()) return nullptr;
  return Value::Object{{"min", point_value(box.min)}, {"max", point_value(box.max)}};
}

Value camera_value(const ModelCamera& camera) {
  return Value::Object{{"name", camera.name},
                       {"projection", camera.orthographic ? "orthographic" : "perspective"}};
}
Value light_value(const ModelLight& light) {
  return Value::Object{{"name", light.name},
                       {"type", name_of(light.kind)},
                       {"color", Value::Array{light.color.r, light.color.g, light.color.b}},
                       {"intensity", light.intensity}};
}
Value animation_value(const ModelAnimation& animation) {
  return Value::Object{{"name", animation.name}, {"seconds", duration_of(animation)}};
}
Value warning_value(const ModelWarning& warning) {
  Value::Object value;
  if (warning.line > 0) value.emplace_back("line", number_value(warning.line));
  else value.emplace_back("pointer", warning.pointer);
  value.emplace_back("text", warning.text);
  return value;
}

struct ModelCounts {
  std::size_t vertices = 0, triangles = 0, points = 0;
};
ModelCounts counts_of(const Model& model) {
  ModelCounts counts;
  for (const ModelMesh& mesh : model.meshes) {
    for (const ModelPart& part : mesh.parts) {
      counts.vertices += part.vertices();
      counts.triangles += part.triangles();
      if (part.points) counts.points += part.vertices();
    }
  }
  return counts;
}

}  // namespace

Value description_of(const Model& model) {
  const ModelCounts counts = counts_of(model);
  Value::Object all{{"format", model.format}};
  if (!model.generator.empty()) all.emplace_back("generator", model.generator);
  if (!model.copyright.empty()) all.emplace_back("copyright", model.copyright);
  all.emplace_back("up", model.z_up ? "z" : "y");
  all.emplace_back("bounds", bounds_value(model));
  all.emplace_back("vertices", number_value(counts.vertices));
  all.emplace_back("triangles", number_value(counts.triangles));
  all.emplace_back("points", number_value(counts.points));
  all.emplace_back("nodes", number_value(model.nodes.size()));
  all.emplace_back("materials", listed_by(model.materials, [&](const ModelMaterial& each) {
                     return material_value(model, each);
                   }));
  all.emplace_back("textures", number_value(model.textures.size()));
  all.emplace_back("cameras", listed_by(model.cameras, camera_value));
  all.emplace_back("lights", listed_by(model.lights, light_value));
  all.emplace_back("animations", listed_by(model.animations, animation_value));
  all.emplace_back("variants", listed_by(model.variants, name_value));
  all.emplace_back("extensions", listed_by(model.extensions, name_value));
  all.emplace_back("warnings", listed_by(model.warnings, warning_value));
  return all;
}

}  // namespace tia
