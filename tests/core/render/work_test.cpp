// Rays that are few and costly: they stop when they are told to, and cost no more than is allowed.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::faults_of;

// Copies that lie in one another: every ray that meets one is tried on all.
Scene overlapping(int copies) {
  return read_scene(R"({"objects":[{"type":"group","repeat":{"count":[)" + std::to_string(copies) +
                    R"(,1,1],"step":[1e-6,0,0]},
      "children":[{"type":"sphere","center":[0,0,-9],"radius":2}]}]})");
}

TEST(WorkCounter, CountsTestsAndHandsWorkOnInPortions) {
  std::int64_t handed_on = 0;
  WorkCounter work([&](std::int64_t portion) {
    EXPECT_GE(portion, WorkCounter::portion);
    EXPECT_LT(portion, WorkCounter::portion + 3);
    handed_on += portion;
  });
  for (int i = 0; i < 100'000; ++i) work.test(3);
  EXPECT_EQ(work.tests(), 100'000);
  EXPECT_GT(handed_on, 300'000 - WorkCounter::portion);
  EXPECT_LE(handed_on, 300'000);
}

TEST(Work, BeyondTheLimitIsOneFaultThatNamesTheOption) {
  RenderOptions options;
  options.max_work = 1'000'000;
  test::expect_faults(
      faults_of([&] { test::picture(overlapping(500'000), 8, 6, options); }),
      {{FaultKind::limit, "/scene", R"("a scene that costs more")",
        "at most 1000000 tests of rays against boxes and surfaces (option TIA_MAX_WORK)"}});
  EXPECT_NO_THROW(test::picture(overlapping(500), 8, 6, options));
}

TEST(Work, OfOneRayAloneIsBoundedToo) {
  for (const IntegratorName integrator :
       {IntegratorName::thesis, IntegratorName::depth, IntegratorName::cost}) {
    RenderOptions options;
    options.integrator = integrator;
    options.max_work = test::rounds(1'000'000, 10);
    EXPECT_THROW(test::picture(overlapping(test::rounds(4'000'000, 10)), 1, 1, options),
                 InputError);
  }
}

// One of many balls is enough to hide a light; which of them is the first takes a search of all.
TEST(Work, OfTheSearchForABlockerIsBoundedToo) {
  Scene scene = overlapping(500'000);
  scene.objects.push_back(
      read_scene(R"({"objects":[{"type":"plane","point":[0,0,0],"normal":[0,0,1]}]})").objects[0]);
  scene.lights = {test::point_light({0, 0, -20})};
  scene.camera.location = {0, 0, -1};
  scene.camera.look_at = Vec3d{0, 0, 0};
  RenderOptions options;
  options.max_work = 200'000;
  EXPECT_NO_THROW(test::picture(scene, 1, 1, options));
  const Ray<double> ray{{0, 0, -1}, {0, 0, 1}};
  const auto faults = faults_of([&] { explain(scene, compile(scene), ray, options); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().kind, FaultKind::limit);
  options.max_work = 20'000'000;
  EXPECT_EQ(explain(scene, compile(scene), ray, options).tree->terms.back().light.blocker, 0);
}

TEST(Work, StopsWithinARayWhenItIsToldTo) {
  const World world = compile(overlapping(10'000'000));
  const View view = view_of(Camera{}, 1, 1);
  std::stop_source source;
  std::int64_t handed_on = 0;
  WorkCounter work([&](std::int64_t portion) {
    handed_on += portion;
    source.request_stop();
    if (source.stop_requested()) throw Stopped();
  });
  EXPECT_THROW(closest_hit(world, view.ray<float>(0, 0), true, work), Stopped);
  EXPECT_LT(handed_on, 2 * WorkCounter::portion);
}

TEST(Work, OfCostlySurfacesCountsMore) {
  // A term of a polynomial costs a line as much as a ball does; so does an operand of a solid.
  const auto work_of_first = [](const char* object) {
    const Geometry geometry =
        geometry_of(read_scene(std::string(R"({"objects":[)") + object + "]}"));
    return geometry.solids.empty() ? geometry.primitives.front().work
                                   : geometry.solids.front().work;
  };
  const int box = work_of_first(R"({"type":"box","min":[0,0,0],"max":[1,1,1]})");
  EXPECT_EQ(box, 1);
  EXPECT_GT(work_of_first(R"({"type":"torus","major_radius":2,"minor_radius":1})"), box);
  EXPECT_GT(work_of_first(R"({"type":"algebraic","terms":[[2,0,0,1],[0,2,0,1],[0,0,0,-1]]})"), box);
  EXPECT_GT(work_of_first(R"({"type":"csg","operation":"union","children":[
      {"type":"sphere","center":[0,0,0],"radius":1},{"type":"sphere","center":[1,0,0],"radius":1}]})"),
            box);
}

TEST(Work, OfWhatIsTooSmallForANormalIsNoNaN) {
  // A ball whose radius is lost in its distance: no digit tells one side of it from another.
  for (const double radius : {1e-8, 1e-12, 1e-17, 1e-20, 1e-200}) {
    Scene scene = read_scene(R"({"objects":[{"type":"sphere","center":[0,0,-9],"radius":1}],
        "lights":[{"type":"point","position":[3,4,5]}]})");
    std::get<Sphere>(scene.objects.front().shape).radius = radius;
    for (const bool by_lanes : {false, true}) {
      if (by_lanes) scene.objects.front().transform.steps = {Scale{Vec3d{1, 1.5, 1}}};
      for (const IntegratorName integrator : {IntegratorName::thesis, IntegratorName::normal}) {
        RenderOptions options;
        options.integrator = integrator;
        const Image image = test::picture(scene, 1, 1, options).image;
        for (const float value : image.rgb) EXPECT_TRUE(std::isfinite(value)) << radius;
      }
      const std::vector<Meeting> hits =
          all_hits(compile(scene), Ray<double>{{0, 0, 0}, {0, 0, -1}});
      for (const Meeting& hit : hits) EXPECT_NEAR(length(hit.normal), 1, 1e-12) << radius;
    }
  }
}

}  // namespace
}  // namespace tia
