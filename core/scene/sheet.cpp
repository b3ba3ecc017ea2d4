#include "core/scene/sheet.h"

namespace tia {

void Sheet::check(const Place& at, Faults& faults) const {
  const auto count = static_cast<int>(views.size());
  const Place all = at.at("views");
  if (faults.within(all.pointer())) return;
  if (count > most_views)
    faults.add({FaultKind::limit, all.pointer(), Value(count), "at most 64 views"});
  if (columns > count)
    faults.add({FaultKind::out_of_range, at.at("columns").pointer(), Value(columns),
                "at most as many columns as there are views, " + std::to_string(count)});
  for (std::size_t i = 0; i < views.size() && !faults.full(); ++i)
    if (views[i].camera.display)
      faults.add({FaultKind::conflict, all.at(i).at("camera").at("display").pointer(),
                  Value(views[i].camera.display->type()), "one view, of a sheet's"});
  for (std::size_t i = 0; i < views.size(); ++i)
    for (std::size_t k = 0; k < views[i].lights.size() && !faults.full(); ++k)
      if (const auto* awaited = views[i].lights[k].awaited())
        faults.add({FaultKind::missing, all.at(i).at("lights").at(k).at(awaited).pointer(),
                    std::nullopt, "where the light is, or which way it travels"});
}

}  // namespace tia
