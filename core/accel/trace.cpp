#include "core/accel/trace.h"

namespace tia {

SurfaceFrame frame_at(const World& world, const Vec3d& p, int part, int element,
                      std::int64_t copy) {
  const Part& own = world.part(part);
  const Affine to_object = own.to_object * world.to_space(own.space, copy);
  const Vec3d local = to_object.point(p);
  // Normals are carried out by the inverse transpose.
  const auto outwards = [&](const Vec3d& n) { return normalize(to_object.row(n)); };
  if (own.mesh >= 0) {
    const MeshPoint at = point_of(world.meshes[static_cast<std::size_t>(own.mesh)],
                                  static_cast<std::size_t>(element), local);
    return {outwards(at.n), outwards(at.ng), at.uv};
  }
  return std::visit(
      [&](const auto& form) -> SurfaceFrame {
        const Vec3d n = outwards(normal(form, local, element));
        return {n, n, uv(form, local, element)};
      },
      own.form);
}

}  // namespace tia
