// Interlace: which of a quilt's views the subpixels of a lenticular panel show.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"

namespace tia {

/// Interlace: the numbers of a panel's calibration, or of a printed sheet of lenses: the view of a
/// subpixel is that in whose share of 0 to 1 the fraction of (x + y tilt) pitch - center falls;
/// x and y are shares of the picture's width and height from its bottom left corner.
struct Interlace {
  static constexpr std::string_view schema_name = "interlace";
  double pitch = 1, tilt = 0, center = 0, fringe = 0;
  std::optional<double> subpixel;
  bool invert = false;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("pitch", &Interlace::pitch,
          Spec{.about = "lenses across the picture's width",
               .min = 0,
               .max = 1e6,
               .open_min = true,
               .required = true});
    visit("tilt", &Interlace::tilt,
          Spec{.about = "how far a lens goes to the left on its way up, in widths a height",
               .min = -1e3,
               .max = 1e3});
    visit("center", &Interlace::center,
          Spec{.about = "by how much of a lens they stand to the right", .min = -1e6, .max = 1e6});
    visit("fringe", &Interlace::fringe,
          Spec{.about = "by how much of a lens red is shown to the left of green, and blue to its "
                        "right, which lenses bend otherwise",
               .min = -1,
               .max = 1});
    visit("subpixel", &Interlace::subpixel,
          Spec{.about = "from a pixel's red to its green, and from there to its blue, as a share "
                        "of the width; else a third of a pixel",
               .min = -1,
               .max = 1});
    visit("invert", &Interlace::invert,
          Spec{.about = "whether views go from the right to the left"});
  }
  bool operator==(const Interlace&) const = default;
};

}  // namespace tia
