// Polygons cut into triangles: what of the polygon stays, and which ear comes first. Quick tier,
// some 0.1 s.
#include "core/models/polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "tests/core/support.h"

namespace tia::test {
namespace {

using PolygonIndices = std::vector<std::uint32_t>;

struct PolygonCorner {
  double x, y;
  bool operator==(const PolygonCorner&) const = default;
};
using PolygonOutline = std::vector<PolygonCorner>;

double polygon_turn_of(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
double polygon_shoelace(const PolygonOutline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PolygonCorner &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

PolygonIndices polygon_indices(std::size_t corners) {
  PolygonIndices indices(corners);
  std::iota(indices.begin(), indices.end(), 0U);
  return indices;
}
std::vector<double> polygon_on_floor(const PolygonOutline& outline) {
  std::vector<double> positions;
  for (const PolygonCorner& p : outline) positions.insert(positions.end(), {p.x, p.y, 0});
  return positions;
}
PolygonIndices cut_polygon(const PolygonOutline& outline) {
  PolygonIndices triangles;
  triangulate(polygon_indices(outline.size()), polygon_on_floor(outline), triangles);
  return triangles;
}

// That they cover a polygon that turns counter-clockwise, once, by their number, turn and areas.
void expect_covers_polygon(const PolygonOutline& outline, const PolygonIndices& triangles) {
  ASSERT_EQ(triangles.size(), 3 * (outline.size() - 2));
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const double area = polygon_turn_of(outline[triangles[i]], outline[triangles[i + 1]],
                                        outline[triangles[i + 2]]);
    EXPECT_GT(area, 0) << "triangle " << i / 3;
    sum += area;
  }
  EXPECT_NEAR(sum, polygon_shoelace(outline), 1e-12 * std::fabs(polygon_shoelace(outline)) + 1e-15);
}

// ---- random outlines ----------------------------------------------------------------------------

PolygonOutline star_polygon(Random& random, int corners) {
  PolygonOutline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + random.in(0.1, 0.9)) / corners;
    const double radius = random.in(0.1, 1);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

bool sides_cross(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c,
                 const PolygonCorner& d) {
  return (polygon_turn_of(a, b, c) > 0) != (polygon_turn_of(a, b, d) > 0) &&
         (polygon_turn_of(c, d, a) > 0) != (polygon_turn_of(c, d, b) > 0);
}
// Turns round what lies between two sides that cross; each time the outline gets shorter.
bool uncross_polygon(PolygonOutline& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (!sides_cross(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n])) continue;
      std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   outline.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      return true;
    }
  return false;
}
PolygonOutline simple_polygon(Random& random, int corners) {
  PolygonOutline outline;
  for (int i = 0; i < corners; ++i) {
    const double x = random.in(-1, 1);
    outline.push_back({x, random.in(-1, 1)});
  }
  while (uncross_polygon(outline)) {
  }
  if (polygon_shoelace(outline) < 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

// ---- the rule, as it is said
// ----------------------------------------------------------------------

struct PolygonRule {
  const PolygonOutline& outline;
  PolygonIndices left = polygon_indices(outline.size());

  const PolygonCorner& at(std::size_t i) const { return outline[left[i % left.size()]]; }
  double turn_at(std::size_t i) const {
    return polygon_turn_of(at(i + left.size() - 1), at(i), at(i + 1));
  }
  bool is_ear(std::size_t i) const {
    if (turn_at(i) <= 0) return false;
    const PolygonCorner &a = at(i + left.size() - 1), &b = at(i), &c = at(i + 1);
    for (std::size_t j = 0; j < left.size(); ++j) {
      const PolygonCorner& p = at(j);
      if (p == a || p == b || p == c || turn_at(j) > 0) continue;
      if (polygon_turn_of(a, b, p) >= 0 && polygon_turn_of(b, c, p) >= 0 &&
          polygon_turn_of(c, a, p) >= 0)
        return false;
    }
    return true;
  }
  PolygonIndices triangles() {
    PolygonIndices cut;
    while (left.size() >= 3) {
      std::size_t ear = 0;
      while (ear < left.size() && !is_ear(ear)) ++ear;
      ear %= left.size();
      const std::size_t n = left.size();
      cut.insert(cut.end(), {left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return cut;
  }
};

// ---- tests --------------------------------------------------------------------------------------

TEST(Polygons, FewerThanThreeCornersAreNothingAndThreeStayAsTheyAre) {
  const std::vector<double> positions(27, 0.0);
  PolygonIndices triangles{9};
  triangulate(PolygonIndices{}, positions, triangles);
  triangulate(PolygonIndices{4, 5}, positions, triangles);
  EXPECT_EQ(triangles, PolygonIndices{9});
  triangulate(PolygonIndices{7, 2, 2}, positions, triangles);
  EXPECT_EQ(triangles, (PolygonIndices{9, 7, 2, 2}));
}

TEST(Polygons, ConvexOnesAreFansOfTheLastCorner) {
  EXPECT_EQ(cut_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), (PolygonIndices{3, 0, 1, 3, 1, 2}));
  EXPECT_EQ(cut_polygon({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}),
            (PolygonIndices{4, 0, 1, 4, 1, 2, 4, 2, 3}));
}

TEST(Polygons, ADartIsCutThroughItsDent) {
  EXPECT_EQ(cut_polygon({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), (PolygonIndices{0, 1, 2, 3, 0, 2}));
  EXPECT_EQ(cut_polygon({{1, 1}, {0, 4}, {0, 0}, {4, 0}}), (PolygonIndices{0, 1, 2, 3, 0, 2}));
}

TEST(Polygons, TheFirstEarIsCutFirst) {
  // An L, whose dent is corner 3. Corner 0's triangle (5, 0, 1) has it on its long side.
  const PolygonOutline shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(cut_polygon(shape), (PolygonIndices{0, 1, 2, 0, 2, 3, 5, 0, 3, 5, 3, 4}));
  expect_covers_polygon(shape, cut_polygon(shape));
}

TEST(Polygons, CombsAndSpiralsAreCovered) {
  PolygonOutline comb{{0, 0}, {20, 0}};
  for (int tooth = 10; tooth > 0; --tooth) {
    comb.push_back({2.0 * tooth, 5});
    comb.push_back({2.0 * tooth - 1, 1});
  }
  comb.push_back({0, 5});
  expect_covers_polygon(comb, cut_polygon(comb));
  PolygonOutline spiral;
  for (int i = 0; i <= 100; ++i) {
    const double angle = 0.2 * i, radius = 1 + 0.1 * i;
    spiral.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (int i = 100; i >= 0; --i) {
    const double angle = 0.2 * i, radius = 0.8 + 0.1 * i;
    spiral.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  expect_covers_polygon(spiral, cut_polygon(spiral));
}

TEST(Polygons, StarShapedOnesAreCovered) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const PolygonOutline outline = star_polygon(random, random.whole(5, 60));
    expect_covers_polygon(outline, cut_polygon(outline));
  }
}

TEST(Polygons, SimpleOnesAreCoveredAndCutByTheRule) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const PolygonOutline outline = simple_polygon(random, random.whole(4, 40));
    expect_covers_polygon(outline, cut_polygon(outline));
    EXPECT_EQ(cut_polygon(outline), PolygonRule{outline}.triangles());
  }
}

TEST(Polygons, CornersOnASideAreKept) {
  const PolygonOutline square{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1},
                              {3, 3}, {1, 3}, {0, 3}, {0, 2}};
  for (std::size_t first = 0; first < square.size(); ++first) {
    PolygonOutline turned = square;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    expect_covers_polygon(turned, cut_polygon(turned));
  }
}

TEST(Polygons, AHoleMayBeReachedByABridge) {
  // The bridge from (0, 0) to (1, 1) is gone along twice.
  const PolygonOutline ring{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0},
                            {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};
  for (std::size_t first = 0; first < ring.size(); ++first) {
    PolygonOutline turned = ring;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    expect_covers_polygon(turned, cut_polygon(turned));
  }
}

TEST(Polygons, RepeatedCornersCostATriangleOfNoArea) {
  const PolygonOutline outline{{0, 0}, {0, 0}, {2, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 2}};
  const PolygonIndices triangles = cut_polygon(outline);
  ASSERT_EQ(triangles.size(), 15U);
  double sum = 0;
  for (std::size_t i = 0; i < 15; i += 3) {
    const double area = polygon_turn_of(outline[triangles[i]], outline[triangles[i + 1]],
                                        outline[triangles[i + 2]]);
    EXPECT_GE(area, 0);
    sum += area;
  }
  EXPECT_EQ(sum, 4);
}

// Of a corner list that repeats indices, the list counts, not the places.
TEST(Polygons, TrianglesHaveTheIndicesThatCame) {
  const std::vector<double> positions{9, 9, 9, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0};
  PolygonIndices triangles;
  triangulate(PolygonIndices{4, 3, 2, 1}, positions, triangles);
  EXPECT_EQ(triangles, (PolygonIndices{1, 4, 3, 1, 3, 2}));
}

TEST(Polygons, WhatIsNoPolygonEndsWithAsManyTriangles) {
  const std::vector<PolygonOutline> shapes{
      {{0, 0}, {0, 0}, {0, 0}, {0, 0}},                  // a point
      {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 1}, {5, 5}},  // a line
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}},                  // an eight, without area
      {{0, 0}, {3, 3}, {3, 0}, {0, 1}, {5, 2}},
      {{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}},  // a pentagram
  };
  for (const PolygonOutline& shape : shapes)
    EXPECT_EQ(cut_polygon(shape).size(), 3 * (shape.size() - 2));
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    PolygonOutline shape;
    for (int corners = random.whole(4, 30); corners > 0; --corners) {
      const double x = random.below(5);
      shape.push_back({x, static_cast<double>(random.below(5))});
    }
    EXPECT_EQ(cut_polygon(shape).size(), 3 * (shape.size() - 2));
  }
}

// A plane's x and y axes with whole numbers, so that what lies in it does so exactly.
struct PolygonTilt {
  Vec3d origin, x, y;
};
std::vector<double> polygon_on(const PolygonTilt& tilt, const PolygonOutline& outline) {
  std::vector<double> positions;
  for (const PolygonCorner& p : outline) {
    const Vec3d at = tilt.origin + p.x * tilt.x + p.y * tilt.y;
    positions.insert(positions.end(), {at.x, at.y, at.z});
  }
  return positions;
}

TEST(Polygons, APlaneHasNoSayInWhatIsCut) {
  const std::vector<PolygonTilt> tilts{
      {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}},     {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}},
      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},     {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
      {{100, -7, 3}, {1, 2, 3}, {-3, 1, 2}}, {{-1e3, 2e3, 5}, {0, -2, 1}, {4, 4, -1}},
  };
  Random random(4);
  for (const PolygonTilt& tilt : tilts)
    for (int i = 0; i < 30; ++i) {
      const PolygonOutline outline = simple_polygon(random, random.whole(4, 30));
      PolygonIndices triangles;
      triangulate(polygon_indices(outline.size()), polygon_on(tilt, outline), triangles);
      EXPECT_EQ(triangles, cut_polygon(outline));
    }
}

// A dart whose dent is lifted by h. The normal is (-4h, -4h, 8), and along it the dent turns by
// 32 h^2 - 64: from h = sqrt(2) on it is none, whatever it is along z.
TEST(Polygons, WhatIsNotFlatIsSeenAlongItsNormal) {
  const auto lifted = [](double h) {
    PolygonIndices triangles;
    triangulate(polygon_indices(4), std::vector<double>{0, 0, 0, 4, 0, 0, 1, 1, h, 0, 4, 0},
                triangles);
    return triangles;
  };
  EXPECT_EQ(lifted(1.41), (PolygonIndices{0, 1, 2, 3, 0, 2}));
  EXPECT_EQ(lifted(1.42), (PolygonIndices{3, 0, 1, 3, 1, 2}));
}

TEST(Polygons, TheSameFarFromTheOrigin) {
  const PolygonOutline shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  PolygonOutline far = shape;
  for (PolygonCorner& p : far) p = {p.x + 999'999'990, p.y - 999'999'990};
  EXPECT_EQ(cut_polygon(far), cut_polygon(shape));
}

// A sawtooth of the most corners: each dent may lie in the way of each tooth.
TEST(Polygons, FourThousandCornersAreNoTrouble) {
  Random random(5);
  const PolygonOutline outline = star_polygon(random, 4096);
  expect_covers_polygon(outline, cut_polygon(outline));
}

}  // namespace
}  // namespace tia::test
