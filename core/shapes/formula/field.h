// The form of surfaces that a formula f(x, y, z) = 0 gives: implicit, explicit, blended. Its roots
// along a line are found without guesses: boxes that provably hold none are left out, and where a
// slope's interval does not prove a root the only one, the stretch is parted until it does.
#pragma once

#include "core/shapes/eight_lines.h"
#include "core/shapes/formula/field_form.h"

namespace tia {

FieldForm field_form(Program field, const Region& region);

inline int elements(const FieldForm& f) { return 1 + elements(f.region); }
inline Aabb bounds(const FieldForm& f) { return bounds(f.region); }
inline int work_of(const FieldForm&) { return 8; }

namespace detail {

/// Returns: the work.
std::int64_t follow(const FieldForm& form, const Line& line, const FieldStretch& stretch,
                    FieldListener& listener);
bool is_inside(const FieldForm& form, const Vec3d& p);

template <class F>
class Hearing final : public FieldListener {
 public:
  explicit Hearing(F f) : f_(f) {}
  bool hear(const FieldEvent& event) override { return f_(event); }

 private:
  F f_;
};

}  // namespace detail

/// The surface's crossings within the region. They make no pairs: CSG wants spans.
/// A root where f touches 0 and turns back stands twice; such ones are told apart that are at least
/// 2^-40 of the region's size apart, as far as f's rounding lets them.
/// Cost: bounded by what a line may take, beyond which pieces of it are known by their ends alone.
template <class Emit>
std::int64_t crossings(const FieldForm& form, const Line& line, Emit&& emit) {
  const Chord within = chord(form.region, line);
  if (within.empty()) return 0;
  detail::Hearing listener([&](const FieldEvent& event) {
    if (event.is_root) emit_root(emit, event.t, 0, event.bracket);
    return true;
  });
  return detail::follow(form, line, {within.in.t, within.out.t}, listener);
}
/// The first of eight lines each: bracketed line by line, found in their brackets together.
EightCrossings first_crossings(const FieldForm& form, const EightLines& eight);
inline FirstCrossing first_crossing(const FieldForm& form, const Line& line, double after,
                                    double before) {
  return first_crossings(form, EightLines::one(line, after, before)).one();
}

/// The crossings of the solid: what is inside the surface and the region, closed by this.
template <class Emit>
std::int64_t spans(const FieldForm& form, const Line& line, Emit&& emit) {
  const Chord within = chord(form.region, line);
  if (within.empty()) return 0;
  bool inside = detail::is_inside(form, line.at(within.in.t));
  if (inside) emit(within.in.t, within.in.element);
  detail::Hearing listener([&](const FieldEvent& event) {
    if (event.inside != inside) emit_root(emit, event.t, 0, event.bracket);
    inside = event.inside;
    return true;
  });
  const std::int64_t work = detail::follow(form, line, {within.in.t, within.out.t}, listener);
  if (inside) emit(within.out.t, within.out.element);
  return work;
}

/// The gradient's direction; where it is 0, at a singular point, or undefined: +y.
Vec3d normal(const FieldForm& form, const Vec3d& p, int element);
Vec3<Octet> normals(const FieldForm& form, const Vec3<Octet>& p);
/// Returns: longitude and latitude, as a sphere has them, around the middle of the region; on the
/// region's faces theirs.
Vec2d uv(const FieldForm& form, const Vec3d& p, int element);

static_assert(IsForm<FieldForm>);
static_assert(TellsWork<FieldForm>);
static_assert(HasSpans<FieldForm>);
static_assert(FindsFirstCrossing<FieldForm>);
static_assert(FindsEightFirstCrossings<FieldForm>);
static_assert(HasEightNormals<FieldForm>);

}  // namespace tia
