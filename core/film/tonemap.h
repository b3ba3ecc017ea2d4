// From linear light to 8-bit codes: clamp to [0,1], transfer curve, round to nearest.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/film/image.h"
#include "core/input/fields.h"

namespace tia {

/// Encoding: how linear light in [0,1] is stored as codes, and read back from them.
enum class Encoding { srgb, linear };
template <>
struct Names<Encoding> {
  static constexpr std::array<std::string_view, 2> names{"srgb", "linear"};
};

/// Transfer: the curve from linear light to stored codes: an encoding, or one that first shows
/// light of any brightness as light in [0,1] (tone.h).
enum class Transfer { srgb, linear, aces, agx };
template <>
struct Names<Transfer> {
  static constexpr std::array<std::string_view, 4> names{"srgb", "linear", "aces", "agx"};
};

/// Returns: round(255 * curve(clamp(light, 0, 1))); NaN gives 0.
std::uint8_t encode_linear(float light);
/// Source: IEC 61966-2-1:1999. The light at which a code changes is formed in double with + - * /
/// only (the 2.4th power by Newton's fifth root), so that every processor agrees.
std::uint8_t encode_srgb(float light);

/// The linear light of an sRGB signal in [0,1]: the curve that encode_srgb inverts.
double srgb_to_linear(double signal);

/// One row of a tile as interleaved RGB codes. Shape: 3 * FilmTile::size codes and four bytes to
/// spare, for pixels are written four at a time in 16 bytes.
inline constexpr std::size_t row_codes = 3 * FilmTile::size + 4;
void develop_row(const FilmTile& tile, int y, Encoding encoding,
                 std::span<std::uint8_t, row_codes> codes);

}  // namespace tia
