#include "core/radio/map_picture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/film/lettering.h"
#include "core/film/palette.h"

namespace tia {
namespace {

constexpr Code3 black{0, 0, 0}, white{255, 255, 255}, solid{72, 72, 72}, nothing{214, 214, 214};
constexpr double band = 3;  // decibels between contours
constexpr int legend_width = 72, legend_height = 160;

bool is_decibels(MapQuantity quantity) { return unit_of(quantity).starts_with("dB"); }

// 1, 2 or 5 times a power of ten, of which `span` has at most ten.
double round_step(double span) {
  double step = 1;
  while (span / step > 10) step *= 10;
  while (span / step <= 1) step /= 10;
  for (const double part : {0.2, 0.5})
    if (span / (step * part) <= 10) return step * part;
  return step;
}

class MapPainter {
 public:
  MapPainter(const RadioMap& map, MapQuantity quantity, const MapLook& look)
      : map_(map), quantity_(quantity), look_(look), scale_(scale_of(map, quantity, look)) {
    const MapSize size = picture_size(map.grid, look);
    image_ = Image8(size.width, size.height);
  }

  Image8 operator()() {
    fill(image_, 0, 0, image_.width, image_.height, white);
    for (int y = 0; y < map_.grid.height * look_.scale; ++y)
      for (int x = 0; x < map_.grid.width * look_.scale; ++x)
        set_pixel(image_, x, y, color_of_pixel(x, y));
    draw_walls();
    if (look_.legend) draw_legend();
    return std::move(image_);
  }

 private:
  std::size_t number(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.grid.width) +
           static_cast<std::size_t>(column);
  }
  double value(int column, int row) const { return map_.values[number(column, row)]; }
  double share(double x) const {
    return scale_.high > scale_.low ? (x / scale_.unit - scale_.low) / (scale_.high - scale_.low)
                                    : 0;
  }
  Code3 color(double x) const {
    return quantity_ == MapQuantity::best_server ? categorical(static_cast<std::size_t>(x))
                                                 : viridis(share(x));
  }

  Code3 color_of_pixel(int x, int y) const {
    const int column = x / look_.scale, row = y / look_.scale;
    const double is = value(column, row);
    if (std::isnan(is)) return map_.inside[number(column, row)] != 0 ? solid : nothing;
    Code3 code = color(is);
    if (is_decibels(quantity_) && look_.scale >= 3 && is_contour(x, y))
      for (std::uint8_t& each : code) each = static_cast<std::uint8_t>(each * 5 / 8);
    return code;
  }

  // Between the four cells around it, where there are as many; else its own.
  double smooth(int x, int y) const {
    const double u = (x + 0.5) / look_.scale - 0.5, v = (y + 0.5) / look_.scale - 0.5;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    if (i < 0 || j < 0 || i + 1 >= map_.grid.width || j + 1 >= map_.grid.height)
      return value(x / look_.scale, y / look_.scale);
    const double s = u - i, t = v - j;
    const double mixed = (1 - t) * ((1 - s) * value(i, j) + s * value(i + 1, j)) +
                         t * ((1 - s) * value(i, j + 1) + s * value(i + 1, j + 1));
    return std::isnan(mixed) ? value(x / look_.scale, y / look_.scale) : mixed;
  }
  bool is_contour(int x, int y) const {
    const auto band_of = [&](int at_x, int at_y) { return std::floor(smooth(at_x, at_y) / band); };
    const double own = band_of(x, y);
    const auto differs = [&](int at_x, int at_y) {
      if (at_x >= map_.grid.width * look_.scale || at_y >= map_.grid.height * look_.scale)
        return false;
      const double other = band_of(at_x, at_y);
      return !std::isnan(other) && other != own;
    };
    return differs(x + 1, y) || differs(x, y + 1);
  }

  void draw_walls() {
    const double s = look_.scale, right = map_.grid.width * s, below = map_.grid.height * s;
    Image8 map(static_cast<int>(right), static_cast<int>(below));
    for (const auto& [x0, y0, x1, y1] : map_.walls)
      draw_line(map, x0 * s, y0 * s, x1 * s, y1 * s, white);
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        if (map.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                         static_cast<std::size_t>(x))] != 0)
          set_pixel(image_, x, y, black);
  }

  // The unit above; colours from the highest down, numbers beside them.
  void draw_legend() {
    const int x = map_.grid.width * look_.scale + 8, top = 16, bottom = image_.height - 8;
    if (quantity_ == MapQuantity::best_server) return draw_servers(x);
    write_text(image_, x, 4, scale_.name, black);
    for (int y = top; y < bottom; ++y) {
      const double part = 1 - (y - top + 0.5) / (bottom - top);
      fill(image_, x, y, x + 14, y + 1, viridis(part));
    }
    const double first = std::ceil(scale_.low / scale_.step - 1e-9);
    for (int i = 0; (first + i) * scale_.step <= scale_.high + 1e-9 * scale_.step; ++i) {
      const double tick = (first + i) * scale_.step;
      const double part = (tick - scale_.low) / (scale_.high - scale_.low);
      const int y = static_cast<int>(std::floor(bottom - part * (bottom - top)));
      fill(image_, x + 14, y, x + 17, y + 1, black);
      write_text(image_, x + 20, y - letter_height / 2, text_of(tick), black);
    }
  }
  void draw_servers(int x) {
    write_text(image_, x, 4, "tx", black);
    const int most = (image_.height - 16) / 12;
    for (int i = 0; i < std::min(static_cast<int>(map_.transmitters), most); ++i) {
      fill(image_, x, 16 + 12 * i, x + 14, 26 + 12 * i, categorical(static_cast<std::size_t>(i)));
      write_text(image_, x + 20, 18 + 12 * i, std::to_string(i), black);
    }
  }
  std::string text_of(double tick) const {
    int digits = 0;
    for (double step = scale_.step; step < 0.999 && digits < 9; step *= 10) ++digits;
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), tick == 0 ? 0.0 : tick,
                                   std::chars_format::fixed, digits);
    return {text.data(), end.ptr};
  }

  const RadioMap& map_;
  const MapQuantity quantity_;
  const MapLook& look_;
  const MapScale scale_;
  Image8 image_;
};

}  // namespace

MapScale scale_of(const RadioMap& map, MapQuantity quantity, const MapLook& look) {
  MapScale scale{.name = unit_of(quantity)};
  if (quantity == MapQuantity::delay_spread) scale.unit = 1e-9, scale.name = "ns";
  double low = Aabb::far, high = -Aabb::far;
  for (const double each : map.values)
    if (!std::isnan(each)) low = std::min(low, each), high = std::max(high, each);
  if (low > high) low = high = 0;
  low /= scale.unit, high /= scale.unit;
  if (is_decibels(quantity)) {
    scale.high = std::ceil(high / band) * band;
    scale.low = std::max(std::floor(low / band) * band, scale.high - 90);
    if (!(scale.low < scale.high)) scale.low = scale.high - band;
  } else {
    scale.low = 0, scale.high = high > 0 ? high : 1;
  }
  if (look.range) {
    scale.low = (*look.range)[0] / scale.unit, scale.high = (*look.range)[1] / scale.unit;
  }
  const double span = scale.high - scale.low;
  scale.step = round_step(span);
  if (is_decibels(quantity))
    for (scale.step = band; span / scale.step > 10;) scale.step *= 2;
  return scale;
}

MapSize picture_size(const MapGrid& grid, const MapLook& look) {
  const int width = grid.width * look.scale, height = grid.height * look.scale;
  if (!look.legend) return {width, height};
  return {width + legend_width, std::max(height, legend_height)};
}

Image8 map_picture(const RadioMap& map, MapQuantity quantity, const MapLook& look) {
  return MapPainter(map, quantity, look)();
}

}  // namespace tia
