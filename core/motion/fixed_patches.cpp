#include "core/motion/fixed_patches.h"

#include <algorithm>
#include <bit>
#include <set>

#include "core/boxes/bvh_builder.h"
#include "core/math/onb.h"

namespace tia {
namespace {

using Patches = std::vector<ContactPatch>;

// A convex polygon with its corners in order, around its normal.
PlanePatch polygon(std::span<const Vec3d> corners, const Vec3d& normal) {
  PlanePatch patch{corners[0], normal};
  patch.box = {};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d side = corners[(i + 1) % corners.size()] - corners[i];
    patch.inward[i] = unit(cross(normal, side));
    patch.offset[i] = dot(patch.inward[i], corners[i]);
    patch.box = around(patch.box, corners[i]);
  }
  patch.sides = static_cast<int>(corners.size());
  return patch;
}
// Nothing where both ends are one.
void add_edge(const Vec3d& a, const Vec3d& b, Patches& out) {
  if (a == b) return;
  const Vec3d axis = unit(b - a);
  out.push_back(CylinderPatch{a, axis, dot(axis, b - a), 0});
}
PlanePatch disc(const Vec3d& center, const Vec3d& normal, double radius) {
  PlanePatch patch{center, normal};
  patch.disc_radius = radius;
  const Vec3d reach{radius, radius, radius};
  patch.box = {center - reach, center + reach};
  return patch;
}

void add(const FixedPlane& plane, Patches& out) {
  out.push_back(PlanePatch{plane.point, unit(plane.normal)});
}
void add(const FixedSphere& ball, Patches& out) {
  out.push_back(SpherePatch{ball.center, ball.radius});
}
void add(const FixedBox& box, Patches& out) {
  const auto corner = [&](unsigned bits) {
    Vec3d p = box.corner;
    for (std::size_t k = 0; k < 3; ++k)
      if ((bits >> k & 1) != 0) p = p + box.edges[k];
    return p;
  };
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned u = 1U << (k + 1) % 3, v = 1U << (k + 2) % 3;
    const Vec3d normal = unit(cross(box.edges[(k + 1) % 3], box.edges[(k + 2) % 3]));
    for (const unsigned side : {0U, 1U << k})
      out.push_back(polygon(
          std::array{corner(side), corner(side | u), corner(side | u | v), corner(side | v)},
          normal));
  }
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned from = 0; from < 8; ++from)
      if ((from >> k & 1) == 0) add_edge(corner(from), corner(from | 1U << k), out);
  for (unsigned i = 0; i < 8; ++i) out.push_back(SpherePatch{corner(i), 0});
}
void add(const FixedCylinder& c, Patches& out) {
  const Vec3d axis = unit(c.cap - c.base);
  out.push_back(CylinderPatch{c.base, axis, dot(axis, c.cap - c.base), c.radius});
  for (const Vec3d& end : {c.base, c.cap}) out.push_back(disc(end, axis, c.radius));
  for (const Vec3d& end : {c.base, c.cap}) out.push_back(CirclePatch{end, axis, c.radius});
}
void add(const FixedCapsule& c, Patches& out) {
  if (c.base == c.cap) return add(FixedSphere{c.base, c.radius}, out);
  const Vec3d axis = unit(c.cap - c.base);
  out.push_back(CylinderPatch{c.base, axis, dot(axis, c.cap - c.base), c.radius});
  out.push_back(SpherePatch{c.base, c.radius, -axis});
  out.push_back(SpherePatch{c.cap, c.radius, axis});
}
// Edges and corners that triangles share are there once.
void add(const FixedMesh& mesh, Patches& out) {
  std::set<std::array<std::uint32_t, 2>> edges;
  std::set<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles) {
    const std::array at{mesh.points[triangle[0]], mesh.points[triangle[1]],
                        mesh.points[triangle[2]]};
    const Vec3d normal = cross(at[1] - at[0], at[2] - at[0]);
    if (normal != Vec3d{}) out.push_back(polygon(at, unit(normal)));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.insert({low, high});
      corners.insert(low);
    }
    corners.insert(*std::max_element(triangle.begin(), triangle.end()));
  }
  for (const auto& [a, b] : edges) add_edge(mesh.points[a], mesh.points[b], out);
  for (const std::uint32_t corner : corners) out.push_back(SpherePatch{mesh.points[corner], 0});
}

// Those of eight boxes that meet a box, as bits.
unsigned met_of(const BoxSet& boxes, const Box32& box) {
  using detail::Eight;
  const std::array low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z};
  unsigned met = (1U << boxes.count) - 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    met &= detail::at_most(Eight::load_unaligned(boxes.face(axis)), Eight(high[axis]));
    met &= detail::at_most(Eight(low[axis]), Eight::load_unaligned(boxes.face(axis + 3)));
  }
  return met;
}

}  // namespace

std::vector<ContactPatch> patches_of(const FixedShape& shape) {
  Patches out;
  std::visit([&](const auto& kind) { add(kind, out); }, shape);
  return out;
}

FixedPatches::FixedPatches(const std::vector<FixedShape>& fixed) {
  std::vector<Box32> boxes;
  for (std::size_t thing = 0; thing < fixed.size(); ++thing) {
    for (ContactPatch& patch : patches_of(fixed[thing])) {
      const Aabb box = bounds_of(patch);
      const auto number = static_cast<std::uint32_t>(patches_.size());
      if (box.bounded()) {
        bounded_.push_back(number);
        boxes.push_back(enclosing(box));
        bounds_ = around(bounds_, box);
      } else {
        endless_.push_back(number);
      }
      patches_.push_back(std::move(patch));
      owners_.push_back(thing);
    }
  }
  if (!boxes.empty()) tree_ = build_bvh(boxes);
}

void FixedPatches::gather(const Aabb& box, std::vector<std::uint32_t>& found) const {
  found = endless_;
  if (tree_.nodes.empty()) return;
  const Box32 wanted = enclosing(box);
  std::array<std::uint32_t, Bvh::deepest * BoxSet::size> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Bvh::Node& node = tree_.nodes[waiting[--count]];
    for (unsigned met = met_of(node.boxes, wanted); met != 0; met &= met - 1) {
      const BvhChild child = node.children[static_cast<std::size_t>(std::countr_zero(met))];
      if (!child.is_leaf()) waiting[count++] = child.first();
      for (std::uint32_t i = 0; i < child.count(); ++i)
        found.push_back(bounded_[tree_.order[child.first() + i]]);
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace tia
