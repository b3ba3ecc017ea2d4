#include "core/scene/displays/cube.h"

namespace tia {

// For each face its axis, and what is to the right and up there: s grows to the right, t downwards.
ViewGrid Cube::grid(const DisplayFrame& frame) const {
  const Vec3d &x = frame.right, &y = frame.up, &z = frame.view.axis;
  struct Face {
    const char* name;
    Vec3d axis, right, up;
  };
  const Face faces[] = {{"px", x, -z, y}, {"nx", -x, z, y}, {"py", y, x, -z},
                        {"ny", -y, x, z}, {"pz", z, x, y},  {"nz", -z, -x, y}};
  ViewGrid grid{3, 2, {}};
  for (const Face& face : faces) {
    const int number = static_cast<int>(grid.views.size());
    View view = frame.view;
    view.forward = view.axis = face.axis;
    view.right = face.right;
    view.up = face.up;
    grid.views.push_back({view, number % 3, number / 3, face.name});
  }
  return grid;
}

}  // namespace tia
