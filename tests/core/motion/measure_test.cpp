// Volumes, centres of mass and moments of inertia against each other: closed forms against meshes.
#include "core/motion/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/motion/inertia.h"
#include "core/motion/rigid_part.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

Shape shape_of(const std::string& fields) {
  return read_scene(R"({"objects":[{)" + fields + "}]}").objects[0].shape;
}
void expect_measure(const std::string& fields, double volume, const Vec3d& center) {
  SCOPED_TRACE(fields);
  const auto found = measure_of(shape_of(fields));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->volume, volume, 1e-12 * volume);
  EXPECT_NEAR(length(found->center - center), 0, 1e-12);
}

TEST(Measure, OfSolidsIsTheTextbooks) {
  expect_measure(R"("type":"sphere","center":[1,2,3],"radius":2)", 32 * pi / 3, {1, 2, 3});
  expect_measure(R"("type":"box","min":[0,0,0],"max":[1,2,4])", 8, {0.5, 1, 2});
  expect_measure(R"("type":"cylinder","base":[0,0,0],"cap":[0,3,0],"radius":2)", 12 * pi,
                 {0, 1.5, 0});
  expect_measure(R"("type":"cone","base":[0,0,0],"cap":[0,3,0],"base_radius":2)", 4 * pi,
                 {0, 0.75, 0});
  // The cone of height 6 less its upper half: 8 pi - pi; (8 1.5 - 1 3.75) / 7 above the base.
  expect_measure(R"("type":"cone","base":[0,0,0],"cap":[0,3,0],"base_radius":2,"cap_radius":1)",
                 7 * pi, {0, (8 * 1.5 - 3.75) / 7, 0});
  expect_measure(R"("type":"capsule","base":[0,0,0],"cap":[0,3,0],"radius":1)", 3 * pi + 4 * pi / 3,
                 {0, 1.5, 0});
  expect_measure(R"("type":"torus","major_radius":3,"minor_radius":0.5)", 1.5 * pi * pi, {});
  // A tetrahedron, wound either way.
  for (const char* indices : {"[0,2,1,0,1,3,1,2,3,2,0,3]", "[0,1,2,0,3,1,1,3,2,2,3,0]"})
    expect_measure(
        std::string(R"("type":"mesh","positions":[0,0,0,1,0,0,0,1,0,0,0,1],"indices":)") + indices,
        1.0 / 6, {0.25, 0.25, 0.25});
}

TEST(Measure, OfWhatIsOpenThereIsNone) {
  EXPECT_FALSE(measure_of(shape_of(R"("type":"plane","point":[0,0,0],"normal":[0,1,0])")));
  EXPECT_FALSE(
      measure_of(shape_of(R"("type":"disc","center":[0,0,0],"normal":[0,1,0],"radius":1)")));
  EXPECT_FALSE(measure_of(shape_of(
      R"("type":"mesh","positions":[0,0,0,1,0,0,0,1,0,0,0,1],"indices":[0,2,1,0,1,3,1,2,3])")));
}

// Of a box as triangles, turned at random, against m/3 of the squares of its half edges.
TEST(Inertia, OfATurnedBoxIsThatOfTheBox) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-2, 2);
  for (int round = 0; round < 50; ++round) {
    const Vec3d half{0.5 + std::abs(at(random)), 0.5 + std::abs(at(random)),
                     0.5 + std::abs(at(random))};
    const Affine place = Affine::translation({at(random), at(random), at(random)}) *
                         rotation_of({at(random), at(random), at(random), at(random)});
    std::vector<Vec3d> points;
    for (unsigned k = 0; k < 8; ++k)
      points.push_back(
          place.point(Vec3d{(k & 1U) != 0 ? half.x : -half.x, (k & 2U) != 0 ? half.y : -half.y,
                            (k & 4U) != 0 ? half.z : -half.z}));
    const Inertia found = mesh_inertia(3, points,
                                       {{0, 2, 3},
                                        {0, 3, 1},
                                        {4, 5, 7},
                                        {4, 7, 6},
                                        {0, 1, 5},
                                        {0, 5, 4},
                                        {2, 6, 7},
                                        {2, 7, 3},
                                        {0, 4, 6},
                                        {0, 6, 2},
                                        {1, 3, 7},
                                        {1, 7, 5}});
    EXPECT_NEAR(length(found.frame.offset - place.offset), 0, 1e-12);
    EXPECT_NEAR(found.frame.determinant(), 1, 1e-12);
    // The tensors as maps of vectors: R diag(moments) R^T.
    const auto tensor = [](const Affine& frame, const Vec3d& moments, const Vec3d& v) {
      return frame.vector(moments * frame.row(v));
    };
    const Vec3d v{at(random), at(random), at(random)};
    const Vec3d expected = tensor(place, box_moments(3, half), v);
    EXPECT_NEAR(length(tensor(found.frame, found.moments, v) - expected), 0,
                1e-10 * length(expected));
  }
}

// Cylinder, cone and capsule as sums of thin discs: m (3 r^2 + h^2) / 12 about a diameter, r^2 / 2
// about the axis.
TEST(Inertia, OfTurnedSolidsIsThatOfTheirSlices) {
  const auto sliced = [](double from, double to, double middle, const auto& radius_at) {
    constexpr int slices = 20'000;
    double mass = 0;
    Vec3d sum{};
    for (int i = 0; i < slices; ++i) {
      const double h = (to - from) / slices, y = from + (i + 0.5) * h, r = radius_at(y);
      const double disc = pi * r * r * h, off = y - middle;
      const double across = disc * (r * r / 4 + h * h / 12 + off * off);
      sum = sum + Vec3d{across, disc * r * r / 2, across};
      mass += disc;
    }
    return sum * (1 / mass);
  };
  const auto expect_near = [](const Vec3d& got, const Vec3d& expected) {
    EXPECT_NEAR(length(got - expected), 0, 1e-6 * length(expected));
  };
  expect_near(cylinder_moments(1, 0.5, 2), sliced(-1, 1, 0, [](double) { return 0.5; }));
  expect_near(cone_moments(1, 0.5, 2), sliced(0, 2, 0.5, [](double y) { return 0.25 * (2 - y); }));
  expect_near(capsule_moments(1, 0.5, 2), sliced(-1.5, 1.5, 0, [](double y) {
                const double beyond = std::max(0.0, std::abs(y) - 1);
                return std::sqrt(0.25 - beyond * beyond);
              }));
  expect_near(sphere_moments(1, 0.5),
              sliced(-0.5, 0.5, 0, [](double y) { return std::sqrt(0.25 - y * y); }));
}

}  // namespace
}  // namespace tia
