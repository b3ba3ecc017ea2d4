// Letters in pictures: numbers and units, as dots.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/film/image.h"

namespace tia {

using Code3 = std::array<std::uint8_t, 3>;

/// A letter is 5 x 7 dots, and a dot further on the next one begins.
inline constexpr int letter_width = 6, letter_height = 7;

/// Sets a pixel; one outside the picture is left out.
void set_pixel(Image8& image, int x, int y, const Code3& code);
/// Fills the pixels x0 <= x < x1, y0 <= y < y1.
void fill(Image8& image, int x0, int y0, int x1, int y1, const Code3& code);
/// Sets the pixels that a line's points, less than one apart, are in. Space/units: pixels, whose
/// centres are at halves.
void draw_line(Image8& image, double x0, double y0, double x1, double y1, const Code3& code);
/// Writes a text whose upper left dot is at (x, y). Domain: the digits and the letters of units
/// (lettering.cpp); any other is left blank.
void write_text(Image8& image, int x, int y, std::string_view text, const Code3& code);

}  // namespace tia
