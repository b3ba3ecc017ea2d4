#include "core/shapes/parametric/parametric.h"

#include <algorithm>
#include <cmath>

#include "core/formulas/parse.h"
#include "core/math/onb.h"
#include "core/parallel/per_thread.h"
#include "core/shapes/parametric/patch_search.h"

namespace tia {
namespace {

FormulaNames names_of(const Parametric& p) { return {{"u", "v"}, p.parameters}; }

Rectangle domain_of(const Parametric& p) {
  return {(p.u[0] + p.u[1]) / 2, (p.v[0] + p.v[1]) / 2, (p.u[1] - p.u[0]) / 2,
          (p.v[1] - p.v[0]) / 2};
}

void check_range(const std::array<double, 2>& range, const Place& at, Faults& faults) {
  if (!(range[0] < range[1]))
    faults.add(
        {FaultKind::out_of_range, at.pointer(), write_value(range), "[from, to], from below to"});
}

}  // namespace

void Parametric::check(const Place& at, Faults& faults) const {
  check_formulas({{"x", x}, {"y", y}, {"z", z}}, names_of(*this), at, faults);
  check_range(u, at.at("u"), faults);
  check_range(v, at.at("v"), faults);
}

ParametricForm prepare(const Parametric& p) {
  ParametricForm form{program_of({p.x, p.y, p.z}, names_of(p)), domain_of(p), nullptr};
  form.patches = std::make_shared<const SurfacePatches>(patches_of(form.surface, form.domain));
  return form;
}

std::int64_t hits(const ParametricForm& form, const Line& line, double after, double before,
                  bool first_only, std::vector<SurfaceHit>& found) {
  found.clear();
  detail::PatchSearch search(form, line, after, before, first_only, found);
  const std::int64_t nodes = traverse(form.patches->tree, line, after, before,
                                      [&](std::uint32_t leaf, double, double, double) {
                                        return search.visit(static_cast<int>(leaf));
                                      });
  const Vec3d size = form.patches->box.size();
  // A seam's hit is found by both patches, which agree to about 1e-14 of the size.
  detail::put_in_order(found, 1e-10 * std::max({size.x, size.y, size.z}));
  return 4 * nodes + search.work();
}

FirstCrossing first_crossing(const ParametricForm& form, const Line& line, double after,
                             double before) {
  auto& found = per_thread<std::vector<SurfaceHit>, struct First>();
  FirstCrossing first;
  first.work = hits(form, line, after, before, true, found);
  if (!found.empty()) first.at = found.front().at;
  return first;
}

namespace {

// The point of the patch that is nearest to p, by the Gauss-Newton method from the patch's middle.
// It ends with a step of 1e-9 of the patch, whose error is about the step's square.
detail::SurfaceAt nearest_on(const ParametricForm& form, const Vec3d& p, int element) {
  constexpr int most_steps = 12;
  const SurfacePatch& patch = form.patches->patches[static_cast<std::size_t>(element)];
  const Rectangle& r = patch.where;
  double u = r.u, v = r.v;
  detail::SurfaceAt at = detail::surface_at(form.surface, u, v);
  for (int i = 0; i < most_steps; ++i) {
    const Vec3d off = p - at.point;
    const double uu = dot(at.by_u, at.by_u), uv = dot(at.by_u, at.by_v);
    const double vv = dot(at.by_v, at.by_v), inverse = 1 / (uu * vv - uv * uv);
    const double ru = dot(at.by_u, off), rv = dot(at.by_v, off);
    const double du = (vv * ru - uv * rv) * inverse, dv = (uu * rv - uv * ru) * inverse;
    if (!std::isfinite(du) || !std::isfinite(dv)) break;
    const double next_u = std::clamp(u + du, r.u - r.half_u, r.u + r.half_u);
    const double next_v = std::clamp(v + dv, r.v - r.half_v, r.v + r.half_v);
    const bool there =
        std::fabs(next_u - u) <= 1e-9 * r.half_u && std::fabs(next_v - v) <= 1e-9 * r.half_v;
    u = next_u, v = next_v;
    at = detail::surface_at(form.surface, u, v);
    if (there) break;
  }
  return at;
}

}  // namespace

// At a pole, where the derivatives' cross product vanishes, the normal of the patch's middle is
// taken.
Vec3d normal(const ParametricForm& form, const Vec3d& p, int element) {
  const detail::SurfaceAt at = nearest_on(form, p, element);
  const SurfacePatch& patch = form.patches->patches[static_cast<std::size_t>(element)];
  const Vec3d whole = cross(patch.by_u, patch.by_v), own = cross(at.by_u, at.by_v);
  const auto usable = [](const Vec3d& n) { return dot(n, n) > 0 && std::isfinite(dot(n, n)); };
  // A cross product of 1e-8 of the patch's own has lost half of double's digits.
  const bool vanishes = dot(own, own) <= 1e-16 * dot(whole, whole);
  const Vec3d& n = usable(own) && !(usable(whole) && vanishes) ? own : whole;
  return usable(n) ? unit(n) : Vec3d{0, 1, 0};
}

Vec2d uv(const ParametricForm& form, const Vec3d& p, int element) {
  const detail::SurfaceAt at = nearest_on(form, p, element);
  const Rectangle& d = form.domain;
  const auto share = [](double x, double middle, double half) {
    return std::clamp((x - middle) / (2 * half) + 0.5, 0.0, 1.0);
  };
  return {share(at.u, d.u, d.half_u), share(at.v, d.v, d.half_v)};
}

std::size_t heap_bytes(const ParametricForm& form) {
  return heap_bytes(form.surface.instructions) + heap_bytes(form.surface.results) + 2 * heap_block +
         sizeof(SurfacePatches) + heap_bytes(form.patches->tree.nodes) +
         heap_bytes(form.patches->patches);
}

}  // namespace tia
