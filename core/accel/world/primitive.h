// Primitive: a surface with one material and a transform. All kinds of shapes are compiled to it.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <variant>

#include "core/math/tolerances.h"
#include "core/math/transform.h"
#include "core/shapes/shape.h"

namespace tia {

/// Primitive. Space/units: `to_object` maps from the space that contains the primitive to its
/// own.
struct Primitive {
  Form form;  ///< unused if it is a mesh
  Affine to_object{};
  Vec3d middle{};   ///< of its bounds in its own space; 0 if they are infinite
  int mesh = -1;    ///< the geometry's mesh that it is instead of a form; -1: none
  int ball = -1;    ///< the geometry's ball that it is as well; -1: none
  int flat = -1;    ///< the geometry's flat that it is as well; -1: none
  int shading = 0;  ///< the index of its shading in the geometry
  int object = 0;   ///< the object that it belongs to, counted from 0 in the scene's order
  int space = 0;    ///< the index of the space that contains it
  int numbers = 0;  ///< how many primitives after it are its own, one for each numbered material
                    ///< (material_number); -1: it is one of those
  bool inverted = false;  ///< whether it is subtracted from a solid, so that its inside is outside
  bool culls = true;      ///< whether back faces of what is one-sided are passed (Sight)
  bool placed = false;    ///< whether to_object is not the identity
  bool colored = false;   ///< whether it is a mesh with colours
  int work = 1;           ///< what trying a ray on it costs (WorkCounter)
};

namespace detail {

/// Calls f(form, line, shift, length) with the line in the primitive's own space, of unit direction
/// and with its origin next to the primitive, where double has the most digits. Its parameter s
/// belongs to the given line's t = (s + shift) / length. Returns: what f returns.
template <class F>
auto with_own_line(const Primitive& primitive, const Line& line, F f) {
  const Vec3d origin = primitive.to_object.point(line.origin);
  const Vec3d way = primitive.to_object.vector(line.direction);
  const double length = tia::length(way);
  const Vec3d unit = way * (1 / length);
  const double shift = dot(primitive.middle - origin, unit);
  const Line own{origin + unit * shift, unit};
  return std::visit([&](const auto& form) { return f(form, own, shift, length); }, primitive.form);
}

/// How far along its own line a primitive is searched: a little beyond t_max (tolerance::search_t),
/// and beyond what double rounds the shift by, four times 2^-52.
template <class Real>
Real search_limit(const Real& t_max, const Real& shift, const Real& length) {
  constexpr double rounding = 0x1p-50;
  return t_max * Real(1 + tolerance::search_t) * length - shift + Real(rounding) * abs_of(shift);
}

/// The work that a call returns; 0 if it returns nothing.
template <class F>
std::int64_t work_of_call(F call) {
  if constexpr (std::same_as<decltype(call()), void>) return call(), 0;
  else return call();
}

// Passes a form's crossings on to emit, with s converted to the given line's t, and with their
// brackets if emit takes them.
template <class Emit>
struct OnGivenLine {
  Emit& emit;
  double shift, length;

  double of(double s) const { return (s + shift) / length; }
  void operator()(double s, int element) const { emit(of(s), element); }
  void operator()(double s, int element, const Bracket& b) const requires TakesBracket<Emit> {
    emit(of(s), element, Bracket{of(b.from), of(b.to), b.how, b.degree});
  }
};

}  // namespace detail

/// Calls emit(t, element) for each crossing of the line with the primitive's surface, or with its
/// bracket (emit_root).
/// Domain: a primitive that is no mesh; a line of any direction but 0.
/// Returns: the work that was done beyond primitive.work, as the two functions below do.
template <class Emit>
std::int64_t crossings(const Primitive& primitive, const Line& line, Emit emit) {
  return detail::with_own_line(
      primitive, line, [&](const auto& form, const Line& own, double shift, double n) {
        const detail::OnGivenLine<Emit> out{emit, shift, n};
        return detail::work_of_call([&] { return crossings(form, own, out); });
      });
}

/// Calls emit(t, element) where the line enters and leaves the primitive as a solid, in pairs.
/// Domain: a primitive whose form is solid.
template <class Emit>
std::int64_t spans(const Primitive& primitive, const Line& line, Emit emit) {
  return detail::with_own_line(
      primitive, line, [&]<class F>(const F& form, const Line& own, double shift, double n) {
        const detail::OnGivenLine<Emit> out{emit, shift, n};
        if constexpr (HasSpans<F>)
          return detail::work_of_call([&] { return spans(form, own, out); });
        else return detail::work_of_call([&] { return crossings(form, own, out); });
      });
}

/// The number of the primitive that has an element's material: itself, or one of those that follow
/// it, one for each numbered material.
inline int primitive_of(const Primitive& primitive, int number, int element) {
  if (primitive.numbers == 0) return number;
  return number + std::visit(
                      [&]<class F>(const F& form) {
                        if constexpr (NumbersMaterials<F>) return material_number(form, element);
                        else return 0;
                      },
                      primitive.form);
}

/// The primitive's first crossing with t > 0; none, or any, if that is beyond t_max.
inline FirstCrossing nearest_crossing(const Primitive& primitive, const Line& line, double t_max) {
  FirstCrossing nearest;
  detail::with_own_line(
      primitive, line, [&]<class F>(const F& form, const Line& own, double shift, double n) {
        if constexpr (FindsFirstCrossing<F>) {
          nearest = first_crossing(form, own, -shift, detail::search_limit(t_max, shift, n));
          nearest.at.t = (nearest.at.t + shift) / n;
        } else {
          nearest.work = detail::work_of_call([&] {
            return crossings(form, own, [&](double s, int element) {
              const double t = (s + shift) / n;
              if (t > 0 && t < nearest.at.t) nearest.at = {t, element};
            });
          });
        }
      });
  return nearest;
}

/// Whether a primitive's normals at its element 0 are found for eight points at once.
inline bool normals_go_in_eights(const Primitive& primitive) {
  const auto go = []<class F>(const F&) { return HasEightNormals<F>; };
  return primitive.mesh < 0 && std::visit(go, primitive.form);
}
/// In the primitive's own space. Domain: a primitive whose normals go in eights.
inline Vec3<Octet> normals_of_eight(const Primitive& primitive, const Vec3<Octet>& p) {
  return std::visit(
      [&]<class F>(const F& form) {
        if constexpr (HasEightNormals<F>) return normals(form, p);
        else return p;
      },
      primitive.form);
}

/// Whether a primitive's first crossings are found for eight lines at once.
inline bool goes_in_eights(const Primitive& primitive) {
  return std::visit([]<class F>(const F&) { return FindsEightFirstCrossings<F>; }, primitive.form);
}
/// nearest_crossing of eight lines, the same to the bit. Domain: a primitive that goes in eights.
inline EightCrossings nearest_crossings(const Primitive& primitive, const EightLines& given) {
  const Ray<Octet>& line = given.line;
  const Vec3<Octet> origin = primitive.to_object.point(line.origin);
  const Vec3<Octet> way = primitive.to_object.vector(line.direction);
  const Octet length = tia::length(way);
  const Vec3<Octet> unit = way * (Octet(1.0) / length);
  const Octet shift = dot(static_cast<Vec3<Octet>>(primitive.middle) - origin, unit);
  const EightLines own{{origin + unit * shift, unit},
                       -shift,
                       detail::search_limit(given.before, shift, length),
                       given.wanted};
  return std::visit(
      [&]<class F>(const F& form) {
        EightCrossings found;
        if constexpr (FindsEightFirstCrossings<F>) {
          found = first_crossings(form, own);
          const Octet t = (Octet::load_unaligned(found.t.data()) + shift) / length;
          t.store_unaligned(found.t.data());
        }
        return found;
      },
      primitive.form);
}

}  // namespace tia
