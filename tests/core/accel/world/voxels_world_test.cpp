// Voxels in the world: their numbered materials wherever primitives are told apart, alone, in
// solids, in groups and in pictures.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/accel/worlds.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using namespace test;

const std::vector<Color> cell_colors{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Object voxels_of(const Voxels& shape) {
  Object object;
  object.shape = shape;
  object.material = matte({0.5, 0.5, 0.5});
  if (!shape.occupied.has_materials()) return object;
  std::vector<MaterialRef> materials;
  for (const Color& color : cell_colors) materials.emplace_back(matte(color));
  object.materials = std::move(materials);
  return object;
}

// A random grid of three materials around the origin, and its cells as boxes of their own.
struct Model {
  Object voxels;
  std::vector<Object> boxes;
};
Model random_model(Random& random, double share) {
  Voxels v;
  v.origin = {-3, -2, -2.5};
  v.size = {6, 4, 5};
  v.occupied.width = 4;
  Model model;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 6; ++i) {
        if (!random.chance(share)) continue;
        const int material = 1 + random.below(3);
        v.occupied.numbers.insert(v.occupied.numbers.end(), {i, j, k, material});
        const Vec3d low = v.origin + Vec3d{double(i), double(j), double(k)};
        Object box;
        box.shape = Box{low, low + Vec3d{1, 1, 1}};
        box.material = matte(cell_colors[static_cast<std::size_t>(material - 1)]);
        model.boxes.push_back(box);
      }
  model.voxels = voxels_of(v);
  return model;
}

Scene scene_of(const std::vector<Object>& objects) {
  Scene scene;
  scene.objects = objects;
  scene.lights = {point_light({7, 9, 11})};
  scene.camera.location = {5, 6, 9};
  scene.camera.look_at = Vec3d{0, 0, 0};
  return scene;
}
Object sphere_of(const Vec3d& center, double radius) {
  return ball(center, radius, matte({1, 1, 0}));
}

Ray<double> ray_at(Random& random) {
  const Vec3d origin = random.direction() * 12.0;
  return {origin, normalize(random.point(2) - origin)};
}

TEST(VoxelsWorld, CellsWearTheMaterialsOfTheirNumbers) {
  Random random(110);
  int hits = 0;
  for (int i = 0; i < 50; ++i) {
    const Model model = random_model(random, random.in(0.1, 0.9));
    const World voxels = compile(scene_of({model.voxels})), boxes = compile(scene_of(model.boxes));
    for (int k = 0; k < 100; ++k) {
      const Ray<double> ray = ray_at(random);
      const Hit<double> got = hit_of(voxels, ray), expected = hit_of(boxes, ray);
      ASSERT_EQ(got.t < 1e9, expected.t < 1e9);
      if (!(got.t < 1e9)) continue;
      ASSERT_NEAR(got.t, expected.t, 1e-12);
      const int primitive = static_cast<int>(got.primitive);
      EXPECT_EQ(voxels.shading_of(primitive).albedo.exact,
                boxes.shading_of(static_cast<int>(expected.primitive)).albedo.exact);
      EXPECT_EQ(voxels.primitive(primitive).object, 0);
      ++hits;
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(VoxelsWorld, PicturesAreThoseOfTheBoxes) {
  // Shadows and mirrors included; but for pixels on edges that two materials share.
  Random random(111);
  for (int i = 0; i < 5; ++i) {
    const Model model = random_model(random, 0.4);
    Object mirror;
    mirror.shape = Plane{{0, -2.5, 0}, {0, 1, 0}};
    mirror.material = matte({0.2, 0.2, 0.2});
    std::get<Finish>(std::get<Boxed<Material>>(*mirror.material)->kind).reflection = 0.5;
    std::vector<Object> boxes = model.boxes;
    boxes.push_back(mirror);
    const Image a = picture(scene_of({model.voxels, mirror}), 80, 60).image;
    const Image b = picture(scene_of(boxes), 80, 60).image;
    int different = 0;
    for (std::size_t k = 0; k < a.rgb.size(); ++k)
      different += std::fabs(a.rgb[k] - b.rgb[k]) > 1e-3F;
    EXPECT_LT(different, 3 * 20);
  }
}

TEST(VoxelsWorld, CellsWithoutNumbersWearTheObjectsMaterial) {
  Voxels v;
  v.occupied = {3, {0, 0, 0}};
  const World world = compile(scene_of({voxels_of(v)}));
  const Hit<double> hit = hit_of(world, Ray<double>{{0.5, 0.5, 9}, {0, 0, -1}});
  EXPECT_EQ(hit.t, 8);
  EXPECT_EQ(world.shading_of(static_cast<int>(hit.primitive)).albedo.exact, (Vec3d{0.5, 0.5, 0.5}));
}

TEST(VoxelsWorld, ThePartsOfOneObjectAreOneObject) {
  Random random(112);
  const World world =
      compile(scene_of({random_model(random, 0.5).voxels, sphere_of({20, 0, 0}, 1)}));
  EXPECT_EQ(world.objects, 2);
  const Hit<double> hit = hit_of(world, Ray<double>{{20, 0, 9}, {0, 0, -1}});
  EXPECT_EQ(world.primitive(static_cast<int>(hit.primitive)).object, 1);
}

TEST(VoxelsWorld, AllHitsNameEachCellsMaterial) {
  Voxels v;
  v.size = {5, 1, 1};
  v.occupied = {2, {1, 1, 1, 0, 1, 2, 1, 3}};
  const World world = compile(scene_of({voxels_of(v)}));
  const auto hits = all_hits(world, {{-1, 0.5, 0.5}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 4U);
  const std::vector<double> at{1, 2, 3, 5};
  const std::vector<int> numbers{1, 1, 2, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(hits[i].t, at[i]);
    EXPECT_EQ(hits[i].primitive, numbers[i]);
    EXPECT_EQ(hits[i].normal, (Vec3d{i % 2 == 0 ? -1.0 : 1.0, 0, 0}));
  }
}

// ---- solids ---------------------------------------------------------------------------------

Object csg_of(Operation operation, const Object& a, const Object& b) {
  Csg csg;
  csg.operation = operation;
  csg.children = {a, b};
  Object object;
  object.shape = csg;
  return object;
}

TEST(VoxelsWorld, InSolidsTheyAreTheUnionOfTheirCells) {
  Random random(113);
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    const Model model = random_model(random, 0.5);
    Csg cells;
    cells.children = model.boxes;
    Object boxes;
    boxes.shape = cells;
    const Object sphere = sphere_of(random.point(2), random.in(1, 3));
    const auto operation = static_cast<Operation>(random.below(3));
    const bool first = random.chance(0.5);
    const auto world_with = [&](const Object& solid) {
      return compile(
          scene_of({first ? csg_of(operation, solid, sphere) : csg_of(operation, sphere, solid)}));
    };
    const World voxels = world_with(model.voxels), expected = world_with(boxes);
    for (int k = 0; k < 50; ++k) {
      const Ray<double> ray = ray_at(random);
      const auto a = all_hits(voxels, ray), b = all_hits(expected, ray);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t n = 0; n < a.size(); ++n) {
        EXPECT_NEAR(a[n].t, b[n].t, 1e-11);
        EXPECT_EQ(voxels.shading_of(a[n].primitive).albedo.exact,
                  expected.shading_of(b[n].primitive).albedo.exact);
        EXPECT_NEAR(dot(a[n].normal, b[n].normal), 1, 1e-12);
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 3000);
}

TEST(VoxelsWorld, CopiesOfAGroupWearTheirMaterialsToo) {
  Voxels v;
  v.size = {2, 1, 1};
  v.occupied = {2, {1, 1, 1, 3}};
  Group group;
  group.children = {voxels_of(v)};
  group.repeat = Repeat{{3, 1, 1}, {2, 0, 0}};
  Object object;
  object.shape = group;
  const World world = compile(scene_of({object}));
  for (int i = 0; i < 6; ++i) {
    const Hit<double> hit = hit_of(world, Ray<double>{{i + 0.5, 0.5, 9}, {0, 0, -1}});
    ASSERT_EQ(hit.t, 8);
    EXPECT_EQ(world.shading_of(static_cast<int>(hit.primitive)).albedo.exact,
              i % 2 == 0 ? (Vec3d{1, 0, 0}) : (Vec3d{0, 0, 1}));
  }
}

TEST(VoxelsWorld, PlacedOnesAreFoundAsFarAsTheRayWants) {
  // A limit on the way is one on the shape's own line, whose t is shifted and scaled.
  Random random(114);
  int blocked = 0, open = 0;
  for (int i = 0; i < 300; ++i) {
    Object voxels = random_model(random, 0.3).voxels;
    voxels.transform.steps = {Scale{Vec3d{0.3, 2, 0.7}}, RotateDegrees{random.point(180)},
                              Translate{random.point(30)}};
    const World world = compile(scene_of({voxels}));
    const Aabb box = bounds_of(voxels);
    const Vec3d origin = box.center() + random.vector(5, 40);
    const Ray<double> ray{origin, normalize(box.center() + random.point(1) - origin)};
    const double t = hit_of(world, ray).t;
    if (!(t < 1e9)) continue;
    for (const double share : {0.5, 0.999, 1.001, 2.0}) {
      WorkCounter work;
      const bool is = any(occluded(world, ray, t * share, WorldLight{}, true, work));
      EXPECT_EQ(is, share > 1);
      (is ? blocked : open) += 1;
    }
  }
  EXPECT_GT(blocked, 100);
  EXPECT_GT(open, 100);
}

// ---- cost -----------------------------------------------------------------------------------

TEST(VoxelsWorld, MemoryOfCellsCountsOnce) {
  const auto bytes_with = [](int side, bool numbered) {
    Voxels v;
    v.size = {side, side, side};
    if (numbered) v.occupied = {2, {side * side * side, 3}};
    else v.occupied = {1, {0, side * side * side}};
    return bytes_of(*compile(scene_of({voxels_of(v)})).of_objects);
  };
  const std::size_t cells = 128 * 128 * 128;
  for (const bool numbered : {false, true}) {
    const std::size_t more = bytes_with(128, numbered) - bytes_with(1, numbered);
    EXPECT_EQ(more, cells - 1);
  }
}

TEST(VoxelsWorld, WorkCountsTheCellsOnTheWay) {
  // Through all of an empty grid between two filled corners, and to its first cell.
  Voxels v;
  v.size = {1000, 10, 10};
  v.occupied = {3, {0, 0, 0, 999, 9, 9}};
  const Object grid = voxels_of(v);
  const World alone = compile(scene_of({grid}));
  const World solid =
      compile(scene_of({csg_of(Operation::union_, grid, sphere_of({0, 50, 0}, 1))}));
  const auto work_of_ray = [&](const World& world, const Ray<double>& ray) {
    std::int64_t done = 0;
    WorkCounter work([&](std::int64_t portion) { done += portion; });
    closest_hit(world, ray, true, work);
    work.test(2 * WorkCounter::portion);  // hands on what is left
    return done - 2 * WorkCounter::portion;
  };
  for (const World* world : {&alone, &solid}) {
    const std::int64_t through = work_of_ray(*world, {{-1, 5.5, 5.5}, {1, 0, 0}});
    EXPECT_GE(through, 1000);
    EXPECT_LT(through, 1100);
  }
  EXPECT_LT(work_of_ray(alone, {{-1, 0.5, 0.5}, {1, 0, 0}}), 100) << "the first cell is enough";
}

}  // namespace
}  // namespace tia
