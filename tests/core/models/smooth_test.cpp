// Shared normals of faces that meet at small angles.
#include "core/models/smooth.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/core/accel/meshes.h"

namespace tia {
namespace {

using namespace test;

SmoothVertices smoothed(const Mesh& mesh, double degrees) {
  return smooth(mesh.positions.values.get(), mesh.indices.values.get(), degrees);
}
Vec3d normal(const SmoothVertices& of, std::size_t vertex) {
  return {of.normals[3 * vertex], of.normals[3 * vertex + 1], of.normals[3 * vertex + 2]};
}
Vec3d normal_at_corner(const SmoothVertices& of, std::size_t corner) {
  return normal(of, of.indices[corner]);
}
void expect_close(const Vec3d& got, const Vec3d& expected, double most = 1e-12) {
  EXPECT_LE(length(got - expected), most)
      << testing::PrintToString(got) << " expected " << testing::PrintToString(expected);
}
// Every corner a vertex of its own.
Mesh in_pieces(const Mesh& mesh) {
  Mesh soup;
  for (const std::uint32_t i : mesh.indices.values) {
    const Vec3d p = test::place(mesh, i);
    soup.positions.values.insert(soup.positions.values.end(), {p.x, p.y, p.z});
  }
  std::vector<std::uint32_t> all(mesh.indices.values.size());
  std::iota(all.begin(), all.end(), 0U);
  soup.indices.values = all;
  return soup;
}

TEST(Smooth, CubeStaysFlatBelowItsRightAngles) {
  const Mesh cube = box_mesh({1, 1, 1});
  for (const double degrees : {0.0, 30.0, 89.9}) {
    const SmoothVertices flat = smoothed(cube, degrees);
    EXPECT_TRUE(flat.normals.empty());
    EXPECT_TRUE(flat.indices.empty());
  }
}

// By symmetry along the diagonals, whichever way its squares are cut.
TEST(Smooth, CornersOfACubeLookAlongItsDiagonalsAboveThem) {
  const Mesh cube = box_mesh({1, 1, 1});
  const SmoothVertices round = smoothed(cube, 90.1);
  EXPECT_EQ(round.from.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i)
    expect_close(normal(round, i), normalize(test::place(cube, round.from[i])));
}

// Where all neighbours of a corner lie on one ball, Max's weights give its radius exactly.
TEST(Smooth, NormalsOfABallAreItsRadii) {
  for (int times = 1; times < 4; ++times) {
    const Mesh ball = ball_mesh(times);
    for (const Mesh& mesh : {ball, in_pieces(ball)}) {
      const SmoothVertices round = smoothed(mesh, 60);
      ASSERT_EQ(round.normals.size(), 3 * round.from.size());
      EXPECT_EQ(round.from.size(), mesh.vertices());
      for (std::size_t i = 0; i < round.from.size(); ++i)
        expect_close(normal(round, i), test::place(mesh, round.from[i]));
    }
  }
}

// Two squares that meet at an angle along the z axis.
Mesh roof(double degrees) {
  const Vec3d down{cos_degrees(degrees), -sin_degrees(degrees), 0}, along{0, 0, 1};
  const Vec3d left{-1, 0, 0}, ridge{};
  return mesh_of({left, left + along, ridge, along, down, down + along},
                 {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}});
}
TEST(Smooth, FacesShareWhereTheyMeetAtLessThanTheAngle) {
  Random random(2221);
  for (int i = 0; i < 100; ++i) {
    const double bend = random.in(1, 170);
    EXPECT_TRUE(smoothed(roof(bend), bend - 0.01).normals.empty());
    const SmoothVertices shared = smoothed(roof(bend), bend + 0.01);
    const Vec3d left{0, 1, 0}, right{sin_degrees(bend), cos_degrees(bend), 0};
    ASSERT_EQ(shared.from.size(), 6U);
    expect_close(normal_at_corner(shared, 0), left);
    expect_close(normal_at_corner(shared, 11), right);
    expect_close(normal_at_corner(shared, 2), normalize(left + right), 1e-9);
  }
}

// A drum: its side is smooth, its lids stay flat, and what both touch is parted.
TEST(Smooth, VerticesArePartedWhereFacesMeetAtMore) {
  constexpr std::uint32_t n = 12;
  std::vector<Vec3d> places{{0, 1, 0}, {0, -1, 0}};
  std::vector<Triple> faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double turn = 360.0 * i / n;
    for (const double y : {1.0, -1.0}) places.push_back({cos_degrees(turn), y, sin_degrees(turn)});
    const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
    faces.insert(faces.end(), {{0, b, a}, {1, a + 1, b + 1}, {a, b, a + 1}, {b, b + 1, a + 1}});
  }
  const Mesh drum = mesh_of(places, faces);
  const SmoothVertices shared = smoothed(drum, 45);
  EXPECT_EQ(shared.from.size(), 2 + 4 * n);
  for (std::size_t corner = 0; corner < shared.indices.size(); ++corner) {
    const std::size_t face = corner / 3;
    const Vec3d p = test::place(drum, drum.indices.values[corner]);
    const Vec3d n_at = normal_at_corner(shared, corner);
    if (face % 4 < 2) expect_close(n_at, {0, face % 4 == 0 ? 1.0 : -1.0, 0});
    else expect_close(n_at, {p.x, 0, p.z}, 1e-9);
    EXPECT_EQ(shared.from[shared.indices[corner]], drum.indices.values[corner]);
  }
}

TEST(Smooth, WhatHasNoAreaAndEdgesOfManyFacesShareNothing) {
  Mesh mesh = roof(20);
  mesh.indices.values.insert(mesh.indices.values.end(), {2, 3, 3, 0, 0, 0});
  const SmoothVertices shared = smoothed(mesh, 30);
  expect_close(normal_at_corner(shared, 2),
               normalize(Vec3d{sin_degrees(20), 1 + cos_degrees(20), 0}), 1e-9);
  expect_close(normal_at_corner(shared, 15), {0, 0, 1});
  // Nine leaves of a book.
  std::vector<Vec3d> places{{0, 0, 0}, {0, 0, 1}};
  std::vector<Triple> faces;
  for (std::uint32_t i = 0; i < 9; ++i) {
    places.push_back({cos_degrees(i), sin_degrees(i), 0.5});
    faces.push_back({0, 1, 2 + i});
  }
  EXPECT_TRUE(smoothed(mesh_of(places, faces), 90).normals.empty());
  faces.pop_back();
  EXPECT_FALSE(smoothed(mesh_of(places, faces), 90).normals.empty());
}

// Two sheets back to back have nothing between them where all four faces of an edge share.
TEST(Smooth, NormalsThatComeToNothingAreTheFacesOwn) {
  const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-3}},
                            {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  const SmoothVertices shared = smoothed(mesh, 180);
  for (std::size_t i = 0; i < shared.from.size(); ++i)
    EXPECT_NEAR(length(normal(shared, i)), 1, 1e-12);
}

TEST(Smooth, ListsFollowTheirVertices) {
  const std::vector<std::uint32_t> from{1, 1, 0};
  EXPECT_EQ(taken(std::vector<double>{1, 2, 3, 4}, from, 2),
            (std::vector<double>{3, 4, 3, 4, 1, 2}));
  EXPECT_TRUE(taken(std::vector<float>{}, from, 4).empty());
}

}  // namespace
}  // namespace tia
