// multipart/x-mixed-replace: pictures one after the other, each in the place of the one before, as
// browsers show them in an <img>. Source: RFC 2046, 5.1.1.
#pragma once

#include <string>
#include <string_view>

#include "server/http/message.h"

namespace tia::server::mixed_parts {

// The boundary is in no picture: that compressed bytes have it is less likely than that two tags
// are the same.
inline constexpr std::string_view media_type =
    "multipart/x-mixed-replace; boundary=tia-b3c1e9f0a7d25846";
inline constexpr std::string_view boundary = "--tia-b3c1e9f0a7d25846";

/// What stands before the first part.
inline std::string begin() { return std::string(boundary) + "\r\n"; }

/// A part with the boundary after it: a browser shows it once it has that.
std::string part(std::string_view type, const Headers& fields, std::string_view body,
                 bool is_last = false);

/// The last part, which tells a problem by its document.
std::string problem(const std::string& document);

}  // namespace tia::server::mixed_parts
