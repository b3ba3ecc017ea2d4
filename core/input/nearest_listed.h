// Names in words where there may be any number of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tia {

/// Of a list that grows and is told in full elsewhere the eight names nearest to the one given,
/// nearest first (fewest edits; of equally many the earlier one), and how many more there are:
/// "thesis, heart, textures and 49 more". Of many names the first 2000 are tried; of long ones the
/// start is told.
std::string nearest_listed(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace tia
