#include "core/models/obj_parts.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/models/obj_vertices.h"
#include "core/models/polygons.h"

namespace tia {
namespace {

using ObjRuns = std::span<const ObjRun>;

/// ObjPartMaker: makes parts of runs.
class ObjPartMaker {
 public:
  ObjPartMaker(const ObjContent& content, const ObjElements& elements, const Faults& faults)
      : content_(content),
        elements_(elements),
        faults_(faults),
        vertices_(content.positions.size() / 3) {}

  ModelPart part(ObjRuns runs, MaybeIndex material) {
    has_ = {};
    vertices_.begin_part();
    part_ = {};
    part_.material = material;
    part_.points = &elements_ == &content_.points;
    std::size_t triangles = 0, corners = 0;
    for (const ObjRun& run : runs) {
      look_at(run);
      corners += run.corners;
      if (!part_.points) triangles += run.corners - 2 * run.count;
    }
    part_.indices.reserve(3 * triangles);
    reserve_vertices(std::min(corners, content_.positions.size() / 3));
    for (const ObjRun& run : runs) add(run);
    return std::move(part_);
  }

 private:
  // What all corners of a part have. What only some have is of no use.
  struct Has {
    bool uvs = true, normals = true, colors = true;
    bool any() const { return uvs || normals || colors; }
  };

  void look_at(const ObjRun& run) {
    const std::size_t end = run.first_corner + run.corners;
    for (std::size_t i = run.first_corner; i < end && has_.any(); ++i) {
      const ObjCorner corner = elements_.corners[i];
      has_.uvs = has_.uvs && corner.uv != ObjCorner::none;
      has_.normals = has_.normals && content_.has_normal(corner.normal);
      has_.colors = has_.colors && content_.has_color(corner.position);
    }
  }
  // As many as there are if each position is one.
  void reserve_vertices(std::size_t count) {
    vertices_.reserve(count);
    part_.positions.reserve(3 * count);
    if (has_.uvs) part_.uvs[0].reserve(2 * count);
    if (has_.normals) part_.normals.reserve(3 * count);
    if (has_.colors) part_.colors.reserve(4 * count);
  }
  void add(const ObjRun& run) {
    std::size_t corner = run.first_corner;
    for (std::size_t i = run.first; i < run.first + run.count && !faults_.full(); ++i) {
      const std::size_t size = elements_.sizes[i];
      polygon_.resize(size);
      for (std::uint32_t& each : polygon_) each = vertex(elements_.corners[corner++]);
      if (!part_.points) triangulate(polygon_, part_.positions, part_.indices);
    }
  }
  std::uint32_t vertex(ObjCorner corner) {
    if (!has_.uvs) corner.uv = 0;
    if (!has_.normals) corner.normal = 0;
    const std::size_t count = vertices_.count();
    const std::uint32_t number = vertices_.number(corner);
    if (number == count) append(corner);
    return number;
  }
  void append(const ObjCorner& corner) {
    copy<3>(content_.positions, corner.position, part_.positions);
    if (has_.uvs) copy<2>(content_.uvs, corner.uv, part_.uvs[0]);
    if (has_.normals) copy<3>(content_.normals, corner.normal, part_.normals);
    if (!has_.colors) return;
    copy<3>(content_.colors, corner.position, part_.colors);
    part_.colors.push_back(1);
  }
  template <std::size_t numbers, class Number>
  static void copy(const std::vector<Number>& from, std::size_t row, std::vector<Number>& to) {
    const Number* number = &from[numbers * row];
    for (std::size_t i = 0; i < numbers; ++i) to.push_back(number[i]);
  }

  const ObjContent& content_;
  const ObjElements& elements_;
  const Faults& faults_;
  ObjVertices vertices_;
  Has has_;
  ModelPart part_;
  std::vector<std::uint32_t> polygon_;
};

// The model's materials by the names that the file uses. Where a whole file of them did not come,
// that is told already.
std::vector<MaybeIndex> obj_materials_of(const ObjContent& content, Model& model) {
  std::map<std::string_view, ModelIndex> known;
  for (std::size_t i = 0; i < model.materials.size(); ++i)
    known.try_emplace(model.materials[i].name, static_cast<ModelIndex>(i));
  std::vector<MaybeIndex> materials;
  for (const ObjMaterialUse& use : content.materials) {
    const auto found = use.line == 0 ? known.end() : known.find(use.name);
    materials.push_back(found == known.end() ? MaybeIndex() : found->second);
    if (found == known.end() && use.line != 0 && !content.lacks_library)
      model.warn({"", use.line, "no material " + excerpt_of(use.name, longest_name)});
  }
  return materials;
}

/// ObjPartRuns: the runs that make a part.
struct ObjPartRuns {
  MaybeIndex material;
  std::vector<ObjRun> runs;
};

/// ObjRunSorter: puts the runs of a mesh together by their materials.
class ObjRunSorter {
 public:
  ObjRunSorter(const ObjContent& content, Model& model)
      : materials_(obj_materials_of(content, model)), slots_(model.materials.size() + 1) {}

  std::vector<ObjPartRuns> parts(ObjRuns runs) {
    std::vector<ObjPartRuns> parts;
    ++meshes_;
    for (const ObjRun& run : runs) {
      const MaybeIndex material = materials_[run.material];
      Slot& slot = slots_[material ? *material + std::size_t{1} : 0];
      if (slot.mesh != meshes_) {
        slot = {meshes_, parts.size()};
        parts.push_back({material, {}});
      }
      parts[slot.part].runs.push_back(run);
    }
    return parts;
  }

 private:
  // A material's part in that mesh, the present one or one before it.
  struct Slot {
    std::size_t mesh = 0, part = 0;
  };
  std::vector<MaybeIndex> materials_;
  std::vector<Slot> slots_;
  std::size_t meshes_ = 0;
};

void add_obj_mesh(ModelMesh mesh, Model& model) {
  ModelNode node;
  node.name = mesh.name;
  node.mesh = static_cast<ModelIndex>(model.meshes.size());
  model.scenes[0].nodes.push_back(static_cast<ModelIndex>(model.nodes.size()));
  model.nodes.push_back(std::move(node));
  model.meshes.push_back(std::move(mesh));
}

}  // namespace

void add_obj_meshes(const ObjContent& content, const ModelLimits& limits, Faults& faults,
                    Model& model) {
  const ObjElements& elements = content.faces.sizes.empty() ? content.points : content.faces;
  if (&elements == &content.faces && !content.points.sizes.empty())
    model.warn({"", 0, "p: points of a file with faces are not taken"});
  ObjRunSorter sorter(content, model);
  ObjPartMaker maker(content, elements, faults);
  std::uint64_t vertices = 0;
  for (auto run = elements.runs.begin(); run != elements.runs.end();) {
    const auto end = std::find_if(run, elements.runs.end(),
                                  [&](const ObjRun& other) { return other.mesh != run->mesh; });
    ModelMesh mesh{content.meshes[run->mesh], {}, {}};
    for (const ObjPartRuns& part : sorter.parts(ObjRuns(run, end))) {
      mesh.parts.push_back(maker.part(part.runs, part.material));
      vertices += mesh.parts.back().vertices();
      if (vertices > limits.vertices)
        return faults.add({FaultKind::limit, "", Value("more"),
                           "at most " + std::to_string(limits.vertices) + " vertices"});
    }
    add_obj_mesh(std::move(mesh), model);
    run = end;
  }
}

}  // namespace tia
