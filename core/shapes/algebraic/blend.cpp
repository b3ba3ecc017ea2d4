#include "core/shapes/algebraic/blend.h"

#include <cmath>

#include "core/formulas/parse.h"
#include "core/formulas/symbol.h"
#include "core/math/powers.h"

namespace tia {
namespace {

// ---- signed distance functions: below 0 inside, and outside no farther than the surface is
// ----------------

// Of a box and a cylinder that of their faces; beyond an edge it is nearer than the surface.
Symbol distance(const Sphere& sphere, const SymbolPoint& p) {
  return length(p - sphere.center) - sphere.radius;
}
Symbol distance(const Box& box, const SymbolPoint& p) {
  const Vec3d half = (box.max - box.min) * 0.5;
  const SymbolPoint q = p - (box.min + box.max) * 0.5;
  return greater(greater(abs(q.x) - half.x, abs(q.y) - half.y), abs(q.z) - half.z);
}
Symbol distance(const Cylinder& cylinder, const SymbolPoint& p) {
  const Vec3d axis = cylinder.cap - cylinder.base;
  const Onb frame = onb_around(unit(axis));
  const SymbolPoint q = p - (cylinder.base + cylinder.cap) * 0.5;
  const Symbol aside = hypot(dot(q, frame.u), dot(q, frame.v)) - cylinder.radius;
  return greater(aside, abs(dot(q, frame.n)) - length(axis) / 2);
}
Symbol distance(const Capsule& capsule, const SymbolPoint& p) {
  const Vec3d axis = capsule.cap - capsule.base;
  const SymbolPoint q = p - capsule.base;
  const double square = dot(axis, axis);
  if (square == 0) return length(q) - capsule.radius;
  const Symbol share = lesser(greater(dot(q, axis * (1 / square)), 0), 1);
  const SymbolPoint off{q.x - share * axis.x, q.y - share * axis.y, q.z - share * axis.z};
  return length(off) - capsule.radius;
}
Symbol distance(const Torus& torus, const SymbolPoint& p) {
  return hypot(hypot(p.x, p.z) - torus.major_radius, p.y) - torus.minor_radius;
}
// The formula itself, which is a distance as far as its writer has seen to that, within its bounds.
Symbol distance(const Implicit& implicit, const SymbolPoint& p) {
  const FormulaNames names{
      {"x", "y", "z"}, implicit.parameters, {p.x.number, p.y.number, p.z.number}};
  Faults faults;
  const Symbol f{p.x.builder, read_formula(implicit.f, names, {}, *p.x.builder, faults)};
  faults.raise();
  const auto within = [&](const auto& bound) { return distance(bound, p); };
  return greater(f, std::visit(within, prepare(implicit.bounds).kind));
}
Symbol distance(const Blend& blend, const SymbolPoint& p);

// ---- the children joined --------------------------------------------------------------------

// A length in the child's space is one in the blend's times the cube root of their volumes' ratio.
double scale_of(const Affine& place) { return pow_of(std::fabs(place.determinant()), 1.0 / 3); }

Symbol distance(const Blended& child, const SymbolPoint& p) {
  const Affine place = child.transform.affine();
  if (place == Affine{})
    return std::visit([&](const auto& own) { return distance(own, p); }, child.shape);
  const Affine to_child = place.inverse();
  const SymbolPoint q{dot(p, {to_child.x.x, to_child.y.x, to_child.z.x}) + to_child.offset.x,
                      dot(p, {to_child.x.y, to_child.y.y, to_child.z.y}) + to_child.offset.y,
                      dot(p, {to_child.x.z, to_child.y.z, to_child.z.z}) + to_child.offset.z};
  return std::visit([&](const auto& own) { return distance(own, q); }, child.shape) *
         scale_of(place);
}

Symbol united(const std::vector<Symbol>& d, double radius) {
  Symbol nearest = d.front();
  for (std::size_t i = 1; i < d.size(); ++i) nearest = lesser(nearest, d[i]);
  if (radius == 0 || d.size() == 1) return nearest;
  const auto depth = [&](const Symbol& each) { return greater(-each + radius, 0); };
  Symbol all = depth(d.front());
  for (std::size_t i = 1; i < d.size(); ++i) all = hypot(all, depth(d[i]));
  return greater(nearest, radius) - all;
}

Symbol distance(const Blend& blend, const SymbolPoint& p) {
  std::vector<Symbol> d;
  for (const Blended& child : blend.children) {
    const Symbol own = distance(child, p);
    const bool kept = blend.operation == Operation::union_ ||
                      (blend.operation == Operation::difference && !d.empty());
    d.push_back(kept ? own : -own);
  }
  const Symbol all = united(d, blend.radius);
  return blend.operation == Operation::union_ ? all : -all;
}

Aabb bounds_of(const Blended& child) {
  const auto own = []<class Kind>(const Kind& kind) {
    if constexpr (TellsBounds<Kind>) return bounds(kind);
    else return bounds(prepare(kind));
  };
  return bounds_of(child.transform.affine(), std::visit(own, child.shape));
}

}  // namespace

bool Blend::operator==(const Blend& other) const {
  return operation == other.operation && radius == other.radius && children == other.children;
}

void Blend::check(const Place& at, Faults& faults) const {
  ProgramBuilder builder;
  const SymbolPoint p{{&builder, builder.variable(0)},
                      {&builder, builder.variable(1)},
                      {&builder, builder.variable(2)}};
  distance(*this, p);
  if (builder.cost() > most_formula_cost)
    faults.add({FaultKind::limit, at.at("children").pointer(), std::nullopt,
                "children that cost less: some hundred in all"});
  if (bounds(*this).empty())
    faults.add({FaultKind::out_of_range, at.at("children").pointer(), std::nullopt,
                "children that have something in common"});
}

// Where n surfaces meet, the round reaches r (1 - 1 / sqrt n) out of them.
Aabb bounds(const Blend& blend) {
  Aabb box = bounds_of(blend.children.front());
  if (blend.operation == Operation::difference) return box;
  for (const Blended& child : blend.children)
    box = blend.operation == Operation::union_ ? around(box, bounds_of(child))
                                               : common(box, bounds_of(child));
  if (blend.operation == Operation::intersection) return box;
  const double n = static_cast<double>(blend.children.size());
  const double more = blend.radius * (1 - 1 / std::sqrt(n));
  return {box.min - Vec3d{more, more, more}, box.max + Vec3d{more, more, more}};
}

IsosurfaceForm prepare(const Blend& blend) {
  ProgramBuilder builder;
  const SymbolPoint p{{&builder, builder.variable(0)},
                      {&builder, builder.variable(1)},
                      {&builder, builder.variable(2)}};
  const Symbol f = distance(blend, p);
  const Aabb box = bounds(blend);
  const Vec3d more =
      box.size() * 0x1p-20;  // so that the surface does not lie in a face of the region
  return isosurface_form(builder.program({f.number}), Region{Box{box.min - more, box.max + more}});
}

}  // namespace tia
