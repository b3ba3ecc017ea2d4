// Two eyes, in the layouts that glasses and screens take.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/input/value_codecs.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

enum class StereoLayout { side_by_side, top_bottom, anaglyph, cross_eyed };
template <>
struct Names<StereoLayout> {
  static constexpr std::array<std::string_view, 4> names{"side_by_side", "top_bottom", "anaglyph",
                                                         "cross_eyed"};
};
enum class AnaglyphMatrix { plain, dubois };
template <>
struct Names<AnaglyphMatrix> {
  static constexpr std::array<std::string_view, 2> names{"plain", "dubois"};
};

/// Stereo: two off-axis eyes on the camera's right axis, to both sides of it, whose frusta share
/// the window at the distance of convergence.
struct Stereo {
  static constexpr std::string_view type = "stereo";
  static constexpr DisplayNeeds needs{.orthographic = true, .lens = true};
  static constexpr const char* focus_field = "convergence";
  double separation = 0.065;
  std::optional<double> convergence;
  StereoLayout layout = StereoLayout::side_by_side;
  std::optional<AnaglyphMatrix> matrix;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("separation", &Stereo::separation,
          Spec{.about = "between the eyes", .min = 0, .max = 1e9});
    visit("convergence", &Stereo::convergence,
          Spec{.about = "along the view's axis, to the plane that both eyes see at the same place; "
                        "else to look_at",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("layout", &Stereo::layout,
          Spec{.about = "left beside right, left above right, right beside left, or one picture: "
                        "red of the left eye, green and blue of the right one"});
    visit("matrix", &Stereo::matrix,
          Spec{.about = "of an anaglyph: plain, or dubois: the least squares of what is seen "
                        "through red and cyan glasses"});
  }
  /// A matrix of what is no anaglyph.
  void check(const Place& at, Faults& faults) const;
  std::optional<double> focus() const { return convergence; }
  ViewGrid grid(const DisplayFrame& frame) const;
  bool operator==(const Stereo&) const = default;
};

}  // namespace tia
