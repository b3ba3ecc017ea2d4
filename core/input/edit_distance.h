// How many edits lie between two words: what was written, and what was meant.
#pragma once

#include <cstddef>
#include <string_view>

namespace tia {

/// The longest names that are compared, in bytes.
inline constexpr std::size_t longest_compared = 64;

/// Fewest insertions, deletions, substitutions and swaps of neighbours that lead from one to the
/// other ("optimal string alignment"); more than `most` where there are more.
/// Domain: texts of at most longest_compared bytes. Cost: O(length * most).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most);

/// The same from what was written to a known name, of which the start counts. Who writes a name's
/// first word means it: fov is one edit from fov_degrees.
std::size_t edits_to(std::string_view known, std::string_view written, std::size_t most);

}  // namespace tia
