// HTML from text, enough for pages that are made once.
#pragma once

#include <string>
#include <string_view>

namespace tia::server {

/// Text as HTML: &, <, > and quotes are written as references.
std::string escaped(std::string_view text);

/// <tag attributes>html</tag>; attributes come as they are to stand, such as R"(id="x")".
std::string element(std::string_view tag, std::string_view html, std::string_view attributes = "");

/// Text as code, and a link to a place on the same page.
std::string code(std::string_view text);
std::string link_to(std::string_view id, std::string_view html);

}  // namespace tia::server
