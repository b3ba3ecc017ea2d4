// Walls as objects of a scene: the part of core/shapes/composite/walls.h that an Object is whole
// for.
#include "core/scene/object.h"
#include "core/shapes/composite/wall_pieces.h"

namespace tia {
namespace {

Matrix matrix_of(const Affine& map) {
  const auto row = [&](double Vec3d::*axis) {
    return std::array{map.x.*axis, map.y.*axis, map.z.*axis, map.offset.*axis};
  };
  return {{{row(&Vec3d::x), row(&Vec3d::y), row(&Vec3d::z), {0, 0, 0, 1}}}};
}

Object object_of(const WallPiece& piece) {
  Object object;
  std::visit([&](const auto& shape) { object.shape = shape; }, piece.shape);
  if (piece.place) object.transform.steps.emplace_back(matrix_of(*piece.place));
  return object;
}

}  // namespace

void Walls::check(const Place& at, Faults& faults) {
  std::vector<Object> objects;
  for (const WallPiece& piece : wall_pieces(*this, at, faults)) objects.push_back(object_of(piece));
  shown = std::make_shared<const std::vector<Object>>(std::move(objects));
}

bool Walls::operator==(const Walls& other) const {
  return points == other.points && closed == other.closed && height == other.height &&
         thickness == other.thickness && openings == other.openings;
}

const std::vector<Object>& children_in(const Walls& walls) {
  static const std::vector<Object> none;
  return walls.shown ? *walls.shown : none;
}

}  // namespace tia
