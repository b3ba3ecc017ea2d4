// What a kind of light must have, and what it may have, a concept each. The list (light.h) checks
// every kind: one that has only part of what a concept asks for does not compile there.
#pragma once

#include <concepts>
#include <optional>

#include "core/lights/light_sample.h"
#include "core/lights/sky_map.h"
#include "core/shapes/shape.h"

namespace tia {

/// A kind that says by `endless` whether it is infinitely far. Such a one cannot fade.
template <class Kind>
concept TellsDistance = requires {
  { Kind::endless } -> std::convertible_to<bool>;
};
/// A kind that replaces the background: its colour is what rays get that hit nothing. It says
///   static constexpr bool background = true;
/// and has no form, for it lights no surface.
template <class Kind>
concept BackgroundLight = requires {
  requires Kind::background;
};
/// A kind that lights surfaces: prepare() makes a form of it, which is sampled (light_sample.h).
template <class Kind>
concept ShiningLight = requires(const Kind& kind) {
  { prepare(kind) } -> LitForm;
};

/// A kind that sends light from infinitely far by direction: what rays get that hit nothing, in the
/// background's place. What several kinds send adds up.
template <class Kind>
concept PaintsSky = requires(const Kind& kind) {
  { sky_of(kind) } -> std::same_as<SkyForm>;
};
/// A kind whose light has a colour by itself, a factor on the light's colour. What sky_of() makes
/// is not changed by it.
template <class Kind>
concept HasTint = ShiningLight<Kind> && requires(const Kind& kind) {
  { tint(kind) } -> std::same_as<Vec3d>;
};
/// A background has nothing else; any other kind lights surfaces, or paints the sky, or both.
template <class Kind>
concept SendsLight = BackgroundLight<Kind>
!= (ShiningLight<Kind> || PaintsSky<Kind>);

/// A kind that can be translated: `move_by(way)` adds `way` to every point that it is given by. The
/// world does so where it moves its own origin. Domain of move_by: a light that awaits nothing.
template <class Kind>
concept MovesAlong = !ShiningLight<Kind> || requires(Kind & kind, const Vec3d& way) {
  { kind.move_by(way) } -> std::same_as<void>;
};

/// A kind that a key can move: `place_field` is the name of the field that says where it is,
/// `waits()` tells whether that field is still missing, `place()` is its middle, none where it is
/// infinitely far, and `move_to(place, target)` moves its middle to the place; one without a middle
/// then shines from the place towards the target.
template <class Kind>
concept MovableLight = requires(Kind& kind, const Kind& still, const Vec3d& p) {
  { Kind::place_field } -> std::convertible_to<const char*>;
  { still.waits() } -> std::same_as<bool>;
  { still.place() } -> std::same_as<std::optional<Vec3d>>;
  { kind.move_to(p, p) } -> std::same_as<void>;
};
template <class Kind>
concept NamesPlace = requires {
  Kind::place_field;
}
|| requires { &Kind::waits; }
|| requires { &Kind::place; }
|| requires { &Kind::move_to; };
template <class Kind>
concept MovesWhollyOrNot = MovableLight<Kind> || !NamesPlace<Kind>;

/// A kind with an area: its form is sampled over the area, `samples` times for each point that it
/// lights.
template <class Kind>
concept AreaLight = ShiningLight<Kind> && AreaForm<FormOf<Kind>> && requires(const Kind& kind) {
  { kind.samples } -> std::same_as<const int&>;
};
template <class Kind>
concept NamesSamples = requires {
  &Kind::samples;
};
template <class Kind>
concept HasAreaForm = ShiningLight<Kind> && AreaForm<FormOf<Kind>>;
template <class Kind>
concept HasAreaWhollyOrNot = AreaLight<Kind> || !(NamesSamples<Kind> || HasAreaForm<Kind>);

/// The shapes that the surface of a light may have: a surface or a mesh.
template <class S>
concept IsSeenSurface = IsSurface<S> || std::same_as<S, Mesh>;
/// A kind that rays can hit: surface() makes its shape. The shape blocks the light of other lights
/// and not its own. Space/units: world space.
template <class Kind>
concept SeenLight = ShiningLight<Kind> && requires(const Kind& kind) {
  { surface(kind) } -> IsSeenSurface;
};
/// A light with an area must be one that rays can hit, or stand in the sky: a mirror that reflects
/// it would be black otherwise.
template <class Kind>
concept AreaIsSeen = SeenLight<Kind> || PaintsSky<Kind> || !AreaLight<Kind>;

/// What the list asks of a kind.
template <class Kind>
concept IsLight = IsKind<Kind> && TellsDistance<Kind> && SendsLight<Kind> && MovesAlong<Kind> &&
    MovesWhollyOrNot<Kind> && HasAreaWhollyOrNot<Kind> && AreaIsSeen<Kind>;

}  // namespace tia
