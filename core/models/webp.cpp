#include "core/models/webp.h"

#include <webp/decode.h>

#include <new>
#include <string_view>

namespace tia {
namespace {

PictureFault broken_webp(std::string_view got) {
  return {false, std::string(got), "a whole WebP picture, not an animation"};
}

bool webp_has_at(ModelBytes file, std::size_t at, std::string_view text) {
  const std::string_view all(reinterpret_cast<const char*>(file.data()), file.size());
  return all.size() >= at && all.substr(at).starts_with(text);
}

}  // namespace

bool is_webp(ModelBytes file) {
  return webp_has_at(file, 0, "RIFF") && webp_has_at(file, 8, "WEBP");
}

std::variant<PictureSize, PictureFault> measure_webp(ModelBytes file, const PictureLimits& limits) {
  if (auto fault = beyond(file.size(), limits)) return *fault;
  // Without its RIFF header libwebp would take a bare stream.
  if (!is_webp(file)) return broken_webp("bytes that begin otherwise");
  WebPBitstreamFeatures features{};
  if (WebPGetFeatures(file.data(), file.size(), &features) != VP8_STATUS_OK)
    return broken_webp("bytes that cannot be decoded");
  if (features.has_animation != 0) return broken_webp("an animation");
  const PictureSize size{features.width, features.height};
  if (size.width < 1 || size.height < 1) return broken_webp("bytes that cannot be decoded");
  if (auto fault = beyond(size, limits)) return *fault;
  return size;
}

std::variant<ImageRgba8, PictureFault> decode_webp(ModelBytes file, const PictureLimits& limits) {
  const auto measured = measure_webp(file, limits);
  if (const auto* fault = std::get_if<PictureFault>(&measured)) return *fault;
  const auto& size = std::get<PictureSize>(measured);
  ImageRgba8 image{size.width, size.height, {}};
  image.rgba.resize(static_cast<std::size_t>(4 * size.pixels()));
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0) throw std::bad_alloc();  // a libwebp of other structs
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {image.rgba.data(), 4 * size.width, image.rgba.size()};
  const VP8StatusCode status = WebPDecode(file.data(), file.size(), &config);
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != VP8_STATUS_OK) return broken_webp("bytes that cannot be decoded");
  return image;
}

}  // namespace tia
