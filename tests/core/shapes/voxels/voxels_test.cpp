#include "core/shapes/voxels/voxels.h"

#include "core/shapes/simple/box.h"
#include "tests/core/shapes/grids.h"

namespace tia {
namespace {

using namespace test;

// A random grid around the origin, lengths in proportion to scale.
Voxels random_grid(Random& random, double scale, double share) {
  Cell size{};
  for (int& n : size) n = 1 + random.below(7);
  std::vector<Cell> cells;
  for (const Cell& cell : all_cells(size))
    if (random.chance(share)) cells.push_back(cell);
  if (cells.empty()) cells.push_back({0, 0, 0});
  Voxels v = grid_of(size, cells);
  const double x = random.in(0.2, 2) * scale, y = random.in(0.2, 2) * scale;
  v.cell = Vec3d{x, y, random.in(0.2, 2) * scale};
  v.origin = random.point(4) * scale;
  return v;
}

Box box_of(const Voxels& v, const Cell& cell) {
  const Vec3d edges = std::holds_alternative<double>(v.cell)
                          ? Vec3d{1, 1, 1} * std::get<double>(v.cell)
                          : std::get<Vec3d>(v.cell);
  const Vec3d low = v.origin + edges * Vec3d{double(cell[0]), double(cell[1]), double(cell[2])};
  return {low, low + edges};
}

// A direction from a set of which most lie along axes, planes or diagonals.
Vec3d some_direction(Random& random) {
  if (random.chance(0.3)) return random.direction();
  for (;;) {
    const double x = random.below(3) - 1, y = random.below(3) - 1;
    const Vec3d way{x, y, double(random.below(3) - 1)};
    if (way != Vec3d{0, 0, 0}) return unit(way);
  }
}

// A stretch of t from the first to the last plane of a cell of edge 1, as the half-open rule has
// it.
struct Stretch {
  double in = -Aabb::far, out = Aabb::far;
};
Stretch stretch_in(const Cell& cell, const Line& line) {
  const std::array o{line.origin.x, line.origin.y, line.origin.z};
  const std::array d{line.direction.x, line.direction.y, line.direction.z};
  Stretch held;
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0) {
      if (std::floor(o[i]) != cell[i]) return {1, 0};
      continue;
    }
    const double one = (cell[i] - o[i]) / d[i], other = (cell[i] + 1 - o[i]) / d[i];
    held.in = std::max(held.in, std::min(one, other));
    held.out = std::min(held.out, std::max(one, other));
  }
  return held;
}

// The crossings of the union of cells, from each cell's own stretch.
std::vector<double> expected_crossings(const std::vector<Cell>& cells, const Line& line) {
  std::vector<Stretch> held;
  for (const Cell& cell : cells) {
    const Stretch s = stretch_in(cell, line);
    if (s.in < s.out) held.push_back(s);
  }
  std::sort(held.begin(), held.end(), [](auto& a, auto& b) { return a.in < b.in; });
  std::vector<double> ends;
  for (const Stretch& s : held) {
    if (!ends.empty() && ends.back() == s.in) ends.back() = s.out;
    else ends.insert(ends.end(), {s.in, s.out});
  }
  return ends;
}

TEST(Voxels, CrossEveryCellThatTheLineVisitsAndNoOther) {
  // Bit for bit, lines along faces, edges and diagonals through corners among them.
  Random random(100);
  int crossed = 0, in_planes = 0;
  for (int i = 0; i < 30'000; ++i) {
    Cell size{};
    for (int& n : size) n = 1 + random.below(6);
    std::vector<Cell> cells;
    const double share = random.unit();
    for (const Cell& cell : all_cells(size))
      if (random.chance(share)) cells.push_back(cell);
    if (cells.empty()) continue;
    const VoxelsForm form = prepare(grid_of(size, cells));
    Vec3d origin = random.point(4) + Vec3d{2, 2, 2};
    const bool on_planes = random.chance(0.6);
    if (on_planes) origin = {std::floor(origin.x), std::floor(origin.y), std::floor(origin.z)};
    const Line line{origin, some_direction(random)};
    const std::vector<double> expected = expected_crossings(cells, line);
    ASSERT_EQ(distances(crossings_of(form, line)), expected);
    crossed += !expected.empty();
    in_planes += on_planes && !expected.empty();
  }
  EXPECT_GT(crossed, 5000);
  EXPECT_GT(in_planes, 2000);
}

TEST(Voxels, AreTheUnionOfTheirCellsBoxes) {
  // In extended precision, and for lines in general position.
  Random random(101);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 60; ++i) {
      const Voxels v = random_grid(random, scale, random.in(0.2, 0.9));
      std::vector<Box> boxes;
      for (std::size_t k = 0; k < v.occupied.size(); ++k)
        boxes.push_back(
            box_of(v, {v.occupied.number(k, 0), v.occupied.number(k, 1), v.occupied.number(k, 2)}));
      const auto outside = [&](const Vec3l& p) {
        Long nearest = Aabb::far;
        for (const Box& box : boxes) {
          const auto low = static_cast<Vec3l>(box.min) - p, high = p - static_cast<Vec3l>(box.max);
          nearest = std::min(nearest, std::max({low.x, low.y, low.z, high.x, high.y, high.z}));
        }
        return nearest;
      };
      const Aabb box = bounds(v);
      const double size = length(box.size()) / 2;
      for (int k = 0; k < 20; ++k) {
        const SceneLine line = line_near(random, box.center(), size);
        const std::vector<Crossing> pairs = crossings_along(prepare(v), line);
        expect_pairs_hold(
            pairs, [&](const Vec3l& p) { return outside(p); }, line, box.center(), size);
        seen += static_cast<int>(pairs.size());
      }
    }
  }
  EXPECT_GT(seen, 4000);
}

TEST(Voxels, NormalsLookOutOfTheFilledCell) {
  Random random(102);
  int seen = 0;
  for (int i = 0; i < 500; ++i) {
    const Voxels v = random_grid(random, 1, 0.5);
    const VoxelsForm form = prepare(v);
    const SceneLine line = line_near(random, bounds(v).center(), length(bounds(v).size()) / 2);
    const auto pairs = crossings_along(form, line);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto p = static_cast<Vec3d>(line.at(pairs[k].t));
      const Vec3d n = normal(form, p, pairs[k].element);
      EXPECT_EQ(length(n), 1);
      EXPECT_EQ(dot(n, line.direction) < 0, k % 2 == 0) << "in against it, out along it";
      const Vec2d at = uv(form, p, pairs[k].element);
      EXPECT_TRUE(0 <= at.u && at.u <= 1 && 0 <= at.v && at.v <= 1);
      ++seen;
    }
  }
  EXPECT_GT(seen, 500);
}

TEST(Voxels, FirstCrossingIsTheFirstOfAllBetweenItsLimits) {
  Random random(103);
  int found = 0, none = 0;
  for (int i = 0; i < 5000; ++i) {
    const Voxels v = random_grid(random, 1, 0.4);
    const VoxelsForm form = prepare(v);
    const Line line{bounds(v).center() + random.vector(0, 2), some_direction(random)};
    const auto all = crossings_of(form, line);
    double after = random.in(-8, 8), before = after + random.in(0, 8);
    const auto one_t = [&] {
      return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))].t;
    };
    if (!all.empty() && random.chance(0.3)) after = one_t();
    if (!all.empty() && random.chance(0.3)) before = one_t();
    if (random.chance(0.2)) after = -Aabb::far;
    if (random.chance(0.2)) before = Aabb::far;
    Crossing expected;
    for (const Crossing& each : all)
      if (after < each.t && each.t < before && each.t < expected.t) expected = each;
    const FirstCrossing first = first_crossing(form, line, after, before);
    ASSERT_EQ(first.at.t, expected.t);
    EXPECT_EQ(first.at.element, expected.element);
    (expected.t < Aabb::far ? found : none) += 1;
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(none, 500);
}

// ---- the half-open rule ---------------------------------------------------------------------

TEST(Voxels, ALineInAPlaneRunsInTheCellsBehindIt) {
  const VoxelsForm cube = prepare(grid_of({1, 1, 1}, {{0, 0, 0}}));
  const auto along_x = [&](double y, double z) {
    return distances(crossings_of(cube, {{0, y, z}, {1, 0, 0}}));
  };
  const std::vector<double> through{0, 1}, past{};
  EXPECT_EQ(along_x(0, 0.5), through) << "the face of least y";
  EXPECT_EQ(along_x(1, 0.5), past) << "the face of greatest y";
  EXPECT_EQ(along_x(0, 0), through) << "the edge of least y and z";
  EXPECT_EQ(along_x(0, 1), past);
  EXPECT_EQ(along_x(1, 0), past);
}

TEST(Voxels, ALineThroughAnEdgePassesBothItsPlanesAtOnce) {
  // In a checkerboard it goes from filled to filled, or from empty to empty, and meets no face.
  const VoxelsForm board = prepare(grid_of({2, 2, 1}, {{0, 0, 0}, {1, 1, 0}}));
  const double h = std::sqrt(0.5);
  const auto filled = distances(crossings_of(board, {{1, 1, 0.5}, {h, h, 0}}));
  EXPECT_EQ(filled, (std::vector<double>{-1 / h, 1 / h}));
  EXPECT_TRUE(crossings_of(board, {{1, 1, 0.5}, {h, -h, 0}}).empty());
  const double third = std::sqrt(1.0 / 3);
  const VoxelsForm corners = prepare(grid_of({2, 2, 2}, {{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(crossings_of(corners, {{1, 1, 1}, {third, third, third}}).size(), 2U);
}

TEST(Voxels, SharedFacesAreNoneWhateverTheMaterials) {
  Voxels v;
  v.size = {3, 1, 1};
  v.occupied = {2, {1, 1, 1, 2, 1, 3}};
  const auto found = crossings_of(prepare(v), {{0, 0.5, 0.5}, {1, 0, 0}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].element, 6 * 1 + 0);
  EXPECT_EQ(found[1].element, 6 * 3 + 1);
}

TEST(Voxels, NaNAndLinesWithoutDirectionCrossNothing) {
  const VoxelsForm form = prepare(grid_of({1, 1, 1}, {{0, 0, 0}}));
  expect_nothing_from_nan(form);
  crossings(form, Line{{0.5, 0.5, 0.5}, {0, 0, 0}}, [](double, int) { ADD_FAILURE(); });
  const double nan = std::nan("");
  EXPECT_EQ(first_crossing(form, {{nan, 0, 0}, {1, 0, 0}}, nan, nan).at.t, Aabb::far);
}

TEST(Voxels, CellsTooThinToTellApartStillPair) {
  // Planes that fall together in double: whatever is met comes in pairs.
  Voxels v;
  v.size = {1024, 1, 1};
  v.origin = {1e9, 0, 0};
  v.cell = Vec3d{1e-12, 1, 1};
  std::vector<std::int32_t> every_other{0};
  every_other.resize(1024, 1);
  v.occupied = {1, every_other};
  const VoxelsForm form = prepare(v);
  Random random(105);
  for (int i = 0; i < 200; ++i) {
    const Line line{{1e9 + random.in(-1e-6, 1e-6), 0.5, 0.5}, unit({1, random.in(-1, 1), 0.1})};
    const auto found = distances(crossings_of(form, line));
    EXPECT_EQ(found.size() % 2, 0U);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  }
}

}  // namespace
}  // namespace tia
