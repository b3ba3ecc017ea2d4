#include "core/video/apng.h"

#include "core/film/png_chunk.h"

namespace tia {
namespace {

std::string two_bytes(std::int64_t value) {
  return {static_cast<char>(value >> 8U & 0xFF), static_cast<char>(value & 0xFF)};
}

}  // namespace

// The whole picture, at its corner; it takes the place of what was there before.
std::string ApngWriter::control(std::string_view header, std::int64_t ms) {
  std::string data = big_endian(next_++);
  data.append(header.substr(0, 8)).append(8, '\0');  // width and height, as in IHDR; x and y
  data.append(two_bytes(ms)).append(two_bytes(1000)).append(2, '\0');
  return png_chunk("fcTL", data);
}

// Of the first frame they are pixels that any reader of PNG shows.
std::string ApngWriter::data(std::string_view pixels) {
  if (!has_begun_) return png_chunk("IDAT", pixels);
  return png_chunk("fdAT", big_endian(next_++).append(pixels));
}

std::string ApngWriter::frame(std::string_view png, std::int64_t ms) {
  if (!png.starts_with(png_signature)) throw_no_png("another file");
  std::string piece;
  piece.reserve(png.size() + 256);
  if (!has_begun_) piece = png_signature;
  png.remove_prefix(png_signature.size());
  for (Chunk chunk; chunk.type != "IEND";) {
    chunk = take_chunk(png);
    if (chunk.type == "IHDR") {
      if (!has_begun_)
        piece += png_chunk("IHDR", chunk.data) +
                 png_chunk("acTL", big_endian(static_cast<std::uint32_t>(frames_)) + big_endian(0));
      piece += control(chunk.data, ms);
    } else if (chunk.type == "IDAT") {
      piece += data(chunk.data);
    }
  }
  has_begun_ = true;
  return piece;
}

std::string ApngWriter::end() { return png_chunk("IEND", ""); }

}  // namespace tia
