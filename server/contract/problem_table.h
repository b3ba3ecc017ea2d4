// One table of problems (RFC 9457): what each is called, means and comes with, and who meets it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/input/codec.h"

namespace tia::server {

/// Met: which requests may meet a problem.
enum class Met {
  by_any,     ///< before anybody looks at what it asks for, or when all goes wrong
  by_body,    ///< one with a body
  by_size,    ///< one with a body, or whose work takes its turn and may need much memory
  by_write,   ///< one that is no GET
  by_right,   ///< one that a key needs a right for
  by_input,   ///< one with parameters
  by_name,    ///< one whose path holds a name, or leads nowhere
  by_job,     ///< one for what a job has come to
  by_accept,  ///< one that is asked what media types it accepts
  by_method   ///< one whose path is for other methods
};

struct ProblemRow {
  std::string_view type;
  int status = 500;
  std::string_view title;
  Met met = Met::by_any;
  std::string_view about;
  std::string_view header = "";  ///< a name of header_rows(), or none
};

std::span<const ProblemRow> problem_rows();

/// The row of that type, "internal" where there is none.
const ProblemRow& problem_row(std::string_view type);

/// Where a problem is told of: "/problems/busy".
std::string problem_uri(const ProblemRow& row);

/// The schema of a problem document.
Value problem_schema(Definitions& named);

}  // namespace tia::server
