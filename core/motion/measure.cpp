#include "core/motion/measure.h"

#include <cmath>
#include <map>
#include <utility>

#include "core/math/deterministic.h"

namespace tia {
namespace {

Measure measure(const Sphere& s) { return {4 * pi / 3 * s.radius * s.radius * s.radius, s.center}; }

Measure measure(const Box& box) {
  const Vec3d size = box.max - box.min;
  return {size.x * size.y * size.z, (box.min + box.max) * 0.5};
}

// A frustum: pi h (a^2 + a b + b^2) / 3, its centre at h (a^2 + 2 a b + 3 b^2) / (4 (a^2 + a b +
// b^2)) above the base.
Measure measure(const Cone& cone) {
  const double a = cone.base_radius, b = cone.cap_radius;
  const double sum = a * a + a * b + b * b;
  const double share = (a * a + 2 * a * b + 3 * b * b) / (4 * sum);
  return {pi / 3 * length(cone.cap - cone.base) * sum, cone.base + (cone.cap - cone.base) * share};
}
Measure measure(const Cylinder& c) { return measure(Cone{c.base, c.cap, c.radius, c.radius}); }

Measure measure(const Capsule& c) {
  const double area = pi * c.radius * c.radius;
  return {area * (length(c.cap - c.base) + 4 * c.radius / 3), (c.base + c.cap) * 0.5};
}

// Pappus: the disc's area times the way of its centre.
Measure measure(const Torus& t) {
  return {2 * pi * pi * t.major_radius * t.minor_radius * t.minor_radius, {}};
}

/// Corners: those of a mesh's triangles, by place: what lies at one place is one corner, however
/// often it is listed.
class Corners {
 public:
  explicit Corners(const Mesh& mesh) : mesh_(mesh) {}
  Vec3d at(std::size_t corner) const {
    const auto& p = mesh_.positions.values.get();
    const std::size_t first = 3 * std::size_t{mesh_.indices.values.get()[corner]};
    return {p[first], p[first + 1], p[first + 2]};
  }
  std::size_t number(std::size_t corner) {
    const Vec3d p = at(corner);
    return places_.emplace(std::array{p.x, p.y, p.z}, places_.size()).first->second;
  }

 private:
  const Mesh& mesh_;
  std::map<std::array<double, 3>, std::size_t> places_;
};

// Whether each edge is run along as often one way as the other.
bool is_closed(const Mesh& mesh, Corners& corners) {
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (std::size_t i = 0; i < mesh.triangles(); ++i) {
    const std::array n{corners.number(3 * i), corners.number(3 * i + 1), corners.number(3 * i + 2)};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = n[k], to = n[(k + 1) % 3];
      edges[std::minmax(from, to)] += from < to ? 1 : from > to ? -1 : 0;
    }
  }
  for (const auto& [edge, turns] : edges)
    if (turns != 0) return false;
  return true;
}

// Tetrahedra from one corner to each triangle, signed. Source: Zhang, Chen, "Efficient feature
// extraction for 2D/3D objects in mesh representation" (2001), section 3.1.
std::optional<Measure> measure(const Mesh& mesh) {
  Corners corners(mesh);
  if (!is_closed(mesh, corners)) return std::nullopt;
  const Vec3d tip = corners.at(0);
  double six_volumes = 0;
  Vec3d moment{};
  for (std::size_t i = 0; i < mesh.triangles(); ++i) {
    const Vec3d a = corners.at(3 * i) - tip, b = corners.at(3 * i + 1) - tip,
                c = corners.at(3 * i + 2) - tip;
    const double six = dot(a, cross(b, c));
    six_volumes += six;
    moment = moment + (a + b + c) * six;
  }
  if (six_volumes == 0) return std::nullopt;
  return Measure{std::abs(six_volumes) / 6, tip + moment * (0.25 / six_volumes)};
}

}  // namespace

std::optional<Measure> measure_of(const Shape& shape) {
  return std::visit(
      [](const auto& kind) -> std::optional<Measure> {
        if constexpr (requires { measure(kind); }) return measure(kind);
        else return std::nullopt;
      },
      shape);
}

std::string measured_shapes() {
  return "sphere, box, cylinder, cone, capsule, torus or a mesh that is closed";
}

}  // namespace tia
