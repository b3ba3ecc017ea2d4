// The header fields of answers that mean something to clients, in one table.
#pragma once

#include <string_view>
#include <vector>

namespace tia::server {

struct HeaderRow {
  std::string_view name, about;
  std::string_view pattern;  ///< a regular expression that all its values match
  bool always = true;        ///< else an answer that may carry it need not
};

const std::vector<HeaderRow>& header_rows();

}  // namespace tia::server
