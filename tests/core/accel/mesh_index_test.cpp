// Meshes: watertight at edges and vertices, smooth, and the solids that they stand for.
#include "core/accel/mesh_index.h"

#include <gtest/gtest.h>

#include <map>

#include "core/accel/all_hits.h"
#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::hit_of;
using test::lane_of;
using test::object_of;
using test::Random;
using test::ray_in;

#if defined(__SANITIZE_ADDRESS__)
constexpr int rays_a_mesh = 400;
#else
constexpr int rays_a_mesh = 4000;
#endif

using Triple = std::array<std::uint32_t, 3>;

Mesh mesh_of(const std::vector<Vec3d>& places, const std::vector<Triple>& triangles) {
  Mesh mesh;
  for (const Vec3d& p : places)
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
  for (const Triple& t : triangles)
    mesh.indices.values.insert(mesh.indices.values.end(), t.begin(), t.end());
  return mesh;
}
Vec3d place(const Mesh& mesh, std::size_t i) {
  const auto& v = mesh.positions.values;
  return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
}

// A box of twelve triangles, all wound to be seen from outside.
Mesh box_mesh(const Vec3d& half) {
  std::vector<Vec3d> places;
  for (unsigned i = 0; i < 8; ++i)
    places.push_back(half * Vec3d{i & 1U ? 1.0 : -1, i & 2U ? 1.0 : -1, i & 4U ? 1.0 : -1});
  return mesh_of(places, {{0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6}});
}

// An octahedron whose faces are cut in four, again and again, the vertices moved onto the unit
// sphere.
Mesh ball_mesh(int times) {
  std::vector<Vec3d> places{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triple> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                            {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, added] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                   static_cast<std::uint32_t>(places.size()));
      if (added) places.push_back(normalize(places[a] + places[b]));
      return at->second;
    };
    std::vector<Triple> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    faces = finer;
  }
  return mesh_of(places, faces);
}

// A bipyramid of n needles around an axis.
Mesh needles(int n) {
  std::vector<Vec3d> places{{0, 1, 0}, {0, -1, 0}};
  std::vector<Triple> faces;
  for (int i = 0; i < n; ++i) {
    const double turn = 360.0 * i / n;
    places.push_back({cos_degrees(turn), 0, sin_degrees(turn)});
    const auto a = static_cast<std::uint32_t>(2 + i),
               b = static_cast<std::uint32_t>(2 + (i + 1) % n);
    faces.insert(faces.end(), {{0, b, a}, {1, a, b}});
  }
  return mesh_of(places, faces);
}

// Some way along one of the mesh's edges, at one of its ends one time in three.
Vec3d point_of_edge(const Mesh& mesh, Random& random) {
  const auto triangle = static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles())));
  const auto corner = static_cast<std::size_t>(random.below(3));
  const auto& indices = mesh.indices.values;
  const Vec3d a = place(mesh, indices[3 * triangle + corner]);
  const Vec3d b = place(mesh, indices[3 * triangle + (corner + 1) % 3]);
  return random.chance(1.0 / 3) ? a : a + (b - a) * random.unit();
}

struct Closed {
  const char* name;
  Mesh mesh;
};
std::vector<Closed> closed_meshes() {
  return {{"box", box_mesh({1, 1, 1})},
          {"flat box", box_mesh({1, 1e-3, 1})},
          {"ball", ball_mesh(3)},
          {"needles", needles(200)}};
}

// ---- watertight -------------------------------------------------------------------------------

// From inside, a closed mesh is hit in every direction; 4 meshes, 3 scales, with and without
// transforms, 4000 rays each: 10^5 in all, in each of the three widths.
TEST(Mesh, RaysAtEdgesAndVerticesFromInsideNeverLeak) {
  Random random(400);
  for (const Closed& closed : closed_meshes()) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      for (const bool moved : {false, true}) {
        SCOPED_TRACE(closed.name);
        Placement placement;
        placement.steps = {Scale{scale}};
        if (moved)
          placement.steps = {Scale{Vec3d{2, -0.5, 0.7}}, RotateDegrees{{20, 30, 40}}, Scale{scale},
                             Translate{Vec3d{3, -4, 5} * scale}};
        Scene scene;
        scene.objects = {object_of(closed.mesh, placement)};
        const World world = compile(scene);
        const Affine map = placement.affine();
        for (int i = 0; i < rays_a_mesh / lanes<Wide>; ++i) {
          const Vec3d origin = map.point(random.point(2e-4));
          std::vector<Ray<float>> rays;
          for (int k = 0; k < lanes<Wide>; ++k) {
            const Vec3d target = map.point(point_of_edge(closed.mesh, random));
            const Ray<double> ray{origin, normalize(target - origin)};
            rays.push_back(ray_in<float>(ray));
            ASSERT_LT(hit_of(world, ray).t, infinity);
            ASSERT_LT(hit_of(world, rays.back()).t, infinity);
          }
          const Hit<Wide> hits = hit_of(world, test::packed(rays));
          for (int k = 0; k < lanes<Wide>; ++k) {
            const Hit<float> alone = hit_of(world, rays[static_cast<std::size_t>(k)]);
            ASSERT_EQ(test::all_of(lane_of(hits, k)), test::all_of(alone));
          }
        }
      }
    }
  }
}

// From outside, a ray at an edge that faces it meets the near side: not later than the edge. Along
// the axes too, where coordinates across the ray are whole numbers.
TEST(Mesh, RaysAtEdgesAndVerticesFromOutsideNeverPassThroughTheNearSide) {
  Random random(401);
  for (const Closed& closed : closed_meshes()) {
    SCOPED_TRACE(closed.name);
    Scene scene;
    scene.objects = {object_of(closed.mesh)};
    const World world = compile(scene);
    for (int i = 0; i < rays_a_mesh; ++i) {
      const Vec3d target = point_of_edge(closed.mesh, random);
      // Towards a point well inside, through the edge: all that is seen faces the ray.
      const Vec3d within = random.point(2e-4);
      const Vec3d origin = target + (target - within) * random.in(0.5, 5);
      const Ray<double> ray{origin, normalize(within - origin)};
      const double t = length(target - origin);
      ASSERT_LE(hit_of(world, ray).t, t * (1 + 1e-9));
      ASSERT_LE(double(hit_of(world, ray_in<float>(ray)).t), t * (1 + 1e-3));
    }
  }
}

TEST(Mesh, AxisParallelRayThroughAVertexHits) {
  Scene scene;
  scene.objects = {object_of(ball_mesh(2))};
  const World world = compile(scene);
  for (const Vec3d& way : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
    for (const double sign : {-1.0, 1.0}) {
      const Ray<double> ray{way * (sign * 5), way * -sign};
      EXPECT_EQ(hit_of(world, ray).t, 4);
      EXPECT_EQ(hit_of(world, ray_in<float>(ray)).t, 4);
      EXPECT_EQ(hit_of(world, Ray<double>{{0, 0, 0}, way * sign}).t, 1);
    }
}

TEST(Mesh, EdgeThatTwoTrianglesShareIsOneCrossingOfAll) {
  Scene scene;
  scene.objects = {object_of(box_mesh({1, 1, 1}))};
  const World world = compile(scene);
  // Through both diagonals' middles, along z.
  const auto hits = all_hits(world, {{0, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].t, 4);
  EXPECT_EQ(hits[1].t, 6);
  EXPECT_EQ(hits[0].normal, (Vec3d{0, 0, 1}));
  EXPECT_TRUE(hits[0].front);
  EXPECT_FALSE(hits[1].front);
}

// ---- the solids that meshes stand for ---------------------------------------------------------

TEST(Mesh, BoxOfTwelveTrianglesIsTheBox) {
  Random random(402);
  const Vec3d half{1, 0.5, 2};
  Placement place;
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
  Placement mirror;
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
