#include "core/video/webm.h"

#include <bit>
#include <string_view>

namespace tia {
namespace {

std::string high_first(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes; i-- > 0;) text += static_cast<char>(value >> 8 * i & 0xFFU);
  return text;
}

// An element's ID, of as many bytes as it has. Source: RFC 8794, 5.
std::string id_of(std::uint32_t id) {
  return high_first(id, id > 0xFFFFFF ? 4 : id > 0xFFFF ? 3 : id > 0xFF ? 2 : 1);
}

// The size of data, in eight bytes. Source: RFC 8794, 6.
constexpr std::uint64_t eight_bytes = std::uint64_t{1} << 56U;
const std::string unknown_size = high_first(2 * eight_bytes - 1, 8);

std::string element(std::uint32_t id, std::string_view data) {
  return id_of(id) + high_first(eight_bytes | data.size(), 8).append(data);
}
std::string element(std::uint32_t id, std::uint64_t value) {
  return element(id, high_first(value, 8));
}
std::string element(std::uint32_t id, double value) {
  return element(id, high_first(std::bit_cast<std::uint64_t>(value), 8));
}
std::string element(std::uint32_t id, int value) {
  return element(id, static_cast<std::uint64_t>(value));
}

// Numbers of ITU-T H.273: BT.709's primaries and matrix, sRGB's curve.
std::string colour() {
  return element(0x55B0, element(0x55B1, 1) +       // MatrixCoefficients
                             element(0x55B2, 8) +   // BitsPerChannel
                             element(0x55B3, 1) +   // ChromaSubsamplingHorz
                             element(0x55B4, 1) +   // ChromaSubsamplingVert
                             element(0x55B9, 1) +   // Range: narrow
                             element(0x55BA, 13) +  // TransferCharacteristics
                             element(0x55BB, 1));   // Primaries
}

std::string document_type() {
  return element(0x1A45DFA3, element(0x4286, 1) + element(0x42F7, 1) + element(0x42F2, 4) +
                                 element(0x42F3, 8) + element(0x4282, "webm") + element(0x4287, 4) +
                                 element(0x4285, 2));
}

}  // namespace

std::string WebmWriter::track() const {
  const std::string video = element(0xB0, width_) + element(0xBA, height_) + colour();
  return element(0xAE, element(0xD7, 1) + element(0x73C5, 1) + element(0x83, 1) + element(0x9C, 0) +
                           element(0x86, "V_VP9") + element(0xE0, video));
}

std::string WebmWriter::head() const {
  constexpr int ms = 1'000'000;  // of the unit of time, in ns
  const std::string info = element(0x2AD7B1, ms) +
                           element(0x4489, static_cast<double>(duration_ms_)) +
                           element(0x4D80, "Tia") + element(0x5741, "Tia");
  return document_type() + id_of(0x18538067) + unknown_size + element(0x1549A966, info) +
         element(0x1654AE6B, track());
}

// A cluster begins at each key, and where a block's time would no longer fit into its 16 bits.
std::string WebmWriter::frame(const Vp9Frame& frame, std::int64_t at_ms) {
  constexpr std::int64_t longest_ms = 32'767;
  std::string piece;
  if (cluster_ms_ < 0 || frame.is_key || at_ms - cluster_ms_ > longest_ms) {
    cluster_ms_ = at_ms;
    piece = id_of(0x1F43B675) + unknown_size + element(0xE7, static_cast<std::uint64_t>(at_ms));
  }
  std::string block = "\x81";  // of track 1
  block += high_first(static_cast<std::uint64_t>(at_ms - cluster_ms_), 2);
  block += static_cast<char>(frame.is_key ? 0x80 : 0);
  return piece += element(0xA3, block.append(frame.bytes));
}

}  // namespace tia
