#include "core/input/nearest_listed.h"

#include <algorithm>
#include <utility>

#include "core/input/edit_distance.h"
#include "core/input/errors.h"

namespace tia {

std::string nearest_listed(std::string_view name, const std::vector<std::string_view>& known) {
  constexpr std::size_t most_told = 8, most_tried = 2000;
  name = name.substr(0, longest_compared);
  std::vector<std::pair<std::size_t, std::string_view>> near;
  for (std::size_t i = 0; i < std::min(most_tried, known.size()); ++i)
    near.emplace_back(edits_to(known[i], name, longest_compared), known[i]);
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min(most_told, near.size()); ++i)
    text.append(i > 0 ? ", " : "").append(excerpt_of(near[i].second, longest_compared));
  if (known.size() > most_told)
    text += " and " + std::to_string(known.size() - most_told) + " more";
  return text;
}

}  // namespace tia
