// The crossings of a line with a surface f(x, y, z) = 0: of implicit, explicit and blended shapes.
// All roots are found: boxes that provably have none are left out, and a stretch of the line is
// divided until the interval of its slope proves that it has at most one.
#pragma once

#include "core/shapes/eight_lines.h"
#include "core/shapes/formula/isosurface_form.h"

namespace tia {

IsosurfaceForm isosurface_form(Program function, const Region& region);

inline int elements(const IsosurfaceForm& f) { return 1 + elements(f.region); }
inline Aabb bounds(const IsosurfaceForm& f) { return bounds(f.region); }
inline int work_of(const IsosurfaceForm&) { return 8; }

namespace detail {

/// Returns: the work.
std::int64_t follow(const IsosurfaceForm& form, const Line& line, const IsosurfaceStretch& stretch,
                    IsosurfaceListener& listener);
bool is_inside(const IsosurfaceForm& form, const Vec3d& p);

template <class F>
class CallbackListener final : public IsosurfaceListener {
 public:
  explicit CallbackListener(F f) : f_(f) {}
  bool on_event(const IsosurfaceEvent& event) override { return f_(event); }

 private:
  F f_;
};

}  // namespace detail

/// The surface's crossings within the region. They need not come in pairs, so CSG uses spans.
/// A root where f touches 0 without changing its sign is emitted twice. Roots are told apart that
/// are at least 2^-40 of the region's size apart, as far as the rounding of f allows.
/// Cost: bounded for each line; once that is spent, what is left is judged by the signs of f at the
/// ends of its pieces alone.
template <class Emit>
std::int64_t crossings(const IsosurfaceForm& form, const Line& line, Emit&& emit) {
  const Chord within = chord(form.region, line);
  if (within.empty()) return 0;
  detail::CallbackListener listener([&](const IsosurfaceEvent& event) {
    if (event.is_root) emit_root(emit, event.t, 0, event.bracket);
    return true;
  });
  return detail::follow(form, line, {within.in.t, within.out.t}, listener);
}
/// The first crossings of eight lines: bracketed line by line, then found for all eight at once.
EightCrossings first_crossings(const IsosurfaceForm& form, const EightLines& eight);
inline FirstCrossing first_crossing(const IsosurfaceForm& form, const Line& line, double after,
                                    double before) {
  return first_crossings(form, EightLines::one(line, after, before)).one();
}

/// The crossings of the solid, which is inside of the surface and of the region, whose faces close
/// it.
template <class Emit>
std::int64_t spans(const IsosurfaceForm& form, const Line& line, Emit&& emit) {
  const Chord within = chord(form.region, line);
  if (within.empty()) return 0;
  bool inside = detail::is_inside(form, line.at(within.in.t));
  if (inside) emit(within.in.t, within.in.element);
  detail::CallbackListener listener([&](const IsosurfaceEvent& event) {
    if (event.inside != inside) emit_root(emit, event.t, 0, event.bracket);
    inside = event.inside;
    return true;
  });
  const std::int64_t work = detail::follow(form, line, {within.in.t, within.out.t}, listener);
  if (inside) emit(within.out.t, within.out.element);
  return work;
}

/// The gradient's direction; where it is 0, at a singular point, or undefined: +y.
Vec3d normal(const IsosurfaceForm& form, const Vec3d& p, int element);
Vec3<Octet> normals(const IsosurfaceForm& form, const Vec3<Octet>& p);
/// Returns: longitude and latitude, as a sphere has them, around the middle of the region; on the
/// region's faces theirs.
Vec2d uv(const IsosurfaceForm& form, const Vec3d& p, int element);

static_assert(IsForm<IsosurfaceForm>);
static_assert(TellsWork<IsosurfaceForm>);
static_assert(HasSpans<IsosurfaceForm>);
static_assert(FindsFirstCrossing<IsosurfaceForm>);
static_assert(FindsEightFirstCrossings<IsosurfaceForm>);
static_assert(HasEightNormals<IsosurfaceForm>);

}  // namespace tia
