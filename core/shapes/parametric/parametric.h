// The parametric surface: three formulas of u and v. A line's hits are solutions of a system of
// equations, found patch by patch.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/input/codec.h"
#include "core/parallel/per_thread.h"
#include "core/shapes/parametric/parametric_form.h"

namespace tia {

/// Parametric. Surface: (x, y, z)(u, v) for u and v in their ranges; its outer side is that of
/// S_u x S_v. Where a formula is undefined there is nothing. Space/units: scene units, object
/// space.
struct Parametric {
  static constexpr std::string_view type = "parametric";
  std::string x, y, z;
  std::array<double, 2> u{}, v{};
  std::map<std::string, double> parameters;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    constexpr Spec u_range{
        .about =
            "from where to where u runs, both ends included. Nothing is periodic: a surface is "
            "closed where its formulas come to the same points at both ends, as those of cos(u) "
            "and sin(u) do from 0 to 6.283185307179586",
        .min = -1e9,
        .max = 1e9,
        .required = true};
    constexpr Spec v_range{
        .about =
            "from where to where v runs, as u does. Seen from the outer side it runs to the left "
            "of u, counter-clockwise, as y does of x: a closed surface that has its outer side "
            "inside wants -v for v in its formulas, from -to to -from",
        .min = -1e9,
        .max = 1e9,
        .required = true};
    visit(
        "x", &Parametric::x,
        Spec{.about = "a formula of u and v, as implicit's f is one of x, y, z", .required = true});
    visit("y", &Parametric::y, Spec{.about = "a formula of u and v", .required = true});
    visit("z", &Parametric::z, Spec{.about = "a formula of u and v", .required = true});
    visit("u", &Parametric::u, u_range);
    visit("v", &Parametric::v, v_range);
    visit("parameters", &Parametric::parameters,
          Spec{.about = "numbers by the names that the formulas have for them",
               .min = -1e30,
               .max = 1e30});
  }
  /// Formulas that cannot be read; parameters whose names they cannot say; an empty range.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Parametric&) const = default;
};

ParametricForm prepare(const Parametric& parametric);
inline int elements(const ParametricForm& form) {
  return static_cast<int>(form.patches->patches.size());
}
inline Aabb bounds(const ParametricForm& form) { return form.patches->box; }
inline int work_of(const ParametricForm&) { return 8; }

/// All hits between after and before, ascending; only the first where that is enough.
/// Cost: bounded by what a line may take, beyond which small patches count as hit where their box
/// is.
std::int64_t hits(const ParametricForm& form, const Line& line, double after, double before,
                  bool first_only, std::vector<SurfaceHit>& found);

template <class Emit>
std::int64_t crossings(const ParametricForm& form, const Line& line, Emit&& emit) {
  auto& found = per_thread<std::vector<SurfaceHit>, struct All>();
  const std::int64_t work = hits(form, line, -Aabb::far, Aabb::far, false, found);
  for (const SurfaceHit& each : found) emit_root(emit, each.at.t, each.at.element, each.bracket);
  return work;
}
FirstCrossing first_crossing(const ParametricForm& form, const Line& line, double after,
                             double before);

Vec3d normal(const ParametricForm& form, const Vec3d& p, int element);
/// Returns: u and v, each from 0 at the start of its range to 1 at the end.
Vec2d uv(const ParametricForm& form, const Vec3d& p, int element);

static_assert(IsForm<ParametricForm>);
static_assert(TellsWork<ParametricForm>);
static_assert(FindsFirstCrossing<ParametricForm>);

}  // namespace tia
