#include "core/lights/atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "core/lights/air.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

constexpr int dome_width = 512, dome_height = 256;

/// Table: what is scattered changes slowly but for the angle's factors: few elevations, most near
/// the horizon, and few azimuths are enough. Between them it is linear.
class Table {
 public:
  explicit Table(const Air& air) {
    for (std::size_t i = 0; i <= elevations; ++i) {
      const double share = static_cast<double>(i) / elevations;
      const auto way = air.nodes(sin_degrees(90 * share * share));
      for (std::size_t k = 0; k <= azimuths; ++k)
        all_[i][k] = air.scattered(way, cos_degrees(180 * static_cast<double>(k) / azimuths));
    }
  }
  // Domain: degrees from 0 to 90, and from 0 to 180.
  Scattered at(double elevation, double azimuth) const {
    const double i = elevations * std::sqrt(elevation / 90), k = azimuths * azimuth / 180;
    const auto row = std::min(static_cast<std::size_t>(i), elevations - 1);
    const auto column = std::min(static_cast<std::size_t>(k), azimuths - 1);
    const double up = i - static_cast<double>(row), aside = k - static_cast<double>(column);
    const auto between = [&](const auto& list) {
      return list[column] * (1 - aside) + list[column + 1] * aside;
    };
    return between(all_[row]) * (1 - up) + between(all_[row + 1]) * up;
  }

 private:
  static constexpr std::size_t elevations = 32, azimuths = 16;
  std::array<std::array<Scattered, azimuths + 1>, elevations + 1> all_;
};

// Fills the upper half. Returns: the mean of the light by the cosine from the zenith, which a white
// matt ground would send back.
Vec3d fill_upper_half(const Air& air, std::vector<Vec3f>& texels) {
  const Table table(air);
  Vec3d ground{};
  for (int y = 0; y < dome_height / 2; ++y) {
    const double elevation = 90 - 180 * (y + 0.5) / dome_height, sine = sin_degrees(elevation);
    const double upper = cos_degrees(90 - 180.0 * y / dome_height),
                 lower = cos_degrees(90 - 180.0 * (y + 1) / dome_height);
    Vec3d row{};
    for (int x = 0; x < dome_width / 2; ++x) {
      const double azimuth = 360 * (x + 0.5) / dome_width;
      const Vec3d light = air.seen(table.at(elevation, azimuth), sine, cos_degrees(azimuth));
      row = row + light;
      const auto at = static_cast<std::size_t>(y * dome_width + dome_width / 2);
      texels[at + static_cast<std::size_t>(x)] = texels[at - 1 - static_cast<std::size_t>(x)] =
          static_cast<Vec3f>(light);
    }
    ground = ground + row * (2.0 / dome_width * (lower * lower - upper * upper));
  }
  return ground;
}

}  // namespace

SunlitSky make_sunlit_sky(const Weather& weather) {
  const Air air(weather.sun_elevation_degrees, weather.turbidity);
  std::vector<Vec3f> texels(std::size_t{dome_width} * dome_height);
  const Vec3d by_dome = fill_upper_half(air, texels), sun = air.sun();
  const double height = std::max(0.0, sin_degrees(weather.sun_elevation_degrees));
  const Vec3d ground = (by_dome + sun * height) * weather.ground;
  std::fill(texels.begin() + std::ptrdiff_t{dome_width} * dome_height / 2, texels.end(),
            static_cast<Vec3f>(ground));
  return {sun, std::make_shared<const SkyMap>(dome_width, dome_height, std::move(texels))};
}

std::shared_ptr<const SunlitSky> sunlit_sky(const Weather& weather) {
  struct Kept {
    Weather weather;
    std::shared_ptr<const SunlitSky> sky;
  };
  static std::mutex mutex;
  static std::array<Kept, 5> last;
  static std::size_t oldest = 0;
  {
    const std::lock_guard lock(mutex);
    for (const Kept& each : last)
      if (each.sky && each.weather == weather) return each.sky;
  }
  auto made = std::make_shared<const SunlitSky>(make_sunlit_sky(weather));
  const std::lock_guard lock(mutex);
  last[oldest] = {weather, made};
  oldest = (oldest + 1) % last.size();
  return made;
}

}  // namespace tia
