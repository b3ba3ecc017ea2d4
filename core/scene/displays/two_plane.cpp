#include "core/scene/displays/two_plane.h"

#include "core/input/json.h"

namespace tia {
namespace {

std::string two_digits(int number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 2) digits.insert(digits.begin(), '0');
  return digits;
}

}  // namespace

ViewGrid TwoPlane::grid(const DisplayFrame& frame) const {
  const double depth = frame.depth({});
  View middle = frame.view;
  middle.right = frame.right * (st[0] / 2 / depth);
  middle.up = frame.up * (st[1] / 2 / depth);
  ViewGrid grid{uv.columns, uv.rows, {}, {}, depth};
  for (int row = 0; row < uv.rows; ++row)
    for (int column = 0; column < uv.columns; ++column) {
      const double x = (column - (uv.columns - 1) / 2.0) * uv.spacing;
      const double y = ((uv.rows - 1) / 2.0 - row) * uv.spacing;
      grid.views.push_back({moved_eye(middle, frame.right * x + frame.up * y, depth), column, row,
                            "out_" + two_digits(row) + '_' + two_digits(column) + '_' +
                                to_json(Value(y)) + '_' + to_json(Value(x))});
    }
  return grid;
}

}  // namespace tia
