// The picture of what is framed, as the integrator `object` draws it.
#include "tests/core/integrators/paths.h"
#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

struct ObjectMask {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};
ObjectMask mask_of(const Image& image) {
  ObjectMask mask;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (*image.at(x, y) > 0) {
        mask.left = std::min(mask.left, x), mask.right = std::max(mask.right, x);
        mask.top = std::min(mask.top, y), mask.bottom = std::max(mask.bottom, y);
      }
  return mask;
}
Mesh tetrahedron(const StillPoints& points) {
  return mesh_of(points.corners, {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3});
}

// Drawn at eight times the size of what is compared, so that a pixel of that is what a tip may
// miss.
TEST(StillFraming, MasksTouchTheFrameWithinAPixel) {
  Random random(2209);
  constexpr int fine = 8, pixels = 32;
  for (int i = 0; i < 12; ++i) {
    const StillPoints points = cloud(random, 4);
    StillFrame frame = random_frame(random, i % 3 == 0 ? 0 : random.in(10, 60));
    frame.aspect = i % 2 == 0 ? 2 : 0.5;
    const int width = i % 2 == 0 ? 2 * pixels : pixels, height = i % 2 == 0 ? pixels : 2 * pixels;
    Scene scene;
    scene.camera = framed(points, frame);
    scene.objects = {object(tetrahedron(points), {})};
    RenderOptions options;
    options.integrator = IntegratorName::object;
    const ObjectMask mask = mask_of(picture(scene, width * fine, height * fine, options).image);
    const SeenBox seen = seen_box(points, scene.camera, frame.aspect);
    const auto side = [&](double at, int size) { return (at + 1) / 2 * size; };
    const auto is_at = [&](int column, double at, int size) {
      EXPECT_NEAR(static_cast<double>(column) / fine, side(at, size), 1);
    };
    is_at(mask.left, seen.left, width), is_at(mask.right + 1, seen.right, width);
    is_at(mask.top, -seen.up, height), is_at(mask.bottom + 1, -seen.down, height);
    const bool wide = seen.across() > seen.along();
    is_at(wide ? mask.left : mask.top, -0.9, wide ? width : height);
    is_at((wide ? mask.right : mask.bottom) + 1, 0.9, wide ? width : height);
  }
}

}  // namespace
}  // namespace tia
