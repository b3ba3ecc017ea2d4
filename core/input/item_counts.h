// How many elements or members each array and object of a JSON text has, known before it is parsed,
// so that none takes memory to grow.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace tia {

/// In the order in which they begin, up to where there are more than `most` of them; of a text that
/// is no JSON what commas and brackets make of it, never more than half its bytes together.
/// Cost: one pass over the text.
std::vector<std::uint32_t> item_counts(std::string_view text, std::size_t most);

}  // namespace tia
