// Buildings of GeoJSON as a scene: lengths of degrees, volumes, what is refused.
#include "core/scene/footprints.h"

#include <gtest/gtest.h>

#include "core/input/json.h"
#include "core/scene/triangulation.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// The circle of latitude has the radius a cos(beta), tan(beta) = (1 - f) tan(latitude); a degree of
// longitude at the equator is 111 319.49 m, one of latitude at 45 degrees 111 131.78 m.
// Source: Torge, "Geodesy" (2001), 4.1; NIMA TR 8350.2 (2000): a, f of WGS 84.
TEST(Footprints, DegreesHaveTheLengthsOfTheEllipsoid) {
  const double a = 6'378'137, f = 1 / 298.257223563;
  for (const double latitude : {-60.0, -10.0, 0.0, 33.0, 45.0, 80.0}) {
    const double beta = std::atan((1 - f) * std::tan(latitude * pi / 180));
    EXPECT_NEAR(Geodesy::at(7, latitude).east, a * std::cos(beta) * pi / 180, 1e-6);
  }
  EXPECT_NEAR(Geodesy::at(0, 0).east, 111'319.49, 0.01);
  EXPECT_NEAR(Geodesy::at(0, 45).north, 111'131.78, 0.01);
  EXPECT_LT(Geodesy::at(0, 45).plan(0, 45.001).y, 0);  // north is -z
}

// By the divergence theorem, of a mesh that is closed and whose normals are outwards.
double volume_of(const Mesh& mesh) {
  const auto& p = mesh.positions.values.get();
  const auto& corners = mesh.indices.values.get();
  const auto at = [&](std::size_t i) {
    const std::size_t k = 3 * std::size_t{corners[i]};
    return Vec3d{p[k], p[k + 1], p[k + 2]};
  };
  double six = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    six += dot(at(i), cross(at(i + 1), at(i + 2)));
  return six / 6;
}
// Each edge once in each direction.
bool is_closed_mesh(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const auto& corners = mesh.indices.values.get();
  for (std::size_t i = 0; i < corners.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{corners[i + k], corners[i + (k + 1) % 3]}];
  for (const auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
  return true;
}

std::string ring_text(const Ring& ring, bool reversed) {
  Ring all = ring;
  if (reversed) std::reverse(all.begin(), all.end());
  all.push_back(all.front());
  std::string text = "[";
  for (const PlanPoint& p : all)
    text += (text.size() > 1 ? "," : "") + ("[" + number_text(p.x)) + "," + number_text(p.y) + "]";
  return text + "]";
}

// A star around a centre, with a yard in it, either way round.
TEST(Footprints, BlocksAreClosedAndHaveTheAreasVolumeWhateverTheTurns) {
  Random random(5);
  for (int round = 0; round < 12; ++round) {
    const int corners = 5 + round;
    Ring outer, hole;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * pi * i / corners, far = random.in(4e-4, 9e-4);
      outer.push_back({10 + far * std::cos(angle), 50 + far * std::sin(angle)});
      if (i % 2 == 0) hole.push_back({10 + 1e-4 * std::cos(angle), 50 + 1e-4 * std::sin(angle)});
    }
    const std::string text = R"({"type":"Feature","properties":{"height":"12.5 m","min_height":2},
        "geometry":{"type":"Polygon","coordinates":[)" +
                             ring_text(outer, round % 2 == 0) + "," +
                             ring_text(hole, round % 3 == 0) + "]}}";
    const Scene scene = scene_of_footprints(parse_json(text));
    ASSERT_EQ(scene.objects.size(), 2U);
    const Mesh& mesh = std::get<Mesh>(scene.objects[1].shape);
    const Geodesy degrees = Geodesy::at(10, 50);
    const double area = (std::fabs(doubled_area(outer)) - std::fabs(doubled_area(hole))) / 2 *
                        degrees.east * degrees.north;
    EXPECT_TRUE(is_closed_mesh(mesh)) << round;
    EXPECT_NEAR(volume_of(mesh), area * 10.5, area * 10.5 * 2e-4) << round;
    const std::size_t points = outer.size() + hole.size();
    EXPECT_EQ(mesh.triangles(), 2 * points + 2 * points);  // walls; n + 2 holes - 2 = n, twice
  }
}

TEST(Footprints, LevelsAreThreeMetresAndPartsAreObjects) {
  const Scene scene = scene_of_footprints(parse_json(R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"building:levels":"4","name":"hall"},"geometry":
      {"type":"MultiPolygon","coordinates":[[[[0,0],[0.001,0],[0.001,0.001],[0,0]]],
                                            [[[0.002,0],[0.003,0],[0.003,0.001],[0.002,0]]]]}},
    {"type":"Feature","properties":null,"geometry":{"type":"Point","coordinates":[0,0]}}]})"));
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(scene.objects[1].name, "hall");
  EXPECT_EQ(bounds_of(scene.objects[1]).max.y, 12);
}

std::string refused_at(const std::string& text) {
  try {
    scene_of_footprints(parse_json(text));
  } catch (const InputError& error) {
    return error.faults().front().pointer;
  }
  return "taken";
}

TEST(Footprints, SayWhatIsWrongAtItsPlace) {
  EXPECT_EQ(refused_at("{}"), "/type");
  EXPECT_EQ(refused_at(R"({"type":"Polygone"})"), "/type");
  EXPECT_EQ(refused_at(R"({"type":"FeatureCollection","features":[]})"), "");
  EXPECT_EQ(refused_at(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]})"),
            "/coordinates/0");
  EXPECT_EQ(refused_at(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,95],[0,0]]]})"),
            "/coordinates/0/2");
  EXPECT_EQ(refused_at(R"({"type":"Feature","properties":{"height":"tall"},"geometry":
      {"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})"),
            "/properties/height");
}

}  // namespace
}  // namespace tia
