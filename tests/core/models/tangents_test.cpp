// Tangents by MikkTSpace: against its reference's numbers, and against sums written out.
#include "core/models/tangents.h"

#include <gtest/gtest.h>

#include "tests/core/accel/meshes.h"

namespace tia {
namespace {

using namespace test;

/// BentGrid: n x n squares in two triangles each, and what tangents need of them.
struct BentGrid {
  std::vector<double> positions, normals, uvs;
  std::vector<std::uint32_t> indices;

  /// `place`, `normal` and `uv` of (x, y), each 0 to 1.
  template <class Place, class Normal, class Uv>
  BentGrid(std::uint32_t n, Place place, Normal normal, Uv uv) {
    for (std::uint32_t y = 0; y <= n; ++y)
      for (std::uint32_t x = 0; x <= n; ++x) {
        const Vec2d at{double(x) / n, double(y) / n};
        for (const Vec3d& v : {place(at)}) positions.insert(positions.end(), {v.x, v.y, v.z});
        for (const Vec3d& v : {normal(at)}) normals.insert(normals.end(), {v.x, v.y, v.z});
        for (const Vec2d& v : {uv(at)}) uvs.insert(uvs.end(), {v.u, v.v});
      }
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        const std::uint32_t i = y * (n + 1) + x;
        indices.insert(indices.end(), {i, i + 1, i + n + 2, i, i + n + 2, i + n + 1});
      }
  }
  TangentVertices tangents() const { return tangents_of({positions, normals, uvs, indices}); }
};
Vec3d triple_in(const std::vector<double>& list, std::size_t i) {
  return {list[3 * i], list[3 * i + 1], list[3 * i + 2]};
}
Vec3d tangent_in(const TangentVertices& made, std::size_t vertex) {
  const double* at = &made.tangents[4 * vertex];
  return {at[0], at[1], at[2]};
}

// What npm mikktspace 1.1.1 (generateTangents, every corner a vertex of its own) makes of it, of
// which the sign stands as it is for v upward: a seam of mirrored uvs, a face whose uvs have no
// area and one whose corners are two.
TEST(Tangents, AreTheReferencesAtEveryCorner) {
  const std::vector<double> positions{0.11, 0.11, 0.33, 1.07, 0.27, 0,    2.07, 0.24, 0.24,
                                      0.3,  1.35, 0,    1.27, 1.32, 0.4,  2.03, 1.24, 0.41,
                                      0.25, 2.23, 0.41, 1.22, 2.09, 0.47, 2.25, 2.03, 0.16};
  const std::vector<double> normals{0.01, 0.12,  1, 0.14, -0.02, 1, 0,    -0.01, 1,
                                    0.16, -0.27, 1, 0.05, 0.28,  1, 0.04, -0.02, 1,
                                    0.1,  0.05,  1, 0.27, -0.08, 1, 0.14, 0.27,  1};
  const std::vector<double> uvs{1.04, 0.16, 0,    0.25, 1.08, 0.28, 1.06, 1.04, 0,
                                1.16, 1.03, 1.25, 1.02, 2.2,  0,    2.24, 0,    2.24};
  const std::vector<std::uint32_t> indices{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 3, 4,
                                           7, 3, 7, 6, 4, 5, 8, 4, 8, 7, 4, 4, 0};
  const std::vector<std::array<double, 4>> reference{{-0.99666, 0.08169, 0.00016, -1},
                                                     {-0.98913, -0.05232, 0.13743, -1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {-0.99666, 0.08169, 0.00016, -1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {-0.98417, 0.04829, 0.17051, -1},
                                                     {0.98121, -0.13271, -0.14002, 1},
                                                     {0.99829, -0.0584, -0.00058, 1},
                                                     {0.98323, -0.17723, -0.04287, 1},
                                                     {0.98121, -0.13271, -0.14002, 1},
                                                     {0.98323, -0.17723, -0.04287, 1},
                                                     {0.97513, -0.22124, 0.01319, 1},
                                                     {-0.98417, 0.04829, 0.17051, -1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {-0.95612, 0.1191, 0.26768, -1},
                                                     {-0.98417, 0.04829, 0.17051, -1},
                                                     {-0.95612, 0.1191, 0.26768, -1},
                                                     {-0.97948, 0.18087, 0.0889, -1},
                                                     {0.97513, -0.22124, 0.01319, 1},
                                                     {0.98323, -0.17723, -0.04287, 1},
                                                     {0.9696, -0.23365, -0.07266, 1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {1, 0, 0, -1},
                                                     {-0.95612, 0.1191, 0.26768, -1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {-0.98318, 0.18265, -0.00198, -1},
                                                     {-0.99666, 0.08169, 0.00016, -1}};
  const TangentVertices made = tangents_of({positions, normals, uvs, indices});
  ASSERT_EQ(made.indices.size(), indices.size());
  ASSERT_EQ(made.tangents.size(), positions.size() / 3 * 4 + 4 * made.from.size());
  for (std::size_t c = 0; c < indices.size(); ++c) {
    const std::uint32_t vertex = made.indices[c];
    EXPECT_EQ(vertex < 9 ? vertex : made.from[vertex - 9], indices[c]);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(made.tangents[4 * vertex + k], reference[c][k], 1e-4) << "corner " << c;
  }
}

// uv = A (x, y): u grows along the first column of A's inverse, everywhere.
TEST(Tangents, OfAPlaneAreTheWayInWhichUGrows) {
  Random random(2008);
  for (int i = 0; i < 100; ++i) {
    const double a = random.in(-1, 1), b = random.in(-1, 1), c = random.in(-1, 1);
    const double d = random.in(-1, 1), area = a * d - b * c;
    const BentGrid plane(
        4,
        [](const Vec2d& p) {
          return Vec3d{p.u, p.v, 0};
        },
        [](const Vec2d&) {
          return Vec3d{0, 0, 2};
        },
        [&](const Vec2d& p) {
          return Vec2d{a * p.u + b * p.v, c * p.u + d * p.v};
        });
    for (const bool flat : {false, true}) {
      BentGrid grid = plane;
      if (flat) grid.normals.clear();
      const TangentVertices made = grid.tangents();
      EXPECT_TRUE(made.from.empty());
      for (std::size_t k = 0; k < 25; ++k) {
        EXPECT_LE(length(tangent_in(made, k) - normalize(Vec3d{d, -c, 0} * (1 / area))), 1e-9);
        EXPECT_EQ(made.tangents[4 * k + 3], area > 0 ? 1 : -1);
      }
    }
  }
}

double angle(const Vec3d& a, const Vec3d& b) { return std::acos(dot(a, b)); }
Vec3d level(const Vec3d& v, const Vec3d& n) { return normalize(v - n * dot(v, n)); }

// The mean over the faces around a vertex of where u grows, weighted by their angles, all of them
// in the plane of its normal.
TEST(Tangents, OfABentSheetAreTheMeansOfTheFacesAround) {
  const auto place = [](const Vec2d& p) {
    return Vec3d{p.u, p.v, 0.3 * p.u * p.u - 0.2 * p.u * p.v};
  };
  const BentGrid grid(
      5, place,
      [](const Vec2d& p) {
        return normalize(Vec3d{0.2 * p.v - 0.6 * p.u, 0.2 * p.u, 1});
      },
      [](const Vec2d& p) {
        return Vec2d{p.u + 0.2 * p.v * p.v, p.v + 0.3 * p.u * p.v};
      });
  std::vector<Vec3d> sums(grid.positions.size() / 3);
  for (std::size_t c = 0; c < grid.indices.size(); ++c) {
    const std::size_t first = c / 3 * 3, i = grid.indices[c];
    const std::size_t j = grid.indices[first + (c + 1) % 3], k = grid.indices[first + (c + 2) % 3];
    const Vec3d n = triple_in(grid.normals, i);
    const Vec3d e = triple_in(grid.positions, j) - triple_in(grid.positions, i);
    const Vec3d f = triple_in(grid.positions, k) - triple_in(grid.positions, i);
    const double ev = grid.uvs[2 * j + 1] - grid.uvs[2 * i + 1];
    const double fv = grid.uvs[2 * k + 1] - grid.uvs[2 * i + 1];
    sums[i] = sums[i] + level(e * fv - f * ev, n) * angle(level(e, n), level(f, n));
  }
  const TangentVertices made = grid.tangents();
  EXPECT_EQ(made.indices, grid.indices) << "nothing is parted";
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_LE(length(tangent_in(made, i) - normalize(sums[i])), 1e-12);
}

TEST(Tangents, VerticesWhereUvsAreMirroredArePartedAndTheTwoFaceEachOther) {
  const BentGrid grid(
      4,
      [](const Vec2d& p) {
        return Vec3d{p.u, p.v, 0};
      },
      [](const Vec2d&) {
        return Vec3d{0, 0, 1};
      },
      [](const Vec2d& p) {
        return Vec2d{std::fabs(p.u - 0.5), p.v};
      });
  const TangentVertices made = grid.tangents();
  EXPECT_EQ(made.from.size(), 5U) << "those in the middle column";
  for (std::size_t c = 0; c < made.indices.size(); ++c) {
    const std::size_t square = c / 6, vertex = made.indices[c];
    const double side = square % 4 < 2 ? -1 : 1;
    EXPECT_LE(length(tangent_in(made, vertex) - Vec3d{side, 0, 0}), 1e-12);
    EXPECT_EQ(made.tangents[4 * vertex + 3], side);
  }
}

}  // namespace
}  // namespace tia
