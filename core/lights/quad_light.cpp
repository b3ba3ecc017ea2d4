#include "core/lights/quad_light.h"

#include "core/input/codec.h"

namespace tia {

void QuadLight::check(const Place& at, Faults& faults) const {
  const Vec3d across = cross(u, v);
  // The sine between the edges. With less, rounding would turn the normal by some 1e-4.
  if (length(across) > 1e-12 * length(u) * length(v)) return;
  const bool no_u = u == Vec3d{0, 0, 0};
  faults.add({FaultKind::out_of_range, at.at(no_u ? "u" : "v").pointer(), write_value(no_u ? u : v),
              std::string("an edge that spans an area with ") + (no_u ? "v" : "u")});
}

Mesh surface(const QuadLight& light) {
  Mesh mesh;
  const Vec3d corners[] = {*light.corner, *light.corner + light.u,
                           *light.corner + light.u + light.v, *light.corner + light.v};
  for (const Vec3d& p : corners)
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
  mesh.indices.values = {0, 1, 2, 0, 2, 3};
  return mesh;
}

}  // namespace tia
