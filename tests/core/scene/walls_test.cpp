// Walls against boxes by hand, and corners against planes that halve them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/input/json.h"
#include "core/math/deterministic.h"
#include "core/scene/labels.h"
#include "core/scene/read_scene.h"
#include "tests/core/faults.h"
#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::Expected;
using test::Random;
using PlanLine = std::vector<Walls::Point>;

Scene scene_with(const std::string& object) { return read_scene("{\"objects\":[" + object + "]}"); }
std::string walls_text(const std::string& points, const std::string& more = "") {
  return R"({"type":"walls","points":)" + points + R"(,"height":3,"thickness":0.5)" + more + "}";
}
std::string box(const std::string& min, const std::string& max) {
  return R"({"type":"box","min":[)" + min + R"(],"max":[)" + max + "]}";
}

// A closed rectangle of 8 by 6, a door to the east, a window to the south.
const std::string house = walls_text(
    "[[0,0],[8,0],[8,6],[0,6]]",
    R"(,"closed":true,"openings":[{"from":16,"to":20,"sill":1,"lintel":2},{"from":9,"to":10,"lintel":2}])");
const std::vector<std::string> house_boxes{
    box("0.25,0,-0.25", "8.25,3,0.25"), box("7.75,0,0.25", "8.25,3,1"),
    box("7.75,2,1", "8.25,3,2"),        box("7.75,0,2", "8.25,3,6.25"),
    box("6,0,5.75", "7.75,3,6.25"),     box("2,0,5.75", "6,1,6.25"),
    box("2,2,5.75", "6,3,6.25"),        box("-0.25,0,5.75", "2,3,6.25"),
    box("-0.25,0,-0.25", "0.25,3,5.75")};

TEST(Walls, AlongTheAxesAreTheBoxesThatOneWouldWrite) {
  std::string all;
  for (const std::string& each : house_boxes) all += (all.empty() ? "" : ",") + each;
  const Scene walls = scene_with(house), boxes = scene_with(all);
  EXPECT_EQ(*children_of(walls.objects[0]), boxes.objects.get());
  Scene a = walls, b = boxes;
  for (Scene* each : {&a, &b}) {
    each->camera = read_scene(R"({"camera":{"location":[12,9,15],"look_at":[4,1,3]}})").camera;
    each->ambient_light = {1, 1, 1};
    each->lights = read_scene(R"({"lights":[{"type":"point","position":[3,9,2]}]})").lights;
  }
  const std::vector<float> drawn = test::picture(a, 48, 36).image.rgb;
  EXPECT_EQ(drawn, test::picture(b, 48, 36).image.rgb);
  a.objects = {};
  EXPECT_NE(drawn, test::picture(a, 48, 36).image.rgb);  // there is something to see
}

TEST(Walls, CarryWavesAsTheirBoxesDo) {
  std::string all;
  for (const std::string& each : house_boxes) all += (all.empty() ? "" : ",") + each;
  RadioQuestion question = test::link({1.3, 1.5, 2.1}, {5.6, 1.2, 4.4}, RadioMethod::image);
  question.receivers.push_back({.position = {11, 1.2, 3.4}});
  question.max_diffractions = 1;
  const RadioAnswer a = radio_paths(scene_with(house), question),
                    b = radio_paths(scene_with(all), question);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_FALSE(a.pairs[k].paths.empty());
    EXPECT_EQ(a.pairs[k].total.coherent_db, b.pairs[k].total.coherent_db);
    EXPECT_EQ(a.pairs[k].total.incoherent_db, b.pairs[k].total.incoherent_db);
  }
}

// ---- corners of any angle -------------------------------------------------------------------

/// A line that never comes near itself: on its way along x it turns by up to 120 degrees.
PlanLine line_of(Random& random) {
  PlanLine points{{random.in(-2, 2), random.in(-2, 2)}};
  const int corners = 2 + random.below(4);
  for (int i = 0; i <= corners; ++i) {
    // Every angle, none, and right angles.
    const double step = random.below(3) == 0 ? 45.0 * random.below(3) - 45 : random.in(-60, 60);
    const auto [sine, cosine] = sincos_of(step * pi / 180);
    const double length = random.in(2, 4);
    points.push_back({points.back()[0] + length * cosine, points.back()[1] + length * sine});
  }
  return points;
}

Walls::Point unit_way(const Walls::Point& a, const Walls::Point& b) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  return {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
}

/// How far p is within run i of the line, cut where planes halve its corners; negative: outside.
double within_run(const PlanLine& points, std::size_t i, double half, const Walls::Point& p) {
  const Walls::Point way = unit_way(points[i], points[i + 1]);
  const auto along = [&](const Walls::Point& from, const Walls::Point& by) {
    const double length = std::hypot(by[0], by[1]);
    return ((p[0] - from[0]) * by[0] + (p[1] - from[1]) * by[1]) / length;
  };
  const auto halving = [&](const Walls::Point& other) {
    return Walls::Point{way[0] + other[0], way[1] + other[1]};
  };
  const Walls::Point before = i > 0 ? unit_way(points[i - 1], points[i]) : way;
  const Walls::Point after = i + 2 < points.size() ? unit_way(points[i + 1], points[i + 2]) : way;
  return std::min({half - std::fabs(along(points[i], {-way[1], way[0]})),
                   along(points[i], halving(before)), -along(points[i + 1], halving(after))});
}

bool holds(const Object& piece, const Vec3d& p) {
  const Vec3d q = piece.transform.affine().inverse().point(p);
  if (const auto* box = std::get_if<Box>(&piece.shape))
    return box->min.x < q.x && q.x < box->max.x && box->min.y < q.y && q.y < box->max.y &&
           box->min.z < q.z && q.z < box->max.z;
  const auto& positions = std::get<Mesh>(piece.shape).positions.values.get();
  const auto& indices = std::get<Mesh>(piece.shape).indices.values.get();
  const auto corner = [&](std::size_t i) {
    const std::size_t at = std::size_t{3} * indices[i];
    return Vec3d{positions[at], positions[at + 1], positions[at + 2]};
  };
  for (std::size_t i = 0; i < indices.size(); i += 3)  // convex: behind every face
    if (dot(cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i)), q - corner(i)) > 0)
      return false;
  return true;
}

std::string text_of(const PlanLine& points) { return to_json(write_value(points)); }

TEST(Walls, AtCornersOfAnyAngleEachPlaceIsInOnePieceOrNone) {
  Random random(27);
  int inside = 0, prisms = 0;
  for (int round = 0; round < test::rounds(60, 3); ++round) {
    const PlanLine points = line_of(random);
    const double middle = std::hypot(points[1][0] - points[0][0], points[1][1] - points[0][1]) / 2;
    const std::string hole = number_text(middle - 0.25), end = number_text(middle + 0.25);
    const Scene scene =
        scene_with(walls_text(text_of(points), R"(,"openings":[{"sill":1,"lintel":2,"from":)" +
                                                   hole + ",\"to\":" + end + "}]"));
    const std::vector<Object>& pieces = *children_of(scene.objects[0]);
    for (const Object& each : pieces) prisms += std::holds_alternative<Mesh>(each.shape) ? 1 : 0;
    for (int k = 0; k < 60; ++k) {
      const std::size_t i = static_cast<std::size_t>(random.below(int(points.size())));
      const Vec3d p{points[i][0] + random.in(-1, 1), random.in(-0.2, 3.2),
                    points[i][1] + random.in(-1, 1)};
      double most = -1;  // of the runs
      for (std::size_t run = 0; run + 1 < points.size(); ++run)
        most = std::max(most, within_run(points, run, 0.25, {p.x, p.z}));
      const Walls::Point way = unit_way(points[0], points[1]);
      const double along = (p.x - points[0][0]) * way[0] + (p.z - points[0][1]) * way[1];
      const double gap = std::min({0.25 - std::fabs(along - middle), p.y - 1, 2 - p.y,
                                   within_run(points, 0, 0.25, {p.x, p.z})});
      const double depth = std::min({most, p.y, 3 - p.y, -gap});
      const auto holders =
          std::ranges::count_if(pieces, [&](const Object& piece) { return holds(piece, p); });
      if (std::fabs(depth) > 1e-9)
        EXPECT_EQ(holders, depth > 0 ? 1 : 0) << text_of(points) << depth;
      inside += depth > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(prisms, 20);
}

// ---- what is told of them -------------------------------------------------------------------

TEST(Walls, AreCalledByTheirNameAndWrittenAsTheyWereRead) {
  Scene scene = scene_with(house + "," + house);
  scene.objects[0].name = "house";
  const std::vector<ObjectLabel> labels = object_labels(scene);
  ASSERT_EQ(labels.size(), 18U);
  EXPECT_EQ(labels[8].name, "house");
  EXPECT_EQ(labels[9].name, "/objects/1");
  EXPECT_EQ(object_pointers(scene, {17}).at(17), "/objects/1");
  EXPECT_EQ(scene_with(to_json(write_value(scene.objects[1]))).objects[0], scene.objects[1]);
}

TEST(Walls, SayWhichPointsCannotBeTheirs) {
  const auto refused = [](const std::string& walls, const std::vector<Expected>& faults) {
    test::expect_scene_refused("{\"objects\":[" + walls + "]}", faults);
  };
  const std::string at = "/objects/0/points";
  refused(walls_text("[[0,0]]"), {{FaultKind::wrong_type, at, "[[0,0]]", "at least 2"}});
  refused(walls_text("[[0,0],[4,0],[4,0],[4,0]]"),
          {{FaultKind::conflict, at + "/2", "[4,0]", "than the one before"},
           {FaultKind::conflict, at + "/3", "[4,0]", "than the one before"}});
  refused(walls_text("[[0,0],[4,0]]", R"(,"closed":true)"),
          {{FaultKind::conflict, at, "2", "at least 3"}});
  refused(walls_text("[[0,0],[4,0],[4,4],[0,0]]", R"(,"closed":true)"),
          {{FaultKind::conflict, at + "/3", "[0,0]", "than the first"}});
  refused(walls_text("[[0,0],[4,0],[4,0.4],[0,0.4]]"),
          {{FaultKind::conflict, at + "/2", "[4,0.4]", "at least 0.5 from the point before"}});
  refused(walls_text("[[0,0],[4,0],[2,0]]"),
          {{FaultKind::conflict, at + "/1", "[4,0]", "does not turn back"},
           {FaultKind::conflict, at + "/2", "[2,0]", "does not turn back"}});
  refused(walls_text("[[0,0],[6,0],[6,4],[3,4],[3,-4]]"),
          {{FaultKind::conflict, at + "/4", "[3,-4]", "the one from point 0"}});
  // Up to its face is near enough.
  EXPECT_EQ(
      children_of(scene_with(walls_text("[[0,0],[6,0],[6,4],[3,4],[3,0.25]]")).objects[0])->size(),
      4U);
  std::string many;
  for (int i = 0; i <= 512; ++i) many += (i > 0 ? ",[" : "[") + std::to_string(i) + ",0]";
  refused(walls_text("[" + many + "]"), {{FaultKind::limit, at, "513", "at most 512 points"}});
}

TEST(Walls, SayWhichOpeningsCannotBeThere) {
  const auto refused = [](const std::string& openings, const std::vector<Expected>& faults) {
    test::expect_scene_refused(
        "{\"objects\":[" + walls_text("[[0,0],[4,0],[4,4]]", ",\"openings\":" + openings) + "]}",
        faults);
  };
  const std::string at = "/objects/0/openings/";
  refused(R"([{"from":1,"to":1}])", {{FaultKind::out_of_range, at + "0/to", "1", "above 1"}});
  refused(R"([{"from":3,"to":3.9},{"from":3.9,"to":5}])",
          {{FaultKind::out_of_range, at + "0/to", "3.9", "0 to 3.75, between the corners"},
           {FaultKind::out_of_range, at + "1/from", "3.9", "0 to 3.75"}});
  refused(R"([{"from":8,"to":9}])", {{FaultKind::out_of_range, at + "0/from", "8", "4.25 to 8"}});
  refused(R"([{"from":2,"to":3},{"from":1,"to":2.5}])",
          {{FaultKind::conflict, at + "0/from", "2", "opening 1"}});
  refused(R"([{"from":1,"to":2,"lintel":3.5},{"from":2,"to":3,"sill":2,"lintel":2}])",
          {{FaultKind::out_of_range, at + "0/lintel", "3.5", "height, 3"},
           {FaultKind::out_of_range, at + "1/sill", "2", "below 2"}});
  test::expect_scene_refused(
      R"({"objects":[{"type":"walls","points":[[0,0],[1,0]],"height":1,"thickness":0}]})",
      {{FaultKind::out_of_range, "/objects/0/thickness", "0", "above 0"}});
}

TEST(Walls, AreNoOperandOfACsg) {
  test::expect_scene_refused(
      R"({"objects":[{"type":"csg","operation":"union","children":[)" + house + "]}]}",
      {{FaultKind::out_of_range, "/objects/0/children/0/type", "\"walls\"", "in a csg a solid"}});
}

}  // namespace
}  // namespace tia
