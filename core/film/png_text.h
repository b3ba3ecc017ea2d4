// Text in PNG files: what a picture says of itself, in an iTXt chunk.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tia {

/// Returns: the file with the text in a compressed iTXt chunk behind its header.
/// Domain: a PNG file that begins with IHDR; a keyword of 1 to 79 Latin letters; UTF-8.
/// Errors: std::bad_alloc. Source: W3C PNG (third edition), 11.3.3.4.
std::string with_text(std::string png, std::string_view keyword, std::string_view text);

/// The same uncompressed, as some programs look for it. Domain: ASCII letters, also ':' and '.'.
std::string with_plain_text(std::string png, std::string_view keyword, std::string_view text);

/// Reads the text that a file has under a keyword, from a compressed or a plain iTXt chunk.
/// Returns: nothing where it has none. Cost: memory in proportion to the text, at most to `most`.
/// Errors: InputError: malformed for what is no PNG file from its first byte to its last, each
/// chunk with its checksum (pixels are not looked at), or has two such texts; limit for a text of
/// more than `most` bytes.
std::optional<std::string> text_in(std::string_view png, std::string_view keyword,
                                   std::size_t most);

}  // namespace tia
