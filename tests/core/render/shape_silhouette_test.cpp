// Outlines of all shapes against closed forms, by parallel rays: a shape's area is the area of the
// pixels that show it, to within the pixels that its outline passes.
#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::picture;

const double pi_here = std::acos(-1.0);

struct Outline {
  std::string name, shape;  // JSON members of the object
  Vec3d towards;            // the way the parallel rays run
  double area, perimeter;
};

// The picture's height in scene units; its pixels are squares.
constexpr double frame_height = 8;
constexpr int frame_pixels = 256;

Scene scene_of(const Outline& outline, double scale) {
  Scene scene = read_scene(R"({"background": 1, "objects": [{)" + outline.shape + "}]}");
  scene.objects.front().transform.steps.push_back(Scale{scale});
  scene.camera.location = outline.towards * (-20 * scale);
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.camera.up = std::fabs(outline.towards.y) > 0.9 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = frame_height * scale;
  return scene;
}

Vec3d unit_of(const Vec3d& v) { return v * (1 / std::sqrt(dot(v, v))); }

std::vector<Outline> outlines() {
  const Vec3d z{0, 0, -1}, y{0, -1, 0}, oblique = unit_of({0.3, -0.5, -1});
  const double R = 2, r = 0.7;
  // A box's shadow is half the sum of its faces' shadows; a box of 2 x 3 x 1.
  const Vec3d d{std::fabs(oblique.x), std::fabs(oblique.y), std::fabs(oblique.z)};
  const double box = 3 * 1 * d.x + 2 * 1 * d.y + 2 * 3 * d.z;
  // A cylinder of radius 1 and height 3 about y, seen at an angle a to its axis: the side's
  // rectangle 2 r h sin a, and the two halves of the cap's ellipse, pi r^2 cos a.
  const double cosine = d.y, sine = std::sqrt(1 - cosine * cosine);
  // The ellipse of a disc seen at an angle.
  const Vec3d disc_normal = unit_of({0.4, 0.2, 1});
  const double tilt = std::fabs(dot(disc_normal, z));
  return {
      {"sphere", R"("type":"sphere","center":[0.3,-0.2,0.5],"radius":1.7)", oblique,
       pi_here * 1.7 * 1.7, 2 * pi_here * 1.7},
      {"box", R"("type":"box","min":[-1,-1.5,-0.5],"max":[1,1.5,0.5])", z, 6, 10},
      {"box, oblique", R"("type":"box","min":[-1,-1.5,-0.5],"max":[1,1.5,0.5])", oblique, box, 12},
      {"torus along its axis", R"("type":"torus","major_radius":2,"minor_radius":0.7)", y,
       pi_here * ((R + r) * (R + r) - (R - r) * (R - r)), 4 * pi_here * R},
      {"torus edge-on", R"("type":"torus","major_radius":2,"minor_radius":0.7)", z,
       4 * R * r + pi_here * r * r, 4 * R + 2 * pi_here * r},
      {"disc", R"("type":"disc","center":[0,0,0],"normal":[0.4,0.2,1],"radius":2)", z,
       4 * pi_here * tilt, 4 * pi_here},
      {"cylinder from its side",
       R"("type":"cylinder","base":[0,-1.5,0],"cap":[0,1.5,0],"radius":1)", z, 6, 10},
      {"cylinder, oblique", R"("type":"cylinder","base":[0,-1.5,0],"cap":[0,1.5,0],"radius":1)",
       oblique, 6 * sine + pi_here * cosine, 2 * pi_here + 6},
      {"cone from its side",
       R"("type":"cone","base":[0,-1.5,0],"base_radius":1.2,"cap":[0,1.5,0],"cap_radius":0.4)", z,
       (1.2 + 0.4) * 3, 10},
      {"triangle", R"("type":"triangle","a":[-1,-1,0],"b":[2,-1,1],"c":[0,2,-1])", z, 4.5, 10},
      {"mesh", R"("type":"mesh","positions":[-1,-1,0, 2,-1,0, 2,2,0, -1,2,0],
                  "indices":[0,1,2,0,2,3])",
       z, 9, 12},
      {"ellipsoid as a quadric", R"("type":"quadric",
          "coefficients":[1,0.25,1,0,0,0,0,0,0,-1],"bounds":{"center":[0,0,0],"radius":3})",
       z, 2 * pi_here, 10},
      {"sphere as an algebraic surface", R"("type":"algebraic",
          "terms":[[2,0,0,1],[0,2,0,1],[0,0,2,1],[0,0,0,-4]])",
       oblique, 4 * pi_here, 4 * pi_here},
      {"two balls of a group", R"("type":"group","repeat":{"count":[2,1,1],"step":[3,0,0]},
          "children":[{"type":"sphere","center":[-1.5,0,0],"radius":1}])",
       z, 2 * pi_here, 4 * pi_here},
      {"a drilled plate", R"("type":"csg","operation":"difference","children":[
          {"type":"box","min":[-2,-2,-0.2],"max":[2,2,0.2]},
          {"type":"cylinder","base":[0,0,-1],"cap":[0,0,1],"radius":1}])",
       z, 16 - pi_here, 16 + 2 * pi_here},
  };
}

TEST(ShapeSilhouette, HasTheClosedFormsAreaAtEveryScale) {
  for (const Outline& outline : outlines()) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      if (test::sanitized() && scale != 1) continue;
      const Image image = picture(scene_of(outline, scale), frame_pixels, frame_pixels).image;
      int black = 0;
      for (int y = 0; y < frame_pixels; ++y)
        for (int x = 0; x < frame_pixels; ++x) black += image.at(x, y)[0] == 0;
      const double side = frame_height / frame_pixels;
      // A curve passes fewer pixels than 2 length / side + 4, and their centres lie on either side
      // of it like tosses of a coin: three deviations of as many, and a pixel's width of the
      // straight edges, which lie along the raster.
      const double passed = 2 * outline.perimeter / side + 4;
      const double slack =
          (3 * std::sqrt(passed) / 2 + outline.perimeter / side * 0.51) * side * side;
      EXPECT_NEAR(black * side * side, outline.area, slack) << outline.name << " at " << scale;
      EXPECT_LT(slack, 0.06 * outline.area) << outline.name << ": too loose to tell";
    }
  }
}

TEST(ShapeSilhouette, TheHugeFloorSpheresDistancesAreTheClosedForm) {
  // From height h above a ball of radius R, a ray that dips by the sine s meets it at
  // t = b - sqrt(b^2 - c), b = (R + h) s, c = (R + h)^2 - R^2 = h (2 R + h).
  Scene scene = read_scene(R"({"objects":[
      {"type":"sphere","center":[0,-10004,-20],"radius":10000}], "camera": {"fov_degrees": 25}})");
  scene.camera.location = {0, 0, -20};
  const int w = 64, h = 48;
  RenderOptions options;
  options.integrator = IntegratorName::depth;
  const Image image = picture(scene, w, h, options).image;
  const View view = view_of(scene.camera, w, h);
  int hits = 0;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const Vec3d d = view.ray<double>(x, y).direction;
      const long double s = -static_cast<long double>(d.y), b = 10004 * s, c = 4.0L * 20004;
      if (b <= 0 || b * b < c * 1.001L) continue;
      ++hits;
      const long double t = c / (b + std::sqrt(b * b - c));
      // A float direction is off by 6e-8, and its foot on the floor by that over the sine of the
      // angle at which the ray meets it.
      const double slope = static_cast<double>(std::sqrt(b * b - c) / 10000);
      EXPECT_NEAR(image.at(x, y)[0] / static_cast<double>(t), 1, 3e-7 / slope) << x << ", " << y;
    }
  }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace tia
