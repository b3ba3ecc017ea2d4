// Which side of a closed parametric surface is its outer one, as the description of v says.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/support.h"

namespace tia {
namespace {

// Whether a ray from afar meets the outer side of a sphere first.
bool is_outside_out(const char* x, const char* y, const char* z, const std::array<double, 2>& v) {
  Scene scene;
  scene.objects.push_back({"", Parametric{x, y, z, {0, 2 * pi}, v, {}}, {}, {}});
  return all_hits(compile(scene), {{0.2, 0.1, 9}, {0, 0, -1}}).front().front;
}

TEST(ParametricSide, VRunsUpFromOutsideWhereURunsToTheRight) {
  // Longitude u runs to the left here, where z is towards the viewer, so that latitude has to fall.
  EXPECT_FALSE(is_outside_out("cos(v)*cos(u)", "sin(v)", "cos(v)*sin(u)", {-1.5, 1.2}));
  EXPECT_TRUE(is_outside_out("cos(-v)*cos(u)", "sin(-v)", "cos(-v)*sin(u)", {-1.2, 1.5}));
  EXPECT_TRUE(is_outside_out("cos(v)*sin(u)", "sin(v)", "cos(v)*cos(u)", {-1.5, 1.2}));
}

}  // namespace
}  // namespace tia
