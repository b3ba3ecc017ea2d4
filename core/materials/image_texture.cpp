#include "core/materials/image_texture.h"

#include <algorithm>
#include <cmath>

#include "core/film/decode.h"
#include "core/input/base64.h"

namespace tia {

// ---- JSON -----------------------------------------------------------------------------------

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t most_digits = (most_picture_bytes + 2) / 3 * 4;
constexpr std::string_view text_words = "a PNG or JPEG file in base64 (RFC 4648)";

// The regular expression of base64: groups of four digits, the last one padded, its unused bits 0.
constexpr std::string_view file_pattern =
    "^([A-Za-z0-9+/]{4})*([A-Za-z0-9+/][AQgw]==|[A-Za-z0-9+/]{2}[AEIMQUYcgkosw048]=)?$";
// A PNG of one white pixel.
constexpr std::string_view example =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4DwABAQEAHLCMmQAAAABJRU5ErkJggg==";

void add_limit(const Place& at, std::string got, std::string allowed, Faults& faults) {
  faults.add({FaultKind::limit, at.pointer(), Value(std::move(got)), std::move(allowed)});
}
void add(const PictureFault& fault, const Place& at, Faults& faults) {
  if (fault.beyond_limits) add_limit(at, fault.got, fault.allowed, faults);
  else detail::wrong_type(Value(fault.got), at, fault.allowed, faults);
}

// The bytes of the file; nothing, and a fault, if the text is no base64.
std::optional<Bytes> read_file(const Value& v, const Place& at, Faults& faults) {
  const auto* text = v.as<std::string>();
  Bytes bytes;
  if (text == nullptr) {
    detail::wrong_type(v, at, std::string(text_words), faults);
  } else if (text->size() > most_digits) {
    add_limit(at, std::to_string(text->size()) + " digits of base64",
              "a picture of at most " + std::to_string(most_picture_bytes) + " bytes", faults);
  } else if (const auto wrong = decode_base64(*text, bytes)) {
    constexpr std::size_t shown = 16;
    detail::wrong_type(Value(text->substr(*wrong, shown)), at,
                       std::string(text_words) + "; it is not from its character " +
                           std::to_string(*wrong) + " on",
                       faults);
  } else {
    return bytes;
  }
  return std::nullopt;
}

// Whether the input may still have so many pixels. If not, adds a fault.
bool take(Bulk bulk, std::int64_t pixels, std::string_view counted, const Place& at,
          Faults& faults) {
  if (faults.take(bulk, pixels)) return true;
  add_limit(at, std::to_string(pixels) + " pixels more",
            "pictures of at most " + std::to_string(most_of(bulk)) + " pixels together" +
                std::string(counted),
            faults);
  return false;
}

// The picture in the file; null, and a fault, if it cannot be decoded.
std::shared_ptr<const Image8> read_pixels(const Bytes& file, const Place& at, Faults& faults) {
  const auto size = measure_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&size)) return add(*fault, at, faults), nullptr;
  const auto& measured = std::get<PictureSize>(size);
  end_if_asked(faults.stop());
  if (!take(Bulk::pixels, measured.pixels(), "", at, faults) ||
      !take(Bulk::scanned_pixels, measured.scanned_pixels(), ", a JPEG's with each of its scans",
            at, faults))
    return nullptr;
  auto image = decode_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&image))
    return add(*fault, at, faults), nullptr;
  return std::make_shared<const Image8>(std::get<Image8>(std::move(image)));
}

}  // namespace

void Codec<PictureFile>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                              PictureFile& out) {
  const auto file = read_file(v, at, faults);
  if (!file) return;
  if (auto pixels = read_pixels(*file, at, faults)) out = {*v.as<std::string>(), std::move(pixels)};
}

Value Codec<PictureFile>::schema(const Spec&) {
  return Value::Object{{"type", "string"},
                       {"contentEncoding", "base64"},
                       {"pattern", file_pattern},
                       {"examples", Value::Array{example}}};
}

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
