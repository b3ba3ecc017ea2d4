#include "core/scene/model_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/models/smooth.h"
#include "core/models/tangents.h"
#include "core/scene/model_maps.h"

namespace tia {
namespace {

// glTF's v goes downward, the scene's upward.
Numbers<float> uvs_of(std::vector<double> uvs) {
  for (std::size_t i = 1; i < uvs.size(); i += 2) uvs[i] = 1 - uvs[i];
  return {std::move(uvs)};
}

// Source: Khronos, glTF 2.0, 3.7.2.1: colours are clamped.
Numbers<float> colors_of(const ModelPart& part) {
  std::vector<double> colors(part.colors.begin(), part.colors.end());
  for (double& each : colors) each = std::clamp(each, 0.0, 1.0);
  return {std::move(colors)};
}

// Where vertices may be parted, as many more as there are corners.
std::int64_t size_of(const ModelPart& part, bool parts) {
  const std::size_t parted = parts ? 3 * part.triangles() : 0;
  return static_cast<std::int64_t>(part.vertices() + part.triangles() + parted);
}

void smooth(Mesh& mesh, double degrees) {
  SmoothVertices shared =
      tia::smooth(mesh.positions.values.get(), mesh.indices.values.get(), degrees);
  if (shared.normals.empty()) return;
  mesh.positions.values = taken(mesh.positions.values.get(), shared.from, 3);
  mesh.uvs.values = taken(mesh.uvs.values.get(), shared.from, 2);
  mesh.more_uvs.values = taken(mesh.more_uvs.values.get(), shared.from, 2);
  mesh.colors.values = taken(mesh.colors.values.get(), shared.from, 4);
  mesh.indices.values = std::move(shared.indices);
  mesh.normals.values = std::move(shared.normals);
}

// Where the uvs are in a picture, v upward.
std::vector<double> uvs_in(const TextureUse& use, const Mesh& mesh) {
  TextureMap map;
  map.transform({use.offset[0], use.offset[1]}, {use.scale[0], use.scale[1]}, use.rotation);
  const auto& more = mesh.more_uvs.values.get();
  std::vector<double> uvs = use.uv_set == 1 && !more.empty() ? more : mesh.uvs.values.get();
  for (std::size_t i = 0; i + 1 < uvs.size(); i += 2) {
    const Vec2d at = place_in(map, {uvs[i], uvs[i + 1]});
    uvs[i] = at.u, uvs[i + 1] = -at.v;
  }
  return uvs;
}

// Appends to a list what it has of those vertices.
void add_vertices(Numbers<float>& list, const std::vector<std::uint32_t>& which,
                  std::size_t width) {
  const std::vector<double> more = taken(list.values.get(), which, width);
  if (more.empty()) return;
  auto& all = list.values.edit();
  all.insert(all.end(), more.begin(), more.end());
}

// Source: Khronos, glTF 2.0, 3.7.2.1. None without uvs.
TangentLists made_tangents(const Mesh& mesh, const TextureUse& use) {
  const std::vector<double> uvs = uvs_in(use, mesh);
  if (uvs.empty()) return {};
  TangentVertices made = tangents_of(
      {mesh.positions.values.get(), mesh.normals.values.get(), uvs, mesh.indices.values.get()});
  return {std::move(made.from), std::move(made.indices), std::move(made.tangents)};
}

void add_tangents(Mesh& mesh, const TangentLists& made) {
  mesh.tangents.values = made.tangents;
  if (made.from.empty()) return;
  mesh.indices.values = made.indices;
  add_vertices(mesh.positions, made.from, 3), add_vertices(mesh.normals, made.from, 3);
  add_vertices(mesh.uvs, made.from, 2), add_vertices(mesh.more_uvs, made.from, 2);
  add_vertices(mesh.colors, made.from, 4);
}

/// Gathering: goes through what a pose shows.
class Gathering {
 public:
  Gathering(const Model& model, const ModelChoice& choice, ModelBudget& budget,
            ModelTangents* tangents)
      : model_(model),
        choice_(choice),
        budget_(budget),
        tangents_(tangents),
        pose_(pose_of(model, choice.moment)) {}

  std::vector<ModelPiece> pieces() {
    std::vector<bool> hidden(model_.nodes.size());
    for (const ModelIndex number : pose_.shown) {  // each after its parent
      const ModelNode& node = model_.nodes[number];
      if (is_hidden(node.name)) hidden[number] = true;
      if (hidden[number])
        for (const ModelIndex child : node.children) hidden[child] = true;
      else if (node.mesh && !is_hidden(model_.meshes[*node.mesh].name) && !add(number)) return {};
    }
    return std::move(pieces_);
  }

 private:
  bool is_hidden(const std::string& name) const { return choice_.hidden.contains(name); }

  MaybeIndex worn_by(const ModelPart& part) const {
    for (const VariantMaterial& each : part.variants)
      if (each.variant == choice_.variant) return each.material;
    return part.material;
  }

  // Returns: whether the budget reaches.
  bool add(ModelIndex number) {
    const ModelNode& node = model_.nodes[number];
    const ModelMesh& mesh = model_.meshes[*node.mesh];
    const std::string& name = node.name.empty() ? mesh.name : node.name;
    // What a skin moves stands in the model's space already.
    const std::vector<Affine> places =
        node.skin ? std::vector<Affine>{{}} : places_of(node, pose_.places[number]);
    for (const ModelPart& part : mesh.parts) {
      const MaybeIndex material = worn_by(part);
      if (!part.points && part.indices.empty()) continue;
      if (material && is_hidden(model_.materials[*material].name)) continue;
      if (!afford(part, material, places.size(), is_posed(node, part))) return false;
      pieces_.push_back({excerpt_of(name, longest_name), places, material, part.points,
                         mesh_of(number, part, material)});
    }
    return true;
  }

  // Whether its faces may share normals that the file does not have.
  bool smooths(const ModelPart& part) const {
    return choice_.smooth > 0 && part.normals.empty() && !part.points;
  }

  // The texture along which tangents are to be made that the file does not have.
  const TextureUse* tangents_along(const ModelPart& part, const MaybeIndex& material) const {
    if (!material || part.points || (!part.tangents.empty() && !smooths(part))) return nullptr;
    return tangent_texture(model_.materials[*material]);
  }

  // Whether vertices may be parted.
  bool parts(const ModelPart& part, const MaybeIndex& material) const {
    return smooths(part) || tangents_along(part, material) != nullptr;
  }

  bool afford(const ModelPart& part, const MaybeIndex& material, std::size_t places, bool posed) {
    const std::int64_t each = part.points ? static_cast<std::int64_t>(part.vertices()) : 1;
    const bool is_new = posed || !known_.contains(&part);
    return budget_.take(each * static_cast<std::int64_t>(places),
                        is_new ? size_of(part, parts(part, material)) : 0);
  }

  Mesh mesh_of(ModelIndex number, const ModelPart& part, const MaybeIndex& material) {
    const bool posed = is_posed(model_.nodes[number], part);
    const auto [known, is_new] = known_.try_emplace(&part);
    Mesh& mesh = known->second;
    if (is_new && part.points) mesh.colors = colors_of(part);
    if ((is_new || (posed && parts(part, material))) && !part.points) {
      mesh.indices.values = part.indices;
      mesh.uvs = uvs_of(part.uvs[0]);
      mesh.colors = colors_of(part);
      if (material && wants_more_uvs(model_.materials[*material]))
        mesh.more_uvs = uvs_of(part.uvs[1]);
    }
    if (is_new || posed) {
      PartShape shape = shape_of(model_, pose_, number, part);
      mesh.positions.values = std::move(shape.positions);
      mesh.normals.values = std::move(shape.normals);
      if (smooths(part)) smooth(mesh, choice_.smooth);
      else if (material && tangent_texture(model_.materials[*material]) != nullptr)
        mesh.tangents.values = std::move(shape.tangents);
      if (const TextureUse* along = tangents_along(part, material); along && tangents_)
        add_made_tangents(mesh, part, *along, posed || smooths(part));
    }
    return mesh;
  }
  // Those of what is as the file has it are kept with the model.
  void add_made_tangents(Mesh& mesh, const ModelPart& part, const TextureUse& along,
                         bool differs) const {
    const auto make = [&] { return made_tangents(mesh, along); };
    if (differs) add_tangents(mesh, make());
    else add_tangents(mesh, *tangents_->of(part, along, make));
  }

  const Model& model_;
  const ModelChoice& choice_;
  ModelBudget& budget_;
  ModelTangents* const tangents_;
  Pose pose_;
  std::map<const ModelPart*, Mesh> known_;
  std::vector<ModelPiece> pieces_;
};

}  // namespace

std::vector<ModelPiece> pieces_of(const Model& model, const ModelChoice& choice,
                                  ModelBudget& budget, ModelTangents* tangents) {
  return Gathering(model, choice, budget, tangents).pieces();
}

Aabb bounds_of(const std::vector<ModelPiece>& pieces) {
  Aabb box;
  std::uint64_t left = most_placed_vertices;
  for (const ModelPiece& piece : pieces)
    box = around(box, bounds_at(piece.places, piece.mesh.positions.values, left));
  return box;
}

}  // namespace tia
