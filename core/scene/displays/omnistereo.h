// Two panoramas, of the eyes of a head that turns.
#pragma once

#include <string_view>

#include "core/input/fields.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// Omnistereo: equirectangular, left above right; each column's rays start on the circle of the
/// eyes, tangentially (EquirectangularView).
struct Omnistereo {
  static constexpr std::string_view type = "omnistereo";
  static constexpr DisplayNeeds needs{.own_extent = true, .panorama = true};
  double separation = 0.065;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("separation", &Omnistereo::separation,
          Spec{.about = "between the eyes", .min = 0, .max = 1e9});
  }
  ViewGrid grid(const DisplayFrame& frame) const {
    const auto eye = [&](double side) {
      View view = frame.view;
      view.right = frame.right;
      view.up = frame.up;
      view.curved = EquirectangularView{side * separation / 2};
      return view;
    };
    return {1, 2, {{eye(-1), 0, 0, "left"}, {eye(1), 0, 1, "right"}}};
  }
  bool operator==(const Omnistereo&) const = default;
};

}  // namespace tia
