#include "core/materials/image_texture.h"

#include <algorithm>
#include <cmath>

#include "core/film/picture_text.h"

namespace tia {

// ---- JSON -----------------------------------------------------------------------------------

namespace {

constexpr std::string_view text_words = "a PNG or JPEG file in base64 (RFC 4648)";

// A PNG of one white pixel.
constexpr std::string_view example =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4DwABAQEAHLCMmQAAAABJRU5ErkJggg==";

// The picture in the file; null, and a fault, if it cannot be decoded.
std::shared_ptr<const Image8> read_pixels(const FileBytes& file, const Place& at, Faults& faults) {
  const auto size = measure_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&size))
    return add_fault(*fault, at, faults), nullptr;
  const auto& measured = std::get<PictureSize>(size);
  end_if_asked(faults.stop());
  if (!take_pixels(measured, at, faults)) return nullptr;
  auto image = decode_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&image))
    return add_fault(*fault, at, faults), nullptr;
  return std::make_shared<const Image8>(std::get<Image8>(std::move(image)));
}

}  // namespace

void Codec<PictureFile>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                              PictureFile& out) {
  const auto file = read_file(v, text_words, most_picture_bytes, at, faults);
  if (!file) return;
  if (auto pixels = read_pixels(*file, at, faults)) out = {*v.as<std::string>(), std::move(pixels)};
}

Value Codec<PictureFile>::schema(const Spec&) { return file_schema(example); }

std::string Codec<PictureFile>::allowed(const Spec&) { return std::string(text_words); }

// ---- looking up -----------------------------------------------------------------------------

namespace {

using LightOf = std::array<double, 256>;

LightOf light_of(Encoding transfer) {
  LightOf light{};
  for (std::size_t code = 0; code < light.size(); ++code) {
    const double signal = static_cast<double>(code) / 255;
    light[code] = transfer == Encoding::srgb ? srgb_to_linear(signal) : signal;
  }
  return light;
}

// A surface coordinate in pixels, from 0 to their number, repeated. NaN is 0.
double place_in(double coordinate, int pixels) {
  const double rest = coordinate - std::floor(coordinate);
  return rest > 0 ? rest * pixels : 0;
}

// Domain: -n <= i <= n.
int wrapped(int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; }

Vec3d light_at(const ImageForm& form, int column, int row_from_below) {
  const Image8& image = *form.pixels;
  const int x = wrapped(column, image.width);
  const int y = image.height - 1 - wrapped(row_from_below, image.height);
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x));
  const LightOf& light = *form.light;
  return {light[image.rgb[at]], light[image.rgb[at + 1]], light[image.rgb[at + 2]]};
}

Vec3d between(const Vec3d& a, const Vec3d& b, double share) { return a + (b - a) * share; }

// The centre of a pixel has its colour.
Vec3d bilinear(const ImageForm& form, double x, double y) {
  const double left = std::floor(x - 0.5), below = std::floor(y - 0.5);
  const int i = static_cast<int>(left), j = static_cast<int>(below);
  const double right_share = x - 0.5 - left;
  const auto row = [&](int k) {
    return between(light_at(form, i, k), light_at(form, i + 1, k), right_share);
  };
  return between(row(j), row(j + 1), y - 0.5 - below);
}

}  // namespace

ImageForm prepare(const ImageTexture& image) {
  static const LightOf srgb = light_of(Encoding::srgb), linear = light_of(Encoding::linear);
  return {image.data.pixels, image.transfer == Encoding::srgb ? &srgb : &linear, image.filter,
          image.repeat};
}

Vec3d color_at(const ImageForm& form, const Vec3d&, const Vec2d& uv, double) {
  const double x = place_in(uv.u * form.repeat[0], form.pixels->width);
  const double y = place_in(uv.v * form.repeat[1], form.pixels->height);
  if (form.filter == Filter::bilinear) return bilinear(form, x, y);
  return light_at(form, static_cast<int>(x), static_cast<int>(y));
}

std::size_t heap_bytes(const ImageForm& form) {
  return form.pixels ? 2 * heap_block + sizeof(Image8) + heap_bytes(form.pixels->rgb) : 0;
}

}  // namespace tia
