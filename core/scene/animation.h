// Animation: what of a scene changes in time, as it is written. What it comes to at a time is
// at_time.h's.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formulas/names.h"
#include "core/input/codec.h"
#include "core/input/shared_value.h"

namespace tia {

/// KeyInterpolation: what is between two keys. smooth is the centripetal Catmull-Rom spline of
/// points and the monotone cubic of numbers; bezier is glTF's cubic spline, with tangents.
enum class KeyInterpolation { linear, step, smooth, bezier };
/// KeyRepeat: what is before the first key and after the last one.
enum class KeyRepeat { once, loop, pingpong };
/// Ease: how time passes from a key to the next one.
enum class Ease { none, in, out, in_out };

template <>
struct Names<KeyInterpolation> {
  static constexpr std::array<std::string_view, 4> names{"linear", "step", "smooth", "bezier"};
};
template <>
struct Names<KeyRepeat> {
  static constexpr std::array<std::string_view, 3> names{"once", "loop", "pingpong"};
};
template <>
struct Names<Ease> {
  static constexpr std::array<std::string_view, 4> names{"none", "in", "out", "in_out"};
};

/// AnimationKey: [t, value], or [t, value, ease], of a bezier [t, value, in, out] with tangents in
/// units a second.
struct AnimationKey {
  double time = 0;
  SharedValue value = Value(0);
  Ease ease = Ease::none;                    ///< on the way to the next key
  std::optional<SharedValue> before, after;  ///< tangents
  bool operator==(const AnimationKey&) const = default;
};
template <>
struct Codec<AnimationKey> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   AnimationKey& out);
  static Value write(const AnimationKey& key);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec&);
};

/// TimeFormula: of t in seconds: one for a number, several for a list of numbers.
struct TimeFormula {
  std::vector<std::string> parts;
  bool is_list = false;
  bool operator==(const TimeFormula&) const = default;
};
template <>
struct Codec<TimeFormula> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   TimeFormula& out);
  static Value write(const TimeFormula& formula);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec&);
};

/// Track: one place of the scene in time, by keys or by a formula; or when something is there.
struct Track {
  static constexpr std::string_view schema_name = "track";
  static constexpr double latest = 1e6;  // seconds, of keys
  std::string target;
  std::optional<std::vector<AnimationKey>> keys;
  KeyInterpolation interpolation = KeyInterpolation::linear;
  KeyRepeat repeat = KeyRepeat::once;
  std::optional<TimeFormula> formula;
  std::map<std::string, double> parameters;
  std::optional<std::vector<std::array<double, 2>>> visible;

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// None of keys, formula and visible, or two; keys that do not ascend or are not alike, what only
  /// keys or formulas have; a formula that is none.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Track&) const = default;
  /// The names that its formula may say.
  FormulaNames formula_names() const { return {{"t"}, parameters}; }
  /// Whether it is there at a time. Domain: a track with `visible`.
  bool is_visible(double seconds) const;
};

template <class Visitor>
void Track::fields(Visitor&& visit) {
  visit("target", &Track::target,
        Spec{.about = "a JSON Pointer into the scene, where a step into a list may be a name: to a "
                      "number, a list of numbers or, by step, anything; with visible to an object "
                      "or a light",
             .required = true,
             .max_bytes = 512});
  visit(
      "keys", &Track::keys,
      Spec{.about = "[t, value] at ascending times; [t, value, ease] for the way to the next key; "
                    "of bezier [t, value, in, out], tangents in units a second",
           .unit = "s",
           .min = -latest,
           .max = latest,
           .min_items = 1});
  visit("interpolation", &Track::interpolation,
        Spec{.about = "between keys: linear; step; smooth, through points by a centripetal "
                      "Catmull-Rom spline, of numbers a cubic that is monotone where they are; "
                      "bezier, by tangents. Quaternions turn at constant speed the short way, but "
                      "by bezier"});
  visit("repeat", &Track::repeat,
        Spec{.about = "before the first key and after the last: the value holds, or the keys' time "
                      "runs again, or back and forth"});
  visit("formula", &Track::formula,
        Spec{.about = "instead of keys: of t, in seconds; a list for a list of numbers"});
  visit("parameters", &Track::parameters,
        Spec{.about = "numbers that the formula calls by name", .min = -1e9, .max = 1e9});
  visit("visible", &Track::visible,
        Spec{.about = "[from, to]: from the first until just before the second it is there, "
                      "elsewhere it is not in the scene",
             .unit = "s",
             .min = -latest,
             .max = latest});
}

/// Animation: the tracks, and the frames that a film of them has.
struct Animation {
  static constexpr std::string_view schema_name = "animation";
  static constexpr double most_frames = 100'000;
  double duration = 1, fps = 24, shutter = 0;
  std::vector<Track> tracks;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("duration", &Animation::duration,
          Spec{.about = "how long it is",
               .unit = "s",
               .min = 0,
               .max = 86400,
               .open_min = true,
               .required = true});
    visit("fps", &Animation::fps,
          Spec{.about = "frames a second; frame k is at time k / fps",
               .min = 0,
               .max = 1000,
               .open_min = true});
    visit("shutter", &Animation::shutter,
          Spec{.about = "the share of a frame's time for which its shutter is open, half of it "
                        "before the frame's own time: what moves then is blurred",
               .min = 0,
               .max = 1});
    visit("tracks", &Animation::tracks, Spec{.about = "what changes"});
  }
  /// Too many frames.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Animation&) const = default;
  /// ceil(duration fps), one at least: frames 0 .. frames() - 1.
  int frames() const;
};

}  // namespace tia
