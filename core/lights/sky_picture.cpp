#include "core/lights/sky_picture.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/film/tonemap.h"

namespace tia {
namespace {

constexpr double most_light = 1e9;  // as much as places; what is added up stays finite in float

// What is wrong with what the texels say; none where it is good.
std::optional<PictureFault> fault_of(const SkyPicture& picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const Vec3f light = picture.texel(x, y);
      if (std::max({light.x, light.y, light.z}) > static_cast<float>(most_light))
        return PictureFault{
            false,
            "the texel " + std::to_string(x) + ", " + std::to_string(y) + ", brighter than 1e9",
            "a picture of texels up to 1e9"};
    }
  return std::nullopt;
}

std::optional<PictureFault> shape_fault(const PictureSize& size) {
  if (size.width == 2 * size.height) return std::nullopt;
  return PictureFault{false,
                      std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
                      "a picture by latitude and longitude, twice as wide as high"};
}

using LightOf = std::array<float, 256>;

const LightOf& light_of_codes() {
  static const LightOf light = [] {
    LightOf each{};
    for (std::size_t code = 0; code < each.size(); ++code)
      each[code] = static_cast<float>(srgb_to_linear(static_cast<double>(code) / 255));
    return each;
  }();
  return light;
}

// 2^(exponent - 136) of each exponent, and 0 of 0.
const LightOf& light_of_exponents() {
  static const LightOf light = [] {
    LightOf each{};
    float step = 0x1p-135F;  // of exponent 1; below the normal floats, and exact
    for (std::size_t exponent = 1; exponent < each.size(); ++exponent, step *= 2)
      each[exponent] = step;
    return each;
  }();
  return light;
}

Vec3f texel_of(const Image8& image, std::size_t at) {
  const LightOf& light = light_of_codes();
  return {light[image.rgb[3 * at]], light[image.rgb[3 * at + 1]], light[image.rgb[3 * at + 2]]};
}
Vec3f texel_of(const RgbeImage& image, std::size_t at) {
  const auto& [r, g, b, exponent] = image.pixels[at];
  const float step = light_of_exponents()[exponent];
  return {static_cast<float>(r) * step, static_cast<float>(g) * step, static_cast<float>(b) * step};
}

}  // namespace

int SkyPicture::width() const {
  return std::visit([](const auto& each) { return each.width; }, image);
}
int SkyPicture::height() const {
  return std::visit([](const auto& each) { return each.height; }, image);
}
Vec3f SkyPicture::texel(int x, int y) const {
  const auto at =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x);
  return std::visit([&](const auto& each) { return texel_of(each, at); }, image);
}

std::size_t heap_bytes(const SkyPicture& picture) {
  if (const auto* codes = std::get_if<Image8>(&picture.image)) return heap_bytes(codes->rgb);
  return heap_bytes(std::get<RgbeImage>(picture.image).pixels);
}

std::variant<PictureSize, PictureFault> measure_sky(std::span<const std::uint8_t> file) {
  auto size = is_hdr(file) ? measure_hdr(file, sky_picture_limits)
                           : measure_picture(file, sky_picture_limits);
  if (const auto* measured = std::get_if<PictureSize>(&size))
    if (const auto fault = shape_fault(*measured)) return *fault;
  return size;
}

std::variant<SkyPicture, PictureFault> decode_sky(std::span<const std::uint8_t> file) {
  const auto checked = [](auto decoded) -> std::variant<SkyPicture, PictureFault> {
    if (auto* fault = std::get_if<PictureFault>(&decoded)) return std::move(*fault);
    SkyPicture picture{std::get<0>(std::move(decoded))};
    if (auto fault = fault_of(picture)) return std::move(*fault);
    return picture;
  };
  if (is_hdr(file)) return checked(decode_hdr(file, sky_picture_limits));
  return checked(decode_picture(file, sky_picture_limits));
}

}  // namespace tia
