#include "core/scene/displays/stereo.h"

#include "core/input/errors.h"

namespace tia {
namespace {

// Of linear light. Source: Dubois, "Conversion of a stereo pair to anaglyph with the least-squares
// projection method", 2009; the method of Dubois, "A projection method to generate anaglyph stereo
// images", ICASSP 2001.
constexpr Mix dubois_left{
    {{0.437F, 0.449F, 0.164F}, {-0.062F, -0.062F, -0.024F}, {-0.048F, -0.050F, -0.017F}}};
constexpr Mix dubois_right{
    {{-0.011F, -0.032F, -0.007F}, {0.377F, 0.761F, 0.009F}, {-0.026F, -0.093F, 1.234F}}};

}  // namespace

void Stereo::check(const Place& at, Faults& faults) const {
  if (matrix && layout != StereoLayout::anaglyph)
    faults.add({FaultKind::conflict, at.at("matrix").pointer(), write_value(*matrix),
                "matrix goes with layout anaglyph"});
}

ViewGrid Stereo::grid(const DisplayFrame& frame) const {
  const double depth = frame.depth(convergence);
  const auto eye = [&](double side) {
    return moved_eye(frame.view, frame.right * (side * separation / 2), depth);
  };
  GridView left{eye(-1), 0, 0, "left"}, right{eye(1), 0, 0, "right"};
  ViewGrid grid;
  grid.window_depth = depth;
  switch (layout) {
    case StereoLayout::side_by_side: grid.columns = 2, right.column = 1; break;
    case StereoLayout::cross_eyed: grid.columns = 2, left.column = 1; break;
    case StereoLayout::top_bottom: grid.rows = 2, right.row = 1; break;
    case StereoLayout::anaglyph:
      const bool by_least_squares = matrix == AnaglyphMatrix::dubois;
      left.mix = by_least_squares ? dubois_left : only_red;
      right.mix = by_least_squares ? dubois_right : green_and_blue;
  }
  grid.views = {left, right};
  return grid;
}

}  // namespace tia
