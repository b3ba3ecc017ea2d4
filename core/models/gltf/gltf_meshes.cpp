#include <algorithm>

#include "core/models/gltf/gltf_attributes.h"
#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_head.h"
#include "core/models/gltf/gltf_indices.h"

namespace tia::gltf {
namespace {

// The material of what has none.
// Source: Khronos, glTF 2.0 (2021), section 3.9.6.
ModelMaterial default_gltf_material() {
  ModelMaterial material;
  material.base_color = {1, 1, 1};
  material.metallic = material.roughness = 1;
  material.double_sided = false;
  return material;
}

/// MeshReader: reads one mesh after the other, and counts what they have in all.
class MeshReader {
 public:
  MeshReader(const GltfSource& source, Model& model)
      : source_(source),
        model_(model),
        quantized_(uses(model, "KHR_mesh_quantization")),
        materials_(source.root.size_of("materials")),
        triangles_left_(source.limits.triangles),
        vertices_left_(source.limits.vertices) {
    source.root.with_extension("KHR_materials_variants", [&](const GltfObject& extension) {
      variants_ = extension.size_of("variants");
    });
  }

  void read(const GltfObject& object) {
    ModelMesh mesh;
    mesh.name = object.text("name");
    std::optional<std::size_t> targets;
    object.needs("primitives", "a list of primitives");
    object.for_each("primitives", [&](const GltfObject& primitive, std::size_t) {
      check_targets(primitive, targets);
      if (auto part = read_part(primitive)) mesh.parts.push_back(std::move(*part));
    });
    mesh.weights = object.number_list("weights");
    if (mesh.weights.empty()) mesh.weights.resize(targets.value_or(0));
    if (targets && mesh.weights.size() != *targets)
      object.fault(FaultKind::conflict, "weights",
                   Value(std::to_string(mesh.weights.size()) + " weights"),
                   "as many as there are morph targets: " + std::to_string(*targets));
    model_.meshes.push_back(std::move(mesh));
  }

 private:
  void warn(const GltfObject& object, std::string text) {
    model_.warn({object.at().pointer(), 0, std::move(text)});
  }

  static void check_targets(const GltfObject& primitive, std::optional<std::size_t>& targets) {
    const std::size_t count = primitive.size_of("targets");
    if (targets.value_or(count) != count)
      primitive.fault(FaultKind::conflict, "targets",
                      Value(std::to_string(count) + " morph targets"),
                      std::to_string(*targets) + ", as many as the mesh's first primitive has");
    if (!targets) targets = count;
  }

  // Takes what a primitive has from what is left.
  static bool take(const GltfObject& object, std::uint64_t& left, std::uint64_t count,
                   std::uint64_t limit, std::string_view what) {
    if (count <= left) {
      left -= count;
      return true;
    }
    object.fault(FaultKind::limit, Value(static_cast<double>(count)),
                 "at most " + std::to_string(limit) + " " + std::string(what));
    return false;
  }

  std::optional<ModelPart> read_part(const GltfObject& primitive) {
    const std::size_t before = source_.faults.count();
    const auto mode = static_cast<PrimitiveMode>(primitive.integer("mode", 0, 6).value_or(4));
    primitive.needs("attributes", "an object of accessors by their attributes' names");
    std::optional<ModelPart> part;
    primitive.with("attributes", [&](const GltfObject& attributes) {
      if (is_taken(primitive, attributes, mode)) part = read_part(primitive, attributes, mode);
    });
    if (!part || source_.faults.count() != before) return std::nullopt;
    read_materials_of(primitive, *part);
    if (!part->points && part->indices.empty()) {
      warn(primitive, "it has no triangle");
      return std::nullopt;
    }
    return part;
  }

  // Lines have no area.
  bool is_taken(const GltfObject& primitive, const GltfObject& attributes, PrimitiveMode mode) {
    if (mode == PrimitiveMode::lines || mode == PrimitiveMode::line_loop ||
        mode == PrimitiveMode::line_strip) {
      warn(primitive, "lines are not taken");
      return false;
    }
    if (!attributes.there()) return false;
    if (!attributes.has("POSITION")) {
      warn(primitive, "without positions it is not taken");
      return false;
    }
    return true;
  }

  std::optional<ModelPart> read_part(const GltfObject& primitive, const GltfObject& object,
                                     PrimitiveMode mode) {
    const std::vector<Accessor>& all = source_.bytes.accessors();
    const MaybeIndex index = object.index("POSITION", all.size());
    if (!index || !all[*index].good) return std::nullopt;
    const std::uint64_t vertices = all[*index].count;
    const std::uint64_t limit = source_.limits.vertices, copies = 1 + primitive.size_of("targets");
    const Accessor* indices = indices_accessor(source_, primitive);
    const std::uint64_t corners = indices == nullptr ? vertices : indices->count;
    const bool points = mode == PrimitiveMode::points;
    if (!take(primitive, vertices_left_, std::min(vertices, limit / copies + 1) * copies, limit,
              "vertices in all, morph targets counted") ||
        !take(primitive, triangles_left_, points ? 0 : triangles_of(mode, corners),
              source_.limits.triangles, "triangles in all (option TIA_MAX_TRIANGLES)"))
      return std::nullopt;
    const bool packed = is_packed(primitive);
    const auto unpacked =
        packed ? unpack(source_, {primitive, object, mode, indices}) : std::nullopt;
    if (packed && !unpacked) return std::nullopt;
    const Attributes attributes{source_,    object, vertices,
                                quantized_, model_, unpacked ? &*unpacked : nullptr};
    ModelPart part;
    part.points = points;
    read_vertices(attributes, part);
    read_targets(attributes, primitive, part);
    if (unpacked) part.indices = unpacked->indices;
    else if (!points) part.indices = read_triangles(primitive, indices, mode, vertices);
    else if (primitive.has("indices")) warn(primitive, "indices of points are not taken");
    return part;
  }

  std::vector<std::uint32_t> read_triangles(const GltfObject& primitive, const Accessor* accessor,
                                            PrimitiveMode mode, std::uint64_t vertices) {
    if (primitive.has("indices") && accessor == nullptr) return {};
    auto indices = read_indices(source_, primitive, accessor, vertices);
    if (!indices) return {};
    if (mode == PrimitiveMode::triangles && indices->size() % 3 != 0)
      warn(primitive,
           "the last " + std::to_string(indices->size() % 3) + " of its indices make no triangle");
    return as_list(mode, std::move(*indices));
  }

  void read_materials_of(const GltfObject& primitive, ModelPart& part) {
    part.material = primitive.index("material", materials_);
    if (!part.material && !primitive.has("material")) part.material = default_material();
    primitive.with_extension("KHR_materials_variants", [&](const GltfObject& extension) {
      part.variants = read_variants(extension);
    });
  }

  std::vector<VariantMaterial> read_variants(const GltfObject& extension) const {
    std::vector<VariantMaterial> all;
    std::vector<ModelIndex> named;
    extension.for_each("mappings", [&](const GltfObject& mapping, std::size_t) {
      mapping.needs("material", "the number of a material");
      mapping.needs("variants", "the numbers of variants");
      const ModelIndex material = mapping.index("material", materials_).value_or(0);
      for (const ModelIndex variant : mapping.unique_indices("variants", variants_)) {
        all.push_back({variant, material});
        named.push_back(variant);
      }
    });
    std::ranges::sort(named);
    const auto twice = std::ranges::adjacent_find(named);
    if (twice != named.end())
      extension.fault(FaultKind::conflict, "mappings", Value(static_cast<double>(*twice)),
                      "each variant once");
    return all;
  }

  ModelIndex default_material() {
    if (!default_material_) {
      default_material_ = static_cast<ModelIndex>(model_.materials.size());
      model_.materials.push_back(default_gltf_material());
    }
    return *default_material_;
  }

  const GltfSource& source_;
  Model& model_;
  bool quantized_;
  std::size_t materials_, variants_ = 0;
  std::uint64_t triangles_left_, vertices_left_;
  MaybeIndex default_material_;
};

}  // namespace

void read_meshes(const GltfSource& source, Model& model) {
  MeshReader reader(source, model);
  source.root.for_each("meshes",
                       [&](const GltfObject& object, std::size_t) { reader.read(object); });
}

}  // namespace tia::gltf
