#include "core/input/edit_distance.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace tia {

// Three rows of the table at a time. Only what lies within `most` of the diagonal can be that near,
// and a row that is nowhere so near leads to nothing nearer.
// Source: Ukkonen, "Algorithms for approximate string matching" (1985).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > most) return most + 1;
  using Row = std::array<std::uint8_t, longest_compared + 1>;
  const auto too_many = static_cast<std::uint8_t>(most + 1);
  Row rows[3];
  for (Row& each : rows) each.fill(too_many);
  Row *before = &rows[0], *last = &rows[1], *row = &rows[2];
  for (std::size_t j = 0; j <= std::min(b.size(), most); ++j)
    (*row)[j] = static_cast<std::uint8_t>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row->fill(too_many);
    if (i <= most) (*row)[0] = static_cast<std::uint8_t>(i);
    std::size_t fewest = (*row)[0];
    for (std::size_t j = i > most ? i - most : 1; j <= std::min(b.size(), i + most); ++j) {
      const std::size_t substituted = (*last)[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      std::size_t edits = std::min<std::size_t>({(*last)[j] + 1U, (*row)[j - 1] + 1U, substituted});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        edits = std::min<std::size_t>(edits, (*before)[j - 2] + 1U);
      (*row)[j] = static_cast<std::uint8_t>(std::min(edits, most + 1));
      fewest = std::min(fewest, edits);
    }
    if (fewest > most) return most + 1;
  }
  return (*row)[b.size()];
}

std::size_t edits_to(std::string_view known, std::string_view written, std::size_t most) {
  const bool begins = known.starts_with(written) && known.substr(written.size()).starts_with('_');
  return begins ? 1 : edit_distance(written, known.substr(0, longest_compared), most);
}

}  // namespace tia
