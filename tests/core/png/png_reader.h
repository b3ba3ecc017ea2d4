// PNG files read by libpng and zlib, as strictly as their standard allows: nothing here is shared
// with what encodes them, neither code nor a library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tia::test {

struct PngChunk {
  std::string type, data;
};

/// A text that a picture carries (iTXt or tEXt).
struct PngText {
  std::string keyword, text;
};

struct Png {
  int width = 0, height = 0;
  std::string rgb;   ///< 8 bits each, row 0 on top; none of a picture with alpha
  std::string rgba;  ///< of one with alpha
  std::vector<PngText> texts;
  std::vector<PngChunk> chunks;  ///< all, in order
};

/// Domain: 8 bits a channel, RGB or RGBA, not interlaced, as all pictures of ours.
/// Errors: std::runtime_error that says what is wrong.
/// Source: W3C PNG (third edition).
Png read_png(std::string_view file);

/// A test failure where the bytes are no such picture.
void check_png(std::string_view file);

}  // namespace tia::test
