// Sheet: several views of one scene in one picture.
#pragma once

#include <algorithm>
#include <vector>

#include "core/lights/light.h"
#include "core/scene/camera.h"

namespace tia {

/// SheetView: what a view has in place of the scene's own.
struct SheetView {
  static constexpr std::string_view schema_name = "sheet_view";
  Camera camera;
  std::vector<Light> lights;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("camera", &SheetView::camera, Spec{.about = "in place of the scene's"});
    visit("lights", &SheetView::lights, Spec{.about = "in place of the scene's"});
  }
  bool operator==(const SheetView&) const = default;
};

/// Sheet: views side by side, row by row from the top, each of the picture's size; the last row is
/// filled up with what is shown where nothing is.
struct Sheet {
  static constexpr std::string_view schema_name = "sheet";
  static constexpr int most_views = 64;
  int columns = 1;
  std::vector<SheetView> views;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("columns", &Sheet::columns,
          Spec{.about = "how many views are side by side", .min = 1, .max = most_views});
    visit("views", &Sheet::views,
          Spec{.about = "1 to 64, row by row, each of the width and height that are asked for; "
                        "what the camera sees is theirs",
               .required = true,
               .min_items = 1});
  }
  int rows() const { return (static_cast<int>(views.size()) + columns - 1) / columns; }
  /// Too many views; more columns than views; lights without a place.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Sheet&) const = default;
};

}  // namespace tia
