#include "core/film/lettering.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

/// Letter: its rows from the top, the leftmost dot first.
struct Letter {
  char is;
  std::array<std::string_view, letter_height> rows;
};

constexpr std::array letters = std::to_array<Letter>({
    {'0', {".###.", "#...#", "#..##", "#.#.#", "##..#", "#...#", ".###."}},
    {'1', {"..#..", ".##..", "..#..", "..#..", "..#..", "..#..", ".###."}},
    {'2', {".###.", "#...#", "....#", "...#.", "..#..", ".#...", "#####"}},
    {'3', {".###.", "#...#", "....#", "..##.", "....#", "#...#", ".###."}},
    {'4', {"...#.", "..##.", ".#.#.", "#..#.", "#####", "...#.", "...#."}},
    {'5', {"#####", "#....", "####.", "....#", "....#", "#...#", ".###."}},
    {'6', {".###.", "#....", "#....", "####.", "#...#", "#...#", ".###."}},
    {'7', {"#####", "....#", "...#.", "..#..", "..#..", "..#..", "..#.."}},
    {'8', {".###.", "#...#", "#...#", ".###.", "#...#", "#...#", ".###."}},
    {'9', {".###.", "#...#", "#...#", ".####", "....#", "....#", ".###."}},
    {'-', {".....", ".....", ".....", ".###.", ".....", ".....", "....."}},
    {'.', {".....", ".....", ".....", ".....", ".....", ".##..", ".##.."}},
    {'B', {"####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."}},
    {'d', {"....#", "....#", ".####", "#...#", "#...#", "#...#", ".####"}},
    {'m', {".....", ".....", "##.#.", "#.#.#", "#.#.#", "#.#.#", "#.#.#"}},
    {'n', {".....", ".....", "#.##.", "##..#", "#...#", "#...#", "#...#"}},
    {'s', {".....", ".....", ".####", "#....", ".###.", "....#", "####."}},
    {'t', {".#...", ".#...", "###..", ".#...", ".#...", ".#..#", "..##."}},
    {'x', {".....", ".....", "#...#", ".#.#.", "..#..", ".#.#.", "#...#"}},
});

}  // namespace

void set_pixel(Image8& image, int x, int y, const Code3& code) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
  std::copy(
      code.begin(), code.end(),
      image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (row + static_cast<std::size_t>(x))));
}

void fill(Image8& image, int x0, int y0, int x1, int y1, const Code3& code) {
  for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x) set_pixel(image, x, y, code);
}

void draw_line(Image8& image, double x0, double y0, double x1, double y1, const Code3& code) {
  // Only the part inside the picture: Liang, Barsky, "A new concept and method for line clipping"
  // (1984).
  double from = 0, to = 1;
  const auto clip = [&](double slope, double room) {  // slope t <= room
    if (slope == 0) return room >= 0;
    (slope > 0 ? to : from) = slope > 0 ? std::min(to, room / slope) : std::max(from, room / slope);
    return from <= to;
  };
  if (!clip(x0 - x1, x0) || !clip(x1 - x0, image.width - x0) || !clip(y0 - y1, y0) ||
      !clip(y1 - y0, image.height - y0))
    return;
  const double longer = std::max(std::fabs(x1 - x0), std::fabs(y1 - y0)) * (to - from);
  const int steps = std::max(1, static_cast<int>(std::ceil(longer)));
  for (int i = 0; i <= steps; ++i) {
    const double t = from + (to - from) * i / steps;
    set_pixel(image, static_cast<int>(std::floor(x0 + (x1 - x0) * t)),
              static_cast<int>(std::floor(y0 + (y1 - y0) * t)), code);
  }
}

void write_text(Image8& image, int x, int y, std::string_view text, const Code3& code) {
  for (const char c : text) {
    for (const Letter& each : letters)
      for (std::size_t row = 0; each.is == c && row < each.rows.size(); ++row)
        for (std::size_t dot = 0; dot < each.rows[row].size(); ++dot)
          if (each.rows[row][dot] == '#')
            set_pixel(image, x + static_cast<int>(dot), y + static_cast<int>(row), code);
    x += letter_width;
  }
}

}  // namespace tia
