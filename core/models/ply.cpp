#include "core/models/ply.h"

#include <optional>
#include <string>
#include <utility>

#include "core/models/ply_faces.h"
#include "core/models/ply_header.h"
#include "core/models/ply_rows.h"
#include "core/models/ply_source.h"
#include "core/models/ply_vertices.h"

namespace tia {
namespace {

std::string_view ply_text_of(ModelBytes file) {
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

// The element of a name; null where there is none. Errors: `conflict`, where there are two.
const PlyElement* find_element(const PlyHeader& header, std::string_view name, Faults& faults) {
  const PlyElement* found = nullptr;
  for (const PlyElement& element : header.elements) {
    if (element.name != name) continue;
    if (found != nullptr)
      faults.add(ply_fault(FaultKind::conflict, element, Value(name), "one element of that name"));
    found = &element;
  }
  return found;
}

// The elements that are used; the last two may be null.
struct PlyElements {
  const PlyElement *vertex = nullptr, *face = nullptr, *strips = nullptr;

  bool has_faces() const {
    return (face != nullptr && face->count > 0) || (strips != nullptr && strips->count > 0);
  }
};

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, const PlyElements& elements, const ModelLimits& limits,
            Faults& faults, Model& model)
      : header_(header),
        elements_(elements),
        faults_(faults),
        model_(model),
        vertices_(*elements.vertex, limits, faults, model),
        faces_(elements.vertex->count, limits, faults, model) {
    for (const PlyElement& element : header.elements) plans_.push_back(plan(element));
  }

  /// Returns: the part; of no meaning where there is a fault.
  ModelPart read() {
    switch (header_.encoding) {
      case PlyEncoding::ascii: read_body(PlyText(header_)); break;
      case PlyEncoding::little_endian: read_body(PlyBytes<std::endian::little>(header_)); break;
      case PlyEncoding::big_endian: read_body(PlyBytes<std::endian::big>(header_)); break;
    }
    if (!faults_.empty()) return {};
    ModelPart part = vertices_.finish();
    part.material = 0;
    part.points = !elements_.has_faces();
    faces_.triangulate_into(part);
    return part;
  }

 private:
  PlyPlan plan(const PlyElement& element) {
    if (&element == elements_.vertex) return vertices_.plan();
    if (&element == elements_.face) return faces_.plan_faces(element);
    if (&element == elements_.strips) return faces_.plan_strips(element);
    PlyPlan nothing(element);
    warn_of_skipped(element, nothing, model_);
    return nothing;
  }
  template <class Source>
  void read_body(Source source) {
    if (!faults_.empty()) return;
    for (std::size_t i = 0; i < plans_.size(); ++i)
      if (!read_element(header_.elements[i], PlyRows(source, header_.elements[i], plans_[i])))
        return;
    if (source.left() > 0)
      model_.warn({"", source.line() ? *source.line() + 1 : 0,
                   std::to_string(source.left()) + " bytes behind the last row are left out"});
  }
  template <class Source>
  bool read_element(const PlyElement& element, PlyRows<Source> rows) {
    using Row = const PlyRow&;
    using Place = const PlyPlace&;
    if (&element == elements_.vertex)
      return rows.read(faults_, [&](Row row, Place at) { return vertices_.take(row, at); });
    if (&element == elements_.face)
      return rows.read(faults_, [&](Row row, Place at) { return faces_.take_face(row, at); });
    if (&element == elements_.strips)
      return rows.read(faults_, [&](Row row, Place at) { return faces_.take_strip(row, at); });
    return rows.read(faults_, [](Row, Place) { return true; });
  }

  const PlyHeader& header_;
  const PlyElements& elements_;
  Faults& faults_;
  Model& model_;
  PlyVertices vertices_;
  PlyFaces faces_;
  std::vector<PlyPlan> plans_;  // of each of the header's elements
};

// Why a texture's file is not used, "" where it is.
std::string_view refusal_of_texture(const ModelFile* file, bool has_uvs, const Model& model) {
  if (file == nullptr) return "did not come";
  if (!has_uvs) return "has no coordinates at vertices";
  return model.textures.empty() ? "" : "is not the first";
}

constexpr std::size_t longest_ply_path = 1024;  // what is longer is looked up for nothing

void read_ply_textures(const PlyHeader& header, const ModelFiles& files, bool has_uvs,
                       Model& model) {
  for (const PlyTexture& texture : header.textures) {
    const std::string name = excerpt_of(texture.name, longest_name);
    const ModelFile* const file = texture.name.size() <= longest_ply_path
                                      ? files.find(texture.name, files.main_file().path)
                                      : nullptr;
    const std::string_view refusal = refusal_of_texture(file, has_uvs, model);
    if (file == nullptr || !refusal.empty()) {
      model.warn(
          {"", texture.line, "the texture " + name + " is not used: it " + std::string(refusal)});
      continue;
    }
    model.images.push_back({name, {file->bytes.begin(), file->bytes.end()}});
    model.textures.emplace_back();
    model.materials.front().base_color_texture.emplace();
  }
}

void add_ply_part(ModelPart part, Model& model) {
  model.meshes.emplace_back().parts.push_back(std::move(part));
  model.nodes.emplace_back().mesh = 0;
  model.scenes.emplace_back().nodes.push_back(0);
}

}  // namespace

bool is_ply(ModelBytes file) { return begins_ply(ply_text_of(file)); }

void read_ply(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model) {
  model.format = "ply";
  model.z_up = true;
  model.materials.emplace_back();
  const auto header = read_ply_header(ply_text_of(files.main_file().bytes), faults);
  if (!header) return;
  const PlyElements elements{find_element(*header, "vertex", faults),
                             find_element(*header, "face", faults),
                             find_element(*header, "tristrips", faults)};
  if (elements.vertex == nullptr)
    faults.add({FaultKind::missing, "", std::nullopt, "an element vertex"});
  if (!faults.empty()) return;
  ModelPart part = PlyReader(*header, elements, limits, faults, model).read();
  if (!faults.empty()) return;
  read_ply_textures(*header, files, !part.uvs[0].empty(), model);
  add_ply_part(std::move(part), model);
}

}  // namespace tia
