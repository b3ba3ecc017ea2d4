#include "core/scene/displays/modules.h"

#include <memory>

#include "core/input/codec.h"

namespace tia {

void Codec<ModuleRow>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                            ModuleRow& out) {
  if (v.as<Value::Array>() != nullptr) {
    read_value(v, at, spec, faults, out.at);
    if (out.at.size() > ModuleRow::most || out.at.size() < 2)
      faults.add({FaultKind::out_of_range, at.pointer(),
                  Value(std::to_string(out.at.size()) + " modules"), "2 to 1024 modules"});
  } else if (v.as<double>() != nullptr) {
    read_value(v, at, Spec{.min = 2, .max = ModuleRow::most}, faults, out.count);
  } else {
    detail::wrong_type(v, at, allowed(spec), faults);
  }
}
Value Codec<ModuleRow>::write(const ModuleRow& v) {
  return v.at.empty() ? Value(v.count) : write_value(v.at);
}
Value Codec<ModuleRow>::schema(const Spec& spec, Definitions& named) {
  Spec places = spec;
  places.min_items = 2;
  return Value::Object{
      {"anyOf", Value::Array{schema_of<int>(Spec{.min = 2, .max = ModuleRow::most}, named),
                             schema_of<std::vector<double>>(places, named)}}};
}
std::string Codec<ModuleRow>::allowed(const Spec&) {
  return "a number of modules, or a list of their places";
}

void Warp::check(const Place& at, Faults& faults) const {
  const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  if (points.size() != count)
    faults.add({FaultKind::out_of_range, at.at("points").pointer(),
                Value(std::to_string(points.size()) + " points"),
                "as many points as columns times rows, " + std::to_string(count)});
}

void Modules::check(const Place& at, Faults& faults) const {
  const auto fault = [&](FaultKind kind, const char* field, std::optional<Value> got,
                         const std::string& allowed) {
    faults.add({kind, at.at(field).pointer(), std::move(got), allowed});
  };
  for (std::size_t i = 1; i < modules.at.size(); ++i)
    if (!(modules.at[i - 1] < modules.at[i]))
      return faults.add({FaultKind::out_of_range, at.at("modules").at(i).pointer(),
                         Value(modules.at[i]), "more than the one before: from left to right"});
  if (modules.at.empty() && !pitch)
    fault(FaultKind::missing, "pitch", std::nullopt, "between neighbours, for a number of modules");
  if (!modules.at.empty() && pitch)
    fault(FaultKind::conflict, "pitch", Value(*pitch), "pitch goes with a number of modules");
  if (columns && *columns > count())
    fault(FaultKind::out_of_range, "columns", Value(*columns),
          "at most as many columns as there are modules, " + std::to_string(count()));
  if (warp.size() > 1 && static_cast<int>(warp.size()) != count())
    fault(FaultKind::out_of_range, "warp", Value(std::to_string(warp.size()) + " warps"),
          "one for all, or one for each of " + std::to_string(count()) + " modules");
}

namespace {

std::shared_ptr<const ScreenWarp> kept(const Warp& warp, const std::array<double, 2>& screen) {
  auto kept = std::make_shared<ScreenWarp>();
  kept->columns = warp.columns;
  kept->rows = warp.rows;
  for (std::size_t i = 0; i < warp.points.size(); ++i) {
    const auto number = static_cast<int>(i);
    const double u = static_cast<double>(number % warp.columns) / (warp.columns - 1);
    const double v = static_cast<double>(number / warp.columns) / (warp.rows - 1);
    kept->off.push_back(
        {warp.points[i][0] - (u - 0.5) * screen[0], warp.points[i][1] - (0.5 - v) * screen[1]});
  }
  return kept;
}

}  // namespace

std::vector<double> Modules::places() const {
  if (!modules.at.empty()) return modules.at;
  std::vector<double> places;
  for (int m = 0; m < modules.count; ++m)
    places.push_back((m - (modules.count - 1) / 2.0) * *pitch);
  return places;
}

ViewGrid Modules::grid(const DisplayFrame& frame) const {
  View view = frame.view;
  view.origin = frame.look_at.value_or(view.origin);
  view.right = frame.right;
  view.up = frame.up;
  const std::vector<double> at = places();
  ModuleImage image{0, behind, observer.distance, observer.height, screen[0] / 2, screen[1] / 2};
  if (slice) {
    view.curved = ModuleSlice{image, *slice, std::make_shared<const std::vector<double>>(at)};
    return {1, 1, {{view, 0, 0, "slice"}}};
  }
  std::vector<std::shared_ptr<const ScreenWarp>> warps;
  for (const Warp& each : warp) warps.push_back(kept(each, screen));
  const int across = columns.value_or(count());
  ViewGrid grid{across, (count() + across - 1) / across, {}};
  for (int i = 0; i < count(); ++i) {
    const auto number = static_cast<std::size_t>(i);
    image.module = at[number];
    if (!warps.empty()) image.warp = warps[warps.size() == 1 ? 0 : number];
    view.curved = image;
    grid.views.push_back({view, i % across, i / across, numbered_view(i, count())});
  }
  return grid;
}

}  // namespace tia
