// What is put into the state of the next moment shows what is built from nothing, bit for bit.
#include "core/accel/world/refit_geometry.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/film/film.h"
#include "core/render/render.h"
#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::object_of;
using test::Random;

Scene lit_scene(Random& random, int objects) {
  Scene scene = test::mixed_scene(random, objects, 1);
  scene.camera.location = {0, 2, 25};
  scene.camera.look_at = Vec3d{};
  scene.lights = {test::point_light({-9, 9, 9})};
  return scene;
}

std::vector<float> pixels_of(const Scene& scene, const SharedGeometry& objects) {
  constexpr int width = 40, height = 30;
  LinearFilm film(width, height);
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  Pool pool(1);
  render(compile(scene, objects), view_of(scene.camera, width, height), {0, 0, width, height},
         options, pool, {}, [&](const FilmTile& tile) { film.put(tile); });
  return film.image().rgb;
}

void expect_shows_the_scene(const std::shared_ptr<Geometry>& geometry, const Scene& scene) {
  EXPECT_EQ(pixels_of(scene, geometry),
            pixels_of(scene, std::make_shared<const Geometry>(geometry_of(scene))));
}

// A ball, a box, a ball that is stretched, one in a turned group, a disc and a plane, among balls.
std::vector<std::size_t> add_movers(Scene& scene) {
  const Object inner = object_of(Sphere{{1, 0, 0}, 0.5}, {{RotateDegrees{{0, 30, 0}}}});
  const std::vector<Object> movers{object_of(Sphere{{0, 0, 0}, 1}),
                                   object_of(Box{{0, 0, 0}, {1, 2, 1}}),
                                   object_of(Sphere{{0, 0, 0}, 1}, {{Scale{Vec3d{1, 2, 1}}}}),
                                   object_of(Group{{inner}, {}}),
                                   object_of(Disc{{0, 0, 0}, {0, 1, 1}, 2}),
                                   object_of(Plane{{0, -9, 0}, {0, 1, 0}})};
  std::vector<std::size_t> moved;
  for (const Object& each : movers) {
    scene.objects.push_back(object_of(Sphere{{0, 7, 0}, 0.3}));
    moved.push_back(scene.objects.size());
    scene.objects.push_back(each);
  }
  return moved;
}

TEST(Refit, AgainAndAgainShowsWhatAFreshGeometryDoes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    Scene scene = lit_scene(random, 30);
    const std::vector<std::size_t> moved = add_movers(scene);
    const auto geometry = std::make_shared<Geometry>(geometry_of(scene));
    for (int round = 0; round < test::rounds(6, 3); ++round) {
      for (const std::size_t each : moved)
        scene.objects[each].transform.steps.push_back(Translate{random.point(3)});
      ASSERT_TRUE(refit(*geometry, scene, moved)) << seed << ' ' << round;
      expect_shows_the_scene(geometry, scene);
    }
  }
}

// Where the world's origin leaves, an object is of another kind, or begins to glow.
TEST(Refit, IsRefusedWhereTheGeometryHasToBeBuiltAnew) {
  const auto fits = [](const std::function<void(Object&)>& change, int others = 9) {
    Random random(5);
    Scene scene = lit_scene(random, others);
    scene.objects.push_back(object_of(Sphere{{0, 3, 0}, 1}));
    Geometry geometry = geometry_of(scene);
    const std::size_t last = scene.objects.size() - 1;
    change(scene.objects[last]);
    return refit(geometry, scene, {last});
  };
  EXPECT_TRUE(fits([](Object& object) { object.shape = Sphere{{2, 3, 0}, 0.5}; }));
  const auto far = [](Object& object) { object.shape = Sphere{{1e6, 3, 0}, 1}; };
  EXPECT_TRUE(fits(far));
  EXPECT_FALSE(fits(far, 0));
  EXPECT_FALSE(fits([](Object& object) { object.shape = Box{{0, 3, 0}, {1, 4, 1}}; }));
  EXPECT_FALSE(fits([](Object& object) { object.shape = Csg{}; }));
  EXPECT_FALSE(fits([](Object& object) {
    object.material = Boxed<Material>(test::matte({1, 1, 1}, {1, 1, 1}));
  }));
}

}  // namespace
}  // namespace tia
