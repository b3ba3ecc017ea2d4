// Compressed bytes read by the words of RFC 1950 and RFC 1951 alone, as strictly as they allow.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tia::test {

/// A whole zlib stream -> what it holds, at most so many bytes of it.
/// Errors: std::runtime_error that says what is wrong, bytes after its end included.
std::string inflated(std::string_view stream, std::size_t most);

}  // namespace tia::test
