// What a kind of light must bring, and what it may bring, a concept each; the list (light.h) checks
// every kind, so that one that brings half of something does not compile.
#pragma once

#include <concepts>
#include <optional>

#include "core/lights/incoming.h"
#include "core/shapes/shape.h"

namespace tia {

/// A kind that says whether it is endless: at no distance by which it could fade.
template <class Kind>
concept TellsDistance = requires {
  { Kind::endless } -> std::convertible_to<bool>;
};
/// A kind that takes the background's place: rays see it that leave the scene. It says so,
///   static constexpr bool background = true;
/// and has no form.
template <class Kind>
concept BackgroundLight = requires {
  requires Kind::background;
};
/// A kind that shines on points: prepare() makes a form of it that tells what comes in from it.
template <class Kind>
concept ShiningLight = requires(const Kind& kind) {
  { prepare(kind) } -> LitForm;
};

/// A kind that goes along with all that it lights where the world moves its origin: `move_by(way)`
/// moves every point that it is given by. Domain of that: one that does not wait.
template <class Kind>
concept MovesAlong = !ShiningLight<Kind> || requires(Kind & kind, const Vec3d& way) {
  { kind.move_by(way) } -> std::same_as<void>;
};

/// A kind that stands somewhere, and that a key can put elsewhere: `place_field` names the field
/// that says where, `waits()` tells whether that is not known yet, `place()` is its middle if it
/// has one, and `move_to(place, target)` puts it there; what has no middle shines from there
/// towards the target.
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

/// A kind that shines from an area: its form tells what comes in from each place of it, and
/// `samples` at how many a point looks.
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

/// What of a light can be seen: a shape that is a surface, or a mesh.
template <class S>
concept IsSeenSurface = IsSurface<S> || std::same_as<S, Mesh>;
/// A kind that is seen itself: surface() makes the shape that rays meet. It blocks other lights,
/// never its own. Space/units: world space.
template <class Kind>
concept SeenLight = ShiningLight<Kind> && requires(const Kind& kind) {
  { surface(kind) } -> IsSeenSurface;
};
/// An area that shines and is not seen would leave a mirror black.
template <class Kind>
concept AreaIsSeen = SeenLight<Kind> || !AreaLight<Kind>;

/// What the list asks of a kind.
template <class Kind>
concept IsLight = IsKind<Kind> && TellsDistance<Kind> &&
    (BackgroundLight<Kind> != ShiningLight<Kind>)&&MovesAlong<Kind>&& MovesWhollyOrNot<
        Kind>&& HasAreaWhollyOrNot<Kind>&& AreaIsSeen<Kind>;

}  // namespace tia
