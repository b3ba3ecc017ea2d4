#include "core/scene/model_objects.h"

#include <array>
#include <map>
#include <utility>

#include "core/scene/model_maps.h"
#include "core/scene/model_material.h"
#include "core/scene/model_place.h"

namespace tia {
namespace {

TransformSteps steps_by(const Affine& map) {
  if (map == Affine{}) return {};
  const auto row = [](double x, double y, double z, double w) {
    return std::array<double, 4>{x, y, z, w};
  };
  return {{Matrix{
      {{row(map.x.x, map.y.x, map.z.x, map.offset.x), row(map.x.y, map.y.y, map.z.y, map.offset.y),
        row(map.x.z, map.y.z, map.z.z, map.offset.z), row(0, 0, 0, 1)}}}}};
}

Vec3d vertex(const std::vector<double>& positions, std::size_t i) {
  return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
}

// The mesh with its vertices moved. Where the map mirrors, front is what turns clockwise.
Mesh moved(const Mesh& mesh, const Affine& map) {
  Mesh moved = mesh;
  moved.normals.values.clear();
  moved.tangents.values.clear();
  auto& positions = moved.positions.values.edit();
  for (std::size_t i = 0; i < moved.vertices(); ++i) {
    const Vec3d p = map.point(vertex(positions, i));
    positions[3 * i] = p.x, positions[3 * i + 1] = p.y, positions[3 * i + 2] = p.z;
  }
  if (map.determinant() < 0) {
    auto& indices = moved.indices.values.edit();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      std::swap(indices[i + 1], indices[i + 2]);
  }
  return moved;
}

/// Making: objects of pieces, one after the other.
class Making {
 public:
  Making(const KeptModel& kept, const Object& object, const Affine& map, double point_radius)
      : kept_(kept), object_(object), map_(map), point_radius_(point_radius) {}

  Object object_of(const ModelPiece& piece, ModelBudget& budget) const {
    std::vector<Object> all;
    for (const Affine& place : piece.places) {
      const Affine whole = map_ * place;
      if (piece.points) add_points(piece, whole, all, budget);
      else all.push_back(placed(piece, whole, budget));
    }
    Object made;
    if (all.size() == 1) made = std::move(all.front());
    else made.shape = Group{std::move(all), {}};
    if (!object_.material && !made.material) made.material = material_for(piece);
    return made;
  }

 private:
  Object placed(const ModelPiece& piece, const Affine& map, ModelBudget& budget) const {
    Mesh mesh = piece.mesh;
    if (instead_of(piece) != nullptr) mesh.colors = {};
    if (is_usable(map)) return {piece.name, std::move(mesh), steps_by(map), {}};
    if (!budget.take(0, static_cast<std::int64_t>(mesh.vertices() + mesh.triangles()))) return {};
    return {piece.name, moved(mesh, map), {}, {}};
  }

  // Balls of one colour share a material, and what shading takes of it.
  void add_points(const ModelPiece& piece, const Affine& map, std::vector<Object>& all,
                  ModelBudget& budget) const {
    const std::vector<double>& colors = piece.mesh.colors.values;
    if (colors.empty() || instead_of(piece) != nullptr) {
      for (std::size_t i = 0; i < piece.mesh.vertices(); ++i) all.push_back(ball(piece, map, i));
      return;
    }
    std::map<std::array<double, 4>, std::size_t> known;
    for (std::size_t i = 0; i < piece.mesh.vertices(); ++i) {
      const std::array<double, 4> color{colors[4 * i], colors[4 * i + 1], colors[4 * i + 2],
                                        colors[4 * i + 3]};
      const auto [at, is_new] = known.try_emplace(color, all.size());
      if (is_new) {
        if (!budget.take(1, 0)) return;
        all.push_back({piece.name, Group{}, {}, colored(piece, color)});
      }
      std::get<Group>(all[at->second].shape).children.push_back(ball(piece, map, i));
    }
  }
  Object ball(const ModelPiece& piece, const Affine& map, std::size_t i) const {
    const Vec3d center = map.point(vertex(piece.mesh.positions.values, i));
    return {piece.name, Sphere{center, point_radius_}, {}, {}};
  }
  // The piece's own material where the mesh has that colour.
  MaterialRef colored(const ModelPiece& piece, const std::array<double, 4>& color) const {
    ModelMaterial own = material_in(piece);
    own.base_color.r *= color[0], own.base_color.g *= color[1], own.base_color.b *= color[2];
    own.alpha *= color[3];
    return Boxed<Material>(material_of(own, nullptr, std::get<PlacedModel>(object_.shape).ambient));
  }

  const ModelMaterial& material_in(const ModelPiece& piece) const {
    static const ModelMaterial plain;
    return piece.material ? kept_.model->materials[*piece.material] : plain;
  }
  // What the object has it wear; null: its own.
  const MaterialRef* instead_of(const ModelPiece& piece) const {
    if (object_.material) return &*object_.material;
    const auto& named = named_materials(object_);
    const auto instead = named.find(material_in(piece).name);
    return instead != named.end() ? &instead->second : nullptr;
  }
  MaterialRef material_for(const ModelPiece& piece) const {
    if (const MaterialRef* instead = instead_of(piece)) return *instead;
    const ModelMaterial& own = material_in(piece);
    auto maps = piece.points ? nullptr : maps_of(kept_, own, piece.mesh);
    return Boxed<Material>(
        material_of(own, std::move(maps), std::get<PlacedModel>(object_.shape).ambient));
  }

  const KeptModel& kept_;
  const Object& object_;
  const Affine map_;
  const double point_radius_;
};

// Where there is one point only it has no box to go by.
double point_radius_of(const PlacedModel& asked, const Aabb& box) {
  const double diagonal = length(box.size());
  return asked.point_radius.value_or(diagonal > 0 ? diagonal / 500 : 1.0 / 500);
}

}  // namespace

Affine map_of(const PlacedModel& asked, const ModelChoice& choice, const Aabb& bounds) {
  const Affine up = upright(choice.up);
  return asked.fit ? fitted(*asked.fit, bounds_of(up, bounds)) * up : up;
}

std::vector<Object> model_objects(const KeptModel& kept, const Object& object,
                                  const ModelChoice& choice, ModelBudget& budget) {
  const std::vector<ModelPiece> pieces =
      pieces_of(*kept.model, choice, budget, kept.tangents.get());
  if (pieces.empty()) return {};
  const auto& asked = std::get<PlacedModel>(object.shape);
  const Aabb box = bounds_of(pieces);
  const Affine map = map_of(asked, choice, box);
  const Making making(kept, object, map, point_radius_of(asked, bounds_of(map, box)));
  std::vector<Object> all;
  for (const ModelPiece& piece : pieces) {
    all.push_back(making.object_of(piece, budget));
    if (budget.is_exceeded()) return {};
  }
  return all;
}

}  // namespace tia
