#include "core/scene/still_points.h"

#include <array>
#include <map>

namespace tia {
namespace {

// So many vertices are framed one by one.
constexpr std::size_t most_vertices = std::size_t{1} << 22U;

/// UsedPoints: what of a mesh's vertices its triangles use.
struct UsedPoints {
  std::vector<Vec3d> all, corners;  // of the box around them
};

UsedPoints used_points(const Mesh& mesh) {
  const std::vector<double>& positions = mesh.positions.values;
  std::vector<bool> used(mesh.vertices());
  for (const std::uint32_t index : mesh.indices.values.get()) used[index] = true;
  UsedPoints points;
  Aabb box;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    points.all.push_back({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]});
    box = around(box, points.all.back());
  }
  for (unsigned i = 0; i < 8; ++i)
    points.corners.push_back({(i & 1U) != 0 ? box.max.x : box.min.x,
                              (i & 2U) != 0 ? box.max.y : box.min.y,
                              (i & 4U) != 0 ? box.max.z : box.min.z});
  return points;
}

/// PointGathering: goes through objects, each mesh once however often it is placed.
class PointGathering {
 public:
  void add(const Object& object, const Affine& above) {
    const Affine place = above * object.transform.affine();
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) add(*mesh, place);
    else if (const auto* ball = std::get_if<Sphere>(&object.shape)) add(*ball, place);
    else if (const auto* group = std::get_if<Group>(&object.shape))
      for (const Object& child : group->children) add(child, place);
  }
  StillPoints points() && { return std::move(points_); }

 private:
  void add(const Mesh& mesh, const Affine& place) {
    const auto [known, is_new] = used_.try_emplace(lists_of(mesh));
    if (is_new) known->second = used_points(mesh);
    const UsedPoints& used = known->second;
    const bool all =
        used.all.size() <= 8 || points_.corners.size() + used.all.size() <= most_vertices;
    for (const Vec3d& p : all ? used.all : used.corners) points_.corners.push_back(place.point(p));
  }
  void add(const Sphere& ball, const Affine& place) {
    points_.balls.push_back(place.point(ball.center));
    points_.ball_radius = ball.radius;
  }

  std::map<MeshLists, UsedPoints> used_;
  StillPoints points_;
};

}  // namespace

StillPoints points_of(const std::vector<Object>& shown) {
  PointGathering gathering;
  for (const Object& object : shown) gathering.add(object, {});
  return std::move(gathering).points();
}

}  // namespace tia
