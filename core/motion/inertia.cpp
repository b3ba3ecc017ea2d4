#include "core/motion/inertia.h"

#include <cmath>
#include <utility>

namespace tia {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

std::array<double, 3> parts_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

void add_square(const Vec3d& v, double weight, Matrix3& to) {
  const auto p = parts_of(v);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) to[i][j] += weight * p[i] * p[j];
}

/// Eigen: a symmetric matrix' eigenvalues, and its eigenvectors as columns.
struct Eigen {
  Vec3d values;
  Matrix3 vectors;
};

// Turns by which the largest element off the diagonal becomes 0, again and again.
// Source: Golub, Van Loan, "Matrix Computations" (4th edition, 2013), section 8.5, Jacobi's method.
Eigen eigen_of(Matrix3 m) {
  Matrix3 v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int turns = 60;  // it doubles its digits with every three
  for (int turn = 0; turn < turns; ++turn) {
    std::size_t p = 0, q = 1;
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 2}, {1, 2}})
      if (std::abs(m[i][j]) > std::abs(m[p][q])) p = i, q = j;
    if (m[p][q] == 0) break;
    const double tau = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
    const double c = 1 / std::sqrt(1 + t * t), s = t * c;
    const auto mix = [&](double& a, double& b) {
      a = std::exchange(b, s * a + c * b) * -s + c * a;
    };
    for (auto& row : m) mix(row[p], row[q]);
    for (std::size_t k = 0; k < 3; ++k) mix(m[p][k], m[q][k]);
    for (auto& row : v) mix(row[p], row[q]);
  }
  return {{m[0][0], m[1][1], m[2][2]}, v};
}

// Volume, first and second moments of the tetrahedra from the origin to each triangle.
struct Moments {
  double volume = 0;
  Vec3d first{};
  Matrix3 second{};
};

Moments moments_of(const std::vector<Vec3d>& points,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles, const Vec3d& from) {
  Moments sum;
  for (const auto& [i, j, k] : triangles) {
    const Vec3d a = points[i] - from, b = points[j] - from, c = points[k] - from;
    const double six = dot(a, cross(b, c));
    sum.volume += six / 6;
    sum.first = sum.first + (a + b + c) * (six / 24);
    add_square(a + b + c, six / 120, sum.second);
    for (const Vec3d& corner : {a, b, c}) add_square(corner, six / 120, sum.second);
  }
  return sum;
}

}  // namespace

Vec3d sphere_moments(double mass, double radius) {
  const double each = 2.0 / 5 * mass * radius * radius;
  return {each, each, each};
}

Vec3d box_moments(double mass, const Vec3d& half) {
  const Vec3d square = half * half;
  return Vec3d{square.y + square.z, square.z + square.x, square.x + square.y} * (mass / 3);
}

Vec3d cylinder_moments(double mass, double radius, double height) {
  const double across = mass * (3 * radius * radius + height * height) / 12;
  return {across, mass * radius * radius / 2, across};
}

Vec3d cone_moments(double mass, double radius, double height) {
  const double across = 3.0 / 80 * mass * (4 * radius * radius + height * height);
  return {across, 3.0 / 10 * mass * radius * radius, across};
}

Vec3d capsule_moments(double mass, double radius, double height) {
  const double share = height / (height + 4 * radius / 3);  // of the cylinder
  const double middle = mass * share, ends = mass - middle, square = radius * radius;
  const double across = middle * (3 * square + height * height) / 12 +
                        ends * (2 * square / 5 + height * height / 4 + 3 * height * radius / 8);
  return {across, middle * square / 2 + ends * 2 * square / 5, across};
}

Inertia mesh_inertia(double mass, const std::vector<Vec3d>& points,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const Moments about_corner = moments_of(points, triangles, points.front());
  const Vec3d center = points.front() + about_corner.first * (1 / about_corner.volume);
  const Moments sum = moments_of(points, triangles, center);
  Matrix3 second = sum.second;
  for (auto& row : second)
    for (double& each : row) each *= mass / sum.volume;
  const auto [square, v] = eigen_of(second);
  Vec3d x{v[0][0], v[1][0], v[2][0]}, y{v[0][1], v[1][1], v[2][1]};
  return {{x, y, cross(x, y), center},
          {square.y + square.z, square.z + square.x, square.x + square.y}};
}

}  // namespace tia
