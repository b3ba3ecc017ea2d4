#include "core/models/ply_rows.h"

namespace tia {

void warn_of_skipped(const PlyElement& element, const PlyPlan& plan, Model& model) {
  if (element.count == 0) return;
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < plan.to.size(); ++i)
    if (plan.to[i] == PlyPlan::skipped) names.push_back(element.properties[i].name);
  if (names.empty()) return;
  const bool whole = names.size() == plan.to.size();
  model.warn({"", element.line,
              "not used of element " + excerpt_of(element.name, longest_name) + ": " +
                  (whole ? "all" : listed(names))});
}

std::optional<std::size_t> ply_number(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == name && !element.properties[i].count) return i;
  return std::nullopt;
}

}  // namespace tia
