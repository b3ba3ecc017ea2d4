// What a description of voxels becomes: the grid of its cells and their bounds.
#include "tests/core/shapes/grids.h"

namespace tia {
namespace {

using namespace test;

TEST(Voxels, AllFourFormsGiveTheSameGrid) {
  Random random(104);
  for (int i = 0; i < 200; ++i) {
    Cell size{};
    for (int& n : size) n = 1 + random.below(5);
    std::vector<int> filled;
    for (std::size_t k = 0; k < all_cells(size).size(); ++k) filled.push_back(random.below(2));
    filled[static_cast<std::size_t>(random.below(static_cast<int>(filled.size())))] = 1;
    VoxelList lengths{1, {0}}, runs{2, {}}, cells{3, {}}, numbered{4, {}};
    for (std::size_t k = 0, length = 0; k < filled.size(); k += length) {
      for (length = 0; k + length < filled.size() && filled[k + length] == filled[k];) ++length;
      const int count = static_cast<int>(length);
      if (k == 0 && filled[0] == 0) lengths.numbers.clear();
      lengths.numbers.push_back(count);
      runs.numbers.insert(runs.numbers.end(), {count, filled[k]});
    }
    for (std::size_t k = 0; k < filled.size(); ++k) {
      if (filled[k] == 0) continue;
      const auto [x, y, z] = all_cells(size)[k];
      cells.numbers.insert(cells.numbers.end(), {x, y, z});
      numbered.numbers.insert(numbered.numbers.end(), {x, y, z, 1});
    }
    Voxels v;
    v.size = size;
    v.occupied = cells;
    const VoxelsForm expected = prepare(v);
    const std::vector<std::uint8_t> bytes(filled.begin(), filled.end());
    EXPECT_EQ(expected.grid->cells, bytes);
    for (const VoxelList& other : {lengths, runs, numbered}) {
      v.occupied = other;
      const VoxelsForm form = prepare(v);
      EXPECT_EQ(form.grid->cells, bytes);
      EXPECT_EQ(form.filled.low, expected.filled.low);
      EXPECT_EQ(form.filled.high, expected.filled.high);
      EXPECT_EQ(form.materials, other.width == 1 ? 0 : 1);
    }
  }
}

TEST(Voxels, BoundsHoldTheFilledCellsClosely) {
  Voxels v = grid_of({8, 8, 8}, {{2, 3, 4}, {5, 3, 6}});
  v.origin = {10, 20, 30};
  v.cell = Vec3d{1, 2, 4};
  EXPECT_EQ(bounds(v).min, (Vec3d{12, 26, 46}));
  EXPECT_EQ(bounds(v).max, (Vec3d{16, 28, 58}));
  EXPECT_EQ(bounds(prepare(v)).min, bounds(v).min);
  EXPECT_EQ(bounds(prepare(v)).max, bounds(v).max);
}

TEST(Voxels, OneRunFillsALargeGrid) {
  Voxels v;
  v.size = {256, 256, 256};
  v.occupied = {1, {0, 256 * 256 * 256}};
  const VoxelsForm form = prepare(v);
  const Line across{{128, 100.25, 100.75}, {1, 0, 0}};
  EXPECT_EQ(distances(crossings_of(form, across)), (std::vector<double>{-128, 128}));
  // A plane's t is one division, however many cells lie before it.
  const Vec3d way = unit({1, 1e-3, 1e-3});
  const auto slanted = crossings_of(form, {{128, 128, 128}, way});
  ASSERT_EQ(slanted.size(), 2U);
  EXPECT_EQ(slanted[1].t, 128 / way.x);
  const FirstCrossing first = first_crossing(form, across, -200, Aabb::far);
  EXPECT_EQ(first.at.t, -128);
  EXPECT_EQ(first.work, 0) << "nothing is walked through";
  EXPECT_EQ(first_crossing(form, across, 0, Aabb::far).work, 128);
}

}  // namespace
}  // namespace tia
