// Meshes: the solids that they stand for, smooth normals, coordinates, degenerate triangles.
#include "core/accel/mesh/mesh_point.h"

#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/accel/meshes.h"

namespace tia {
namespace {

using namespace test;

// ---- the solids that meshes stand for ---------------------------------------------------------

TEST(Mesh, BoxOfTwelveTrianglesIsTheBox) {
  Random random(402);
  const Vec3d half{1, 0.5, 2};
  TransformSteps place;
  place.steps = {RotateDegrees{{10, 20, 30}}, Translate{{1, 2, 3}}};
  Scene scene;
  scene.objects = {object_of(box_mesh(half), place)};
  const World mesh = compile(scene);
  scene.objects = {object_of(Box{-half, half}, place)};
  const World box = compile(scene);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray<double> ray{random.point(5), random.direction()};
    const auto a = hit_of(mesh, ray), b = hit_of(box, ray);
    if (!(b.t < infinity)) {
      ASSERT_EQ(a.t, b.t);
      continue;
    }
    ++hits;
    ASSERT_NEAR(a.t, b.t, 1e-13 * (1 + b.t));
    const Vec3d p = ray.at(a.t);
    const Vec3d n = normals_at(mesh, p, 0, static_cast<int>(a.element), 0).ng;
    const Vec3d m = normals_at(box, p, 0, static_cast<int>(b.element), 0).ng;
    EXPECT_NEAR(dot(n, m), 1, 1e-14);
  }
  EXPECT_GT(hits, 100);
}

TEST(Mesh, BallOfTrianglesIsTheBallWithinItsFlatness) {
  // Edges span at most pi/2 / 2^4; a face's middle lies at most 1 - cos of the angle to its
  // corners, here below 0.12, under the sphere: 0.0072.
  Random random(403);
  Scene scene;
  scene.objects = {object_of(ball_mesh(4))};
  const World world = compile(scene);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d target = random.point(0.1), origin = random.direction() * 3.0;
    const Ray<double> ray{origin, normalize(target - origin)};
    const Vec3d p = ray.at(hit_of(world, ray).t);
    EXPECT_LE(length(p), 1 + 1e-12);
    EXPECT_GE(length(p), 1 - 0.0072);
  }
}

// ---- normals, coordinates, degenerate triangles -----------------------------------------------

TEST(Mesh, SmoothNormalsAreUnitAndThoseOfTheVerticesAtTheVertices) {
  Mesh ball = ball_mesh(2);
  for (const double x : ball.positions.values) ball.normals.values.push_back(x * 7);
  const MeshIndex mesh(ball);
  Random random(404);
  for (std::size_t t = 0; t < ball.triangles(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d p = mesh.corner(t, i);
      EXPECT_LT(length(point_of(mesh, t, p).n - p), 1e-14) << "the sphere's own";
    }
    const double u = random.unit(), v = random.unit() * (1 - u);
    const Vec3d p = mesh.corner(t, 0) * (1 - u - v) + mesh.corner(t, 1) * u + mesh.corner(t, 2) * v;
    const MeshPoint at = point_of(mesh, t, p);
    EXPECT_NEAR(length(at.n), 1, 1e-14);
    EXPECT_NEAR(length(at.ng), 1, 1e-14);
    // The sum of the corners weighed as p is of the unit corners: p itself, made unit.
    EXPECT_LT(length(at.n - normalize(p)), 1e-13);
    EXPECT_GT(dot(at.ng, p), 0) << "outwards";
    EXPECT_NEAR(at.uv.u, u, 1e-13) << "barycentric where there are none of its own";
    EXPECT_NEAR(at.uv.v, v, 1e-13);
  }
}

TEST(Mesh, UvsAreInterpolatedBetweenTheVertices) {
  Mesh triangle = mesh_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}});
  triangle.uvs.values = {0.25, 0.5, 1, 0.5, 0.25, -1};
  const MeshIndex mesh(triangle);
  EXPECT_EQ(point_of(mesh, 0, {0, 0, 0}).uv, (Vec2d{0.25, 0.5}));
  EXPECT_EQ(point_of(mesh, 0, {2, 0, 0}).uv, (Vec2d{1, 0.5}));
  EXPECT_EQ(point_of(mesh, 0, {0, 2, 0}).uv, (Vec2d{0.25, -1}));
  EXPECT_EQ(point_of(mesh, 0, {1, 1, 0}).uv, (Vec2d{0.625, -0.25}));
}

TEST(Mesh, SmoothNormalOfAMirroredMeshStillPointsOutwards) {
  Mesh ball = ball_mesh(2);
  ball.normals.values = ball.positions.values;
  TransformSteps mirror;
  mirror.steps = {Scale{Vec3d{-1, 2, 1}}};
  Scene scene;
  scene.objects = {object_of(ball, mirror)};
  const World world = compile(scene);
  Random random(405);
  for (int i = 0; i < 500; ++i) {
    const Vec3d origin = random.direction() * 5.0;
    const Ray<double> ray{origin, normalize(random.point(0.1) - origin)};
    const auto hit = hit_of(world, ray);
    const Normals at = normals_at(world, ray.at(hit.t), 0, static_cast<int>(hit.element), 0);
    EXPECT_LT(dot(at.ng, ray.direction), 0);
    EXPECT_GT(dot(at.n, at.ng), 0.8);
  }
}

TEST(Mesh, DegenerateTrianglesAreCountedAndChangeNothing) {
  const Mesh clean = ball_mesh(2);
  Mesh dirty = clean;
  auto& indices = dirty.indices.values;
  // Two corners alike, all alike, three on a line, each in the middle of the list.
  const auto n = static_cast<std::uint32_t>(dirty.vertices());
  dirty.positions.values.insert(dirty.positions.values.end(), {2, 0, 0, 3, 0, 0, 4.5, 0, 0});
  indices.insert(indices.begin() + 30, {0, 0, 1, 2, 2, 2, n, n + 1, n + 2});
  Scene scene;
  scene.objects = {object_of(clean)};
  const World without = compile(scene);
  scene.objects = {object_of(dirty)};
  const World with = compile(scene);
  EXPECT_EQ(without.degenerate, 0U);
  EXPECT_EQ(with.degenerate, 3U);
  Random random(406);
  for (int i = 0; i < 1000; ++i) {
    const Ray<double> ray{random.point(3), random.direction()};
    const auto a = hit_of(without, ray), b = hit_of(with, ray);
    ASSERT_EQ(a.t, b.t);
    EXPECT_EQ(b.element, a.element + (a.element < 10 ? 0 : 3)) << "numbered as the scene has them";
  }
  EXPECT_EQ(hit_of(with, Ray<double>{{4, 1, 0}, {0, -1, 0}}).t, infinity);
}

TEST(Mesh, OfDegenerateTrianglesAloneIsNeverHit) {
  Scene scene;
  scene.objects = {object_of(mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}))};
  const World world = compile(scene);
  EXPECT_EQ(world.degenerate, 1U);
  EXPECT_EQ(hit_of(world, Ray<double>{{0, 5, 0}, normalize(Vec3d{1, -4, 1})}).t, infinity);
}

TEST(Mesh, BothSpellingsOfItsNumbersAreOnePicture) {
  // 0, 1, 2 as uint32 and (-1,-1,-5) (1,-1,-5) (0,1,-5) as float32, little-endian.
  const auto scene = [](const std::string& positions, const std::string& indices) {
    return read_scene(R"({"objects":[{"type":"mesh","positions":)" + positions + R"(,"indices":)" +
                      indices + R"(}],"lights":[{"type":"point","position":[0,0,0]}]})");
  };
  const Scene numbers = scene("[-1,-1,-5,1,-1,-5,0,1,-5]", "[0,1,2]");
  const Scene bytes = scene(R"({"float32":"AACAvwAAgL8AAKDAAACAPwAAgL8AAKDAAAAAAAAAgD8AAKDA"})",
                            R"({"uint32":"AAAAAAEAAAACAAAA"})");
  const Image image = test::picture(numbers, 40, 30).image;
  EXPECT_EQ(test::bits_of(image), test::bits_of(test::picture(bytes, 40, 30).image));
  EXPECT_GT(image.at(20, 15)[0], 0.5F);
}

}  // namespace
}  // namespace tia
