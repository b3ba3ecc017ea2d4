// Pictures' files in JSON: base64, within limits, each fault at its place.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/film/decode.h"
#include "core/input/codec.h"

namespace tia {

using FileBytes = std::vector<std::uint8_t>;

/// The bytes of the file that a text in base64 holds; nothing, and a fault, if it is none, or has
/// more than `most_bytes`. `words` says what is allowed.
std::optional<FileBytes> read_file(const Value& v, std::string_view words, std::size_t most_bytes,
                                   const Place& at, Faults& faults);
/// {"type": "string"} and the pattern of base64.
Value file_schema(std::string_view example);

/// Adds what is wrong with a picture's file.
void add_fault(const PictureFault& fault, const Place& at, Faults& faults);
/// Whether the input may still have the pixels of such a picture (Bulk). If not, adds a fault.
bool take_pixels(const PictureSize& size, const Place& at, Faults& faults);

}  // namespace tia
