#include "core/lights/sky_image.h"

#include <utility>

#include "core/film/picture_text.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

constexpr std::string_view text_words =
    "a Radiance HDR, PNG or JPEG file in base64 (RFC 4648), twice as wide as high";

// A PNG of two white pixels.
constexpr std::string_view example =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAAAAADRSSBWAAAAC0lEQVR42mP4/x8AAwAB/2+Bq7YAAAAASUVORK5CYII=";

// What the file shows; null, and a fault, if it cannot be used.
std::shared_ptr<const SkyMap> map_in(const FileBytes& file, const Place& at, Faults& faults) {
  const auto size = measure_sky(file);
  if (const auto* fault = std::get_if<PictureFault>(&size))
    return add_fault(*fault, at, faults), nullptr;
  const auto& measured = std::get<PictureSize>(size);
  end_if_asked(faults.stop());
  if (!take_pixels(measured, at, faults)) return nullptr;
  auto picture = decode_sky(file);
  if (const auto* fault = std::get_if<PictureFault>(&picture))
    return add_fault(*fault, at, faults), nullptr;
  return std::make_shared<const SkyMap>(
      measured.width, measured.height,
      std::make_shared<const SkyPicture>(std::get<SkyPicture>(std::move(picture))));
}

}  // namespace

void Codec<SkyFile>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                          SkyFile& out) {
  const auto file = read_file(v, text_words, sky_picture_limits.bytes, at, faults);
  if (!file) return;
  if (auto map = map_in(*file, at, faults)) out = {*v.as<std::string>(), std::move(map)};
}

Value Codec<SkyFile>::schema(const Spec&) { return file_schema(example); }

std::string Codec<SkyFile>::allowed(const Spec&) { return std::string(text_words); }

}  // namespace tia
