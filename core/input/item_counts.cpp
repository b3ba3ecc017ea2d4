#include "core/input/item_counts.h"

namespace tia {
namespace {

// The place behind the string that begins there, or the text's end.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

}  // namespace

std::vector<std::uint32_t> item_counts(std::string_view text, std::size_t most) {
  std::vector<std::uint32_t> counts;
  std::vector<std::size_t> open;
  bool filled = false;  // whether anything stands behind the last comma or bracket
  const auto end_item = [&] {
    if (filled && !open.empty()) ++counts[open.back()];
    filled = false;
  };
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"') {
      filled = true;
      at = end_of_string(text, at);
      continue;
    }
    if (c == '[' || c == '{') {
      if (counts.size() == most) break;
      open.push_back(counts.size());
      counts.push_back(0);
      filled = false;
    } else if (c == ']' || c == '}') {
      end_item();
      if (!open.empty()) open.pop_back();
      filled = true;  // the container is an item of the one around it
    } else if (c == ',') {
      end_item();
    } else if (c > ' ') {
      filled = true;
    }
    ++at;
  }
  return counts;
}

}  // namespace tia
