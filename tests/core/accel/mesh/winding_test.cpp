// A mesh with vertex normals looks the same however its triangles are wound; a flat one is what its
// winding says.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/accel/meshes.h"

namespace tia {
namespace {

using test::bits_of;
using test::object_of;
using test::picture;
using test::Random;

constexpr int wound_width = 48, wound_height = 36;

// Every triangle the other way round, or the chosen ones. The first corner stays the first.
Mesh turned(Mesh mesh, const std::function<bool()>& is_turned) {
  auto& numbers = mesh.indices.values;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    if (is_turned()) std::swap(numbers[i + 1], numbers[i + 2]);
  return mesh;
}
Mesh turned(const Mesh& mesh) {
  return turned(mesh, [] { return true; });
}

void give_normals(Mesh& mesh, const std::function<Vec3d(const Vec3d&)>& normal_at) {
  for (std::size_t i = 0; i < mesh.vertices(); ++i) {
    const Vec3d n = normal_at(test::place(mesh, i));
    mesh.normals.values.insert(mesh.normals.values.end(), {n.x, n.y, n.z});
  }
}

// The ball of radius 1, wound to be seen from outside, whose normals lean by up to `lean`.
Mesh smooth_ball(Random& random, double lean) {
  Mesh mesh = test::ball_mesh(2);
  give_normals(mesh, [&](const Vec3d& p) { return p * 3.0 + random.point(lean); });
  return mesh;
}

Material random_finish(Random& random) {
  Finish finish;
  finish.color = test::random_color(random);
  finish.specular = random.unit();
  switch (random.below(3)) {
    case 0: finish.reflection = random.unit(); break;
    case 1:
      finish.transmission = random.unit();
      finish.fresnel = random.chance(0.5);
      finish.absorption = test::random_color(random);
      break;
    default: break;
  }
  return {finish};
}

// Balls and pyramids before a floor, some of them in groups that repeat or mirror them.
Scene scene_of_meshes(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.camera.location = {1, 2, 14};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.background = {0.3, 0.4, 0.6};
  scene.lights = {test::point_light({5, 9, 8}), test::sphere_light({-6, 7, 3}, 1)};
  scene.options.transparent_shadows = random.chance(0.5);
  for (int i = 0; i < 6; ++i) {
    const Vec3d center = random.point(3);
    Mesh mesh = smooth_ball(random, 1);
    if (random.chance(0.4)) {  // normals that disagree with each other
      mesh = test::random_mesh(random, {}, 1.5);
      mesh.normals.values.clear();
      give_normals(mesh, [&](const Vec3d&) { return random.direction(); });
    }
    Object object = object_of(mesh, test::random_placement(random, 1));
    object.transform.steps.push_back(Translate{center});
    object.material = random_finish(random);
    if (random.chance(0.3))
      object =
          object_of(Group{{object}, Repeat{{2, 1, 2}, {2.5, 0, -3}}}, {{Scale{Vec3d{1, -1, 0.7}}}});
    scene.objects.push_back(object);
  }
  scene.objects.push_back(object_of(Plane{{0, -4, 0}, {0, 1, 0}}));
  return scene;
}

void for_each_mesh(Object& object, const std::function<void(Mesh&)>& change) {
  if (auto* mesh = std::get_if<Mesh>(&object.shape)) change(*mesh);
  if (auto* group = std::get_if<Group>(&object.shape))
    for (Object& child : group->children) for_each_mesh(child, change);
}
Scene with_meshes(Scene scene, const std::function<void(Mesh&)>& change) {
  for (Object& object : scene.objects.edit()) for_each_mesh(object, change);
  return scene;
}

std::string explained(const Scene& scene, int x, int y) {
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  return to_json(Value(value_of(explain(
      scene, compile(scene), view_of(scene.camera, wound_width, wound_height), x, y, 0, options))));
}

TEST(Winding, ChangesNoBitOfAnyPictureWhereVerticesHaveNormals) {
  for (std::uint64_t seed = 950; seed < (test::sanitized() ? 952 : 960); ++seed) {
    Random random(seed);
    const Scene scene = scene_of_meshes(seed);
    const Scene back = with_meshes(scene, [](Mesh& mesh) { mesh = turned(mesh); });
    const Scene mixed = with_meshes(
        scene, [&](Mesh& mesh) { mesh = turned(mesh, [&] { return random.chance(0.5); }); });
    for (std::size_t i = 0; i < Names<IntegratorName>::names.size(); ++i) {
      RenderOptions options;
      options.integrator = static_cast<IntegratorName>(i);
      for (const Scalar scalar : {Scalar::wide, Scalar::exact}) {
        options.scalar = scalar;
        const auto bits = bits_of(picture(scene, wound_width, wound_height, options).image);
        EXPECT_TRUE(bits == bits_of(picture(back, wound_width, wound_height, options).image))
            << seed << i;
        EXPECT_TRUE(bits == bits_of(picture(mixed, wound_width, wound_height, options).image))
            << seed << i;
      }
    }
  }
}

TEST(Winding, ChangesNoByteOfAnExplanationWhereVerticesHaveNormals) {
  Random random(961);
  for (int i = 0; i < (test::sanitized() ? 5 : 60); ++i) {
    const Scene scene = scene_of_meshes(970 + static_cast<std::uint64_t>(i / 6));
    const int x = random.below(wound_width), y = random.below(wound_height);
    EXPECT_EQ(explained(scene, x, y),
              explained(with_meshes(scene, [](Mesh& mesh) { mesh = turned(mesh); }), x, y));
  }
}

// What the light is that a ray straight down sees of a smooth ball.
Vec3f seen_from_above(const Mesh& mesh) {
  Scene scene;
  scene.objects.push_back(object_of(mesh));
  scene.lights = {test::point_light({0, 9, 0})};
  return test::light_along(scene, {0.1, 5, 0.2}, {0, -1, 0});
}

TEST(Winding, LeavesNoBallBlack) {
  Random random(980);
  const Mesh ball = smooth_ball(random, 0);
  EXPECT_GT(seen_from_above(ball).x, 0.9F);
  EXPECT_EQ(seen_from_above(turned(ball)), seen_from_above(ball));
}

TEST(Winding, OutsideIsWhereTheVertexNormalsPoint) {
  Random random(981);
  for (const bool back : {false, true}) {
    const Mesh ball = smooth_ball(random, 0);
    const World world = test::world_of({object_of(back ? turned(ball) : ball)});
    const std::vector<Meeting> hits = all_hits(world, {{0.1, 5, 0.2}, {0, -1, 0}});
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_TRUE(hits[0].front);
    EXPECT_FALSE(hits[1].front);
  }
}

TEST(Winding, GeometricNormalIsOnTheSideOfTheInterpolatedOne) {
  Random random(982);
  int both_sides = 0;
  for (int i = 0; i < 200; ++i) {
    Mesh mesh = test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    give_normals(mesh, [&](const Vec3d&) { return random.direction(); });
    const TransformSteps place = test::random_placement(random, 1);
    const World world = test::world_of({object_of(mesh, place)});
    int up = 0;
    constexpr int points = 20;
    for (int k = 0; k < points; ++k) {
      const double x = random.unit(), y = (1 - x) * random.unit();
      const Normals at = normals_at(world, place.affine().point(Vec3d{x, y, 0}), 0, 0, 0);
      EXPECT_GE(dot(at.n, at.ng), 0);
      up += dot(at.ng, world.primitive(0).to_object.row(Vec3d{0, 0, 1})) > 0;
    }
    both_sides += up > 0 && up < points;
  }
  EXPECT_GT(both_sides, 20);
}

TEST(Winding, TellsTheFrontOfAFlatMesh) {
  for (const bool back : {false, true}) {
    const Mesh ball = test::ball_mesh(1);
    const World world = test::world_of({object_of(back ? turned(ball) : ball)});
    const std::vector<Meeting> hits = all_hits(world, {{0.1, 5, 0.2}, {0, -1, 0}});
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_EQ(hits[0].front, !back);
  }
}

}  // namespace
}  // namespace tia
