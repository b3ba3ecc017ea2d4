// A scene that is moved as a whole looks as it did, wherever it is moved to. Coordinates of surveys
// and of CAD are like that. How much may differ: numbers near 10^7 are rounded to 10^-9 in double,
// beside lengths of 1, and float's own rounding falls differently; so of pixels only those change
// whose ray passes an edge by less than some 10^-6 of a pixel, and what mirrors and lenses make of
// these.
#include "tests/core/render/far_scenes.h"

namespace tia {
namespace {

using namespace test;

const int far_rounds = sanitized() ? 1 : 12;

// ---- laws -------------------------------------------------------------------------------------

TEST(Far, ScenesOfAllKindsLookAsTheyDidNear) {
  Random random(1000);
  for (int i = 0; i < far_rounds; ++i) {
    const auto seed = 1010 + static_cast<std::uint64_t>(i);
    const Vec3d by = random_offset(random);
    SCOPED_TRACE(testing::Message() << seed << " " << testing::PrintToString(by));
    expect_alike(scene_of_all_kinds(seed), moved(scene_of_all_kinds(seed), by));
  }
}

TEST(Far, SoDoFormulas) {
  Random random(1001);
  for (int i = 0; i < (far_rounds + 3) / 4; ++i) {
    const auto seed = 1040 + static_cast<std::uint64_t>(i);
    const Vec3d by = random_offset(random);
    SCOPED_TRACE(testing::Message() << seed << " " << testing::PrintToString(by));
    expect_alike(scene_of_formulas(seed), moved(scene_of_formulas(seed), by));
  }
}

// Their floors are balls of radius 10 000, and they are traced the fast way.
TEST(Far, SoDoFewBallsOnAFloorThatIsABall) {
  Random random(1002);
  for (int i = 0; i < 2 * far_rounds; ++i) {
    const auto seed = 1060 + static_cast<std::uint64_t>(i);
    const Vec3d by = random_offset(random);
    SCOPED_TRACE(testing::Message() << seed << " " << testing::PrintToString(by));
    const Scene scene = random_scene(seed);
    Scene far = with_moved_view(scene, by);
    for (Object& object : far.objects.edit()) ASSERT_TRUE(move_numbers(object.shape, by));
    expect_alike(scene, far);
    EXPECT_EQ(compile(far).few_balls, compile(scene).few_balls);
  }
}

// Their textures fill the space that they are moved in: by whole periods of it.
TEST(Far, SoDoShapesWhoseOwnNumbersAreFar) {
  Random random(1003);
  const auto even = [](double x) { return 2 * std::round(x / 2); };
  for (int i = 0; i < far_rounds; ++i) {
    const auto seed = 1090 + static_cast<std::uint64_t>(i);
    const Vec3d any = random_offset(random), by{even(any.x), even(any.y), even(any.z)};
    SCOPED_TRACE(testing::Message() << seed << " " << testing::PrintToString(by));
    const Scene near = scene_of_numbers(seed);
    Scene far = with_moved_view(near, by);
    for (Object& object : far.objects.edit()) ASSERT_TRUE(move_numbers(object.shape, by));
    expect_alike(near, far);
  }
}

std::int64_t work_of(const Scene& scene) {
  RenderOptions options = drawn_by(IntegratorName::whitted);
  std::int64_t work = 0;
  options.spent = [&](std::int64_t, std::int64_t tests) { work = tests; };
  picture(scene, far_width, far_height, options);
  return work;
}

// Their transforms bring them back, alone and in groups that repeat them; so far away boxes in
// float would have to be so large that rays enter all copies.
TEST(Far, SoDoShapesThatAreFarInASpaceOfTheirOwnOnlyAndTheyTakeNoMoreWork) {
  Random random(1004);
  std::int64_t near_work = 0, far_work = 0;
  for (int i = 0; i < far_rounds; ++i) {
    const auto seed = 1120 + static_cast<std::uint64_t>(i);
    SCOPED_TRACE(seed);
    Scene near = scene_of_numbers(seed), far = near;
    for (std::size_t k = 0; k < near.objects.size(); ++k) {
      const Vec3d by = random_offset(random), turn = random.point(180);
      const bool repeats = random.chance(0.5);
      const auto wrap = [&](Object& object, const Vec3d& back) {
        std::get<Finish>(std::get<Boxed<Material>>(*object.material)->kind).texture.reset();
        Group group{{object}, {}};
        if (repeats) group.repeat = Repeat{{2, 2, 1}, {1.5, -3, 0}};
        object = object_of(group, {{Translate{back}, RotateDegrees{turn}}});
      };
      ASSERT_TRUE(move_numbers(far.objects[k].shape, by));
      wrap(near.objects[k], {});
      wrap(far.objects[k], -by);
    }
    expect_alike(near, far);
    near_work += work_of(near);
    far_work += work_of(far);
  }
  EXPECT_LT(static_cast<double>(far_work), 1.05 * static_cast<double>(near_work));
}

TEST(Far, NothingButAPlaneLooksAsItDidNear) {
  Scene scene;
  scene.objects.push_back(object_of(Plane{{0, -2, 0}, {0.1, 1, 0.2}}));
  Finish finish;
  finish.texture = Texture{Checker{}};
  scene.objects.front().material = MaterialRef(Material{finish});
  light_up(scene);
  expect_alike(scene, moved(scene, {3e6, -1e6, 2e6}));
}

// Numbers that double keeps all the digits of wherever they are: far from the origin not a bit
// depends on how far.
TEST(Far, MovesByAPowerOfTwoChangeNoBit) {
  Random random(1005);
  Scene scene;
  const auto whole = [&] { return random.whole(-4096, 4096) * 0x1p-9; };
  for (int i = 0; i < 20; ++i) {
    const double x = whole(), y = whole();
    scene.objects.push_back(ball({x, y, whole()}, 0.75, random_finish(random)));
  }
  light_up(scene);
  const auto at = [&](const Vec3d& by) {
    Scene far = with_moved_view(scene, by);
    for (Object& object : far.objects.edit()) EXPECT_TRUE(move_numbers(object.shape, by));
    return bits_of(picture(far, far_width, far_height, drawn_by(IntegratorName::whitted)).image);
  };
  const auto bits = at({0x1p22, -0x1p21, 0x1p20});
  EXPECT_TRUE(bits == at({-0x1p20, 0x1p23, 0x1p21}));
  EXPECT_TRUE(bits == at({0x1p19, 0x1p19, -0x1p23}));
}

Vec3d position_of(const WorldLight& light) {
  if (const auto* spot = std::get_if<SpotForm>(&light.form)) return spot->position.exact;
  return light.middle.exact;
}

// What is kept of the objects serves wherever lights and camera go.
TEST(Far, WorldsOfMovedLightsShareTheirOrigin) {
  Random random(1007);
  Scene scene = moved(scene_of_all_kinds(1150), random_offset(random));
  const auto shared = std::make_shared<const Geometry>(geometry_of(scene));
  EXPECT_NE(shared->origin, Vec3d{});
  for (int i = 0; i < 5; ++i) {
    for (Light& light : scene.lights) light.move_to(random_offset(random), {});
    const World with = compile(scene, shared), alone = compile(scene);
    EXPECT_EQ(with.origin, alone.origin);
    ASSERT_EQ(with.lights.size(), alone.lights.size());
    for (std::size_t k = 0; k < with.lights.size(); ++k) {
      const Vec3d position = position_of(with.lights[k]);
      EXPECT_EQ(position, position_of(alone.lights[k]));
      EXPECT_LT(length(position + with.origin - *scene.lights[k].place()), 1e-8);
    }
  }
}

// ---- explanations -----------------------------------------------------------------------------

Vec3d triple(const Value& value) {
  const auto& list = std::get<Value::Array>(value.is);
  return {std::get<double>(list[0].is), std::get<double>(list[1].is), std::get<double>(list[2].is)};
}
const Value& member(const Value& object, const char* name) {
  for (const auto& [key, value] : std::get<Value::Object>(object.is))
    if (key == name) return value;
  throw std::out_of_range(name);
}

TEST(Far, ExplanationsSpeakOfTheScenesOwnPlaces) {
  Random random(1006);
  const Scene scene = thesis_scene('a');
  for (int i = 0; i < 30; ++i) {
    const Vec3d by = random_offset(random);
    Scene far = with_moved_view(scene, by);
    for (Object& object : far.objects.edit()) ASSERT_TRUE(move_numbers(object.shape, by));
    const auto explained = [](const Scene& of) {
      return Value(value_of(explain(of, compile(of), view_of(of.camera, far_width, far_height), 30,
                                    22, 0, drawn_by(IntegratorName::whitted))));
    };
    const Value near = explained(scene), moved = explained(far);
    const auto expect_moved = [&](const Value& a, const Value& b, double slack) {
      EXPECT_LT(length(triple(b) - triple(a) - by), slack) << to_json(a) << to_json(b);
    };
    expect_moved(member(member(near, "ray"), "origin"), member(member(moved, "ray"), "origin"),
                 1e-8);
    const auto& hits = std::get<Value::Array>(member(near, "hits").is);
    const auto& others = std::get<Value::Array>(member(moved, "hits").is);
    ASSERT_EQ(hits.size(), others.size());
    ASSERT_FALSE(hits.empty());
    for (std::size_t k = 0; k < hits.size(); ++k)
      expect_moved(member(hits[k], "point"), member(others[k], "point"), 1e-5);
    const Value &tree = member(near, "tree"), &other = member(moved, "tree");
    expect_moved(member(tree, "point"), member(other, "point"), 1e-4);
    expect_moved(member(member(tree, "ray"), "origin"), member(member(other, "ray"), "origin"),
                 1e-4);
    // A ray of one's own, given in the scene's coordinates.
    const Ray<double> ray{by, normalize(Vec3d{0.01, 0.02, -1})};
    const Explanation own = explain(far, compile(far), ray, drawn_by(IntegratorName::whitted));
    ASSERT_FALSE(own.hits.empty());
    EXPECT_LT(length(own.hits.front().point - (ray.origin + ray.direction * own.hits.front().t)),
              1e-8);
    EXPECT_NEAR(own.hits.front().t, 16, 0.1);
  }
}

}  // namespace
}  // namespace tia
