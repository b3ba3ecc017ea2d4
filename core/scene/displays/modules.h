// Modules: projectors in a row behind a screen, as walls of light fields have them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/fields.h"
#include "core/input/value_codecs.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// ModuleRow: how many modules there are, or where each is; in JSON a number or a list.
struct ModuleRow {
  static constexpr int most = 1024;
  int count = 0;  ///< where `at` is empty
  std::vector<double> at{};
  bool operator==(const ModuleRow&) const = default;
};
template <>
struct Codec<ModuleRow> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   ModuleRow& out);
  static Value write(const ModuleRow& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

/// Observers: the line that the viewers' eyes are on, parallel to the screen's rows.
struct Observers {
  static constexpr std::string_view schema_name = "observers";
  double distance = 1, height = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("distance", &Observers::distance,
          Spec{.about = "from the screen to the line of the viewers' eyes",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("height", &Observers::height,
          Spec{.about = "of that line over the screen's middle", .min = -1e9, .max = 1e9});
  }
  bool operator==(const Observers&) const = default;
};

/// Warp: where on the screen the points of a module's image come to lie.
struct Warp {
  static constexpr std::string_view schema_name = "screen_warp";
  static constexpr int most = 64;
  int columns = 2, rows = 2;
  std::vector<std::array<double, 2>> points;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("columns", &Warp::columns,
          Spec{.about = "points across the image", .min = 2, .max = most, .required = true});
    visit("rows", &Warp::rows,
          Spec{.about = "points down the image", .min = 2, .max = most, .required = true});
    visit("points", &Warp::points,
          Spec{.about = "x, y on the screen from its middle, row by row from the image's top left "
                        "corner to its bottom right one; between them it is bilinear",
               .min = -1e9,
               .max = 1e9,
               .required = true});
  }
  /// Another number of points.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Warp&) const = default;
};

/// Modules: the display's frame has the screen in z = 0 around look_at, x right, y up, z towards
/// the viewers; the modules stand on the line y = 0, z = -behind (ModuleImage). One view a module,
/// or that of one viewer (ModuleSlice).
struct Modules {
  static constexpr std::string_view type = "modules";
  static constexpr DisplayNeeds needs{.own_extent = true, .look_at = true};
  std::array<double, 2> screen{1, 1};
  ModuleRow modules;
  std::optional<double> pitch;
  double behind = 1;
  Observers observer;
  std::optional<int> columns;
  std::vector<Warp> warp;
  std::optional<double> slice;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("screen", &Modules::screen,
          Spec{.about = "its width and height",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("modules", &Modules::modules,
          Spec{.about = "how many, or the x of each from the left to the right",
               .min = -1e9,
               .max = 1e9,
               .required = true});
    visit("pitch", &Modules::pitch,
          Spec{.about = "of a number of modules: between neighbours",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("behind", &Modules::behind,
          Spec{.about = "from the modules to the screen",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("observer", &Modules::observer, Spec{.about = "the viewers", .required = true});
    visit("columns", &Modules::columns,
          Spec{.about = "how many modules' images are side by side; else all",
               .min = 1,
               .max = ModuleRow::most});
    visit("warp", &Modules::warp,
          Spec{.about = "what calibration has found of the modules: one for all, or one for each"});
    visit("slice", &Modules::slice,
          Spec{.about = "where on their line a viewer is, to the right of the middle: one view, of "
                        "what is seen from there, each column of the nearest module's; else all "
                        "modules' images",
               .min = -1e9,
               .max = 1e9});
  }
  int count() const {
    return modules.at.empty() ? modules.count : static_cast<int>(modules.at.size());
  }
  /// A single module; an order; a pitch without need; more columns than modules; warps.
  void check(const Place& at, Faults& faults) const;
  ViewGrid grid(const DisplayFrame& frame) const;
  bool operator==(const Modules&) const = default;

 private:
  std::vector<double> places() const;
};

}  // namespace tia
