#include "core/scene/displays/quilt.h"

#include <memory>

#include "core/input/json.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

// "qs8x6a0.75", as viewers of quilts know it: columns, rows and a view's width over its height.
std::string quilt_suffix(const Quilt& quilt, const View& view) {
  const double aspect = static_cast<double>(view.width) / view.height;
  const auto thousandths = static_cast<int>(std::floor(aspect * 1000 + 0.5));
  return "qs" + std::to_string(quilt.columns) + 'x' + std::to_string(quilt.rows) + 'a' +
         to_json(Value(thousandths / 1000.0));
}

}  // namespace

void Quilt::check(const Place& at, Faults& faults) const {
  if (count() < 2)
    faults.add({FaultKind::out_of_range, at.at("columns").pointer(), Value(columns),
                "at least 2 views, of columns times rows"});
}

std::vector<double> Quilt::eyes(double depth) const {
  std::vector<double> eyes;
  for (int i = 0; i < count(); ++i) {
    const double share = static_cast<double>(i) / (count() - 1) - 0.5;
    eyes.push_back(depth * tan_of(share * cone_degrees * (pi / 180)));
  }
  return eyes;
}

ViewGrid Quilt::grid(const DisplayFrame& frame) const {
  const double depth = frame.depth(focus_distance);
  ViewGrid grid{columns, rows, {}, quilt_suffix(*this, frame.view), depth};
  int i = 0;
  for (const double eye : eyes(depth)) {
    grid.views.push_back({moved_eye(frame.view, frame.right * eye, depth), i % columns,
                          rows - 1 - i / columns, numbered_view(i, count())});
    ++i;
  }
  return grid;
}

ViewGrid Quilt::interlaced(const DisplayFrame& frame, const Interlace& interlace) const {
  const double depth = frame.depth(focus_distance);
  const auto all_eyes = std::make_shared<const std::vector<double>>(eyes(depth));
  View view = frame.view;
  const double third = interlace.subpixel.value_or(1.0 / (3 * view.width));
  const auto of_color = [&](int color) {
    const double to_side = color - 1;
    LenticularView rays{{interlace.pitch, interlace.tilt,
                         interlace.center - to_side * interlace.fringe, interlace.invert, count()},
                        to_side * third,
                        view.width,
                        view.height,
                        length(frame.view.right),
                        length(frame.view.up),
                        depth,
                        all_eyes};
    View of = view;
    of.right = frame.right;
    of.up = frame.up;
    of.curved = std::move(rays);
    return of;
  };
  return {1,
          1,
          {{of_color(0), 0, 0, "red", only_red},
           {of_color(1), 0, 0, "green", only_green},
           {of_color(2), 0, 0, "blue", only_blue}}};
}

}  // namespace tia
