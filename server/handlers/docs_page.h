// The page of documentation, made from the tables that serve requests.
#pragma once

#include <string>

namespace tia::server {

/// The page as HTML. Cost: milliseconds.
std::string docs_page();

/// Where on the page a problem of that type is told of.
std::string problem_anchor(std::string_view type);

}  // namespace tia::server
