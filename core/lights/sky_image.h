// SkyImageLight: a picture of all that is around, infinitely far away.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/input/codec.h"
#include "core/lights/sky_map.h"

namespace tia {

/// SkyFile: a Radiance HDR, PNG or JPEG file in base64, and what it shows, which copies share.
struct SkyFile {
  std::string base64;
  std::shared_ptr<const SkyMap> map;  ///< set by reading it
  bool operator==(const SkyFile& other) const { return base64 == other.base64; }
};

/// Errors: `wrong_type` where the text is not base64 or the file no such picture; `limit` where it
/// is too large, or all pictures of the input together are.
template <>
struct Codec<SkyFile> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, SkyFile& out);
  static Value write(const SkyFile& v) { return v.base64; }
  static Value schema(const Spec&);
  static std::string allowed(const Spec&);
};

/// SkyImageLight: is seen where rays leave; the path tracer is lit by it too.
struct SkyImageLight {
  static constexpr std::string_view type = "sky_image";
  static constexpr bool endless = true;
  SkyFile data;
  double rotate_degrees = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "data", &SkyImageLight::data,
        Spec{.about = "all around by latitude and longitude: a Radiance HDR, PNG or JPEG file, at "
                      "most 8 MiB and 4096 x 2048 pixels; its middle stands in the north, -z",
             .required = true});
    visit("rotate_degrees", &SkyImageLight::rotate_degrees,
          Spec{.about = "how far its middle is turned from north towards east, x",
               .min = -360,
               .max = 360});
  }
  bool operator==(const SkyImageLight&) const = default;
};
/// Domain: one that was read without a fault.
inline SkyForm sky_of(const SkyImageLight& light) {
  return {light.data.map, light.rotate_degrees / 360};
}

}  // namespace tia
