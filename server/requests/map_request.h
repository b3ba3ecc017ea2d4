// The parameters of /radio/map, and what is drawn for them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/radio/map_picture.h"
#include "server/requests/render_context.h"
#include "server/requests/render_request.h"
#include "server/stores/picture.h"

namespace tia::server {

enum class MapFormat { png, pfm, json };

/// MapFormatRow: what a format of maps is called, in requests and as a file's ending, and over
/// HTTP.
struct MapFormatRow {
  MapFormat format;
  std::string_view name, media_type;
};
/// THE LIST of formats of maps. Of those that a client likes equally well the first is given.
inline constexpr std::array map_formats = std::to_array<MapFormatRow>({
    {MapFormat::png, "png", "image/png"},
    {MapFormat::pfm, "pfm", "image/x-portable-floatmap"},
    {MapFormat::json, "json", "application/json"},
});

}  // namespace tia::server

template <>
struct tia::Names<tia::server::MapFormat> {
  static constexpr std::array<std::string_view, 3> names{"png", "pfm", "json"};
};

namespace tia::server {

/// DrawnMap: what is told of waves, and how.
struct DrawnMap : RadioMapQuestion {
  static constexpr std::string_view schema_name = "drawn_map";
  static constexpr int largest_scale = 64;
  MapFormat format = MapFormat::png;
  int scale = 4;
  bool legend = true;
  std::optional<std::array<double, 2>> range;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using M = DrawnMap;
    RadioMapQuestion::fields(visit);
    visit("format", &M::format,
          Spec{.about = "png, in colours; pfm, one float a cell, NaN where nothing is; json, rows "
                        "of numbers; else what Accept prefers"});
    visit("scale", &M::scale,
          Spec{.about = "of a png: the side of a cell",
               .unit = "pixels",
               .min = 1,
               .max = largest_scale});
    visit("legend", &M::legend,
          Spec{.about = "of a png: whether there is a legend at its right; without it the picture "
                        "is the cells times scale"});
    visit(
        "range", &M::range,
        Spec{.about = "of a png: the values of the first and the last colour, so that maps can be "
                      "compared; else they are what the map has",
             .min = -1e9,
             .max = 1e9});
  }
  /// Besides what a question may be wrong in: a range that is empty.
  void check(const Place& at, Faults& faults) const;
  MapLook look() const { return {scale, legend, range}; }
};

struct RadioMapRequest : DrawnMap {
  static constexpr std::string_view schema_name = "radio_map_request";
  std::variant<std::string, Scene> scene;
  std::optional<std::string> wanted;  ///< the version
  std::optional<Stream> stream;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using R = RadioMapRequest;
    visit("scene", &R::scene,
          Spec{.about = "what waves meet: a scene's name, a kept scene's id, or a whole scene; of "
                        "one that moves, the time 0",
               .required = true});
    DrawnMap::fields(visit);
    visit("version", &R::wanted,
          Spec{.about = "the version whose bytes are wanted, as /version tells it: caches may keep "
                        "the map for good"});
    visit(
        "stream", &R::stream,
        Spec{.about = "the map while it is drawn, a png: those of larger cells first, and the map "
                      "itself last, as the streams of /render"});
  }
  /// Also a version that is not this one.
  void check(const Place& at, Faults& faults) const;
};

/// What one map may take.
MapLimits map_limits(const Limits& limits);

/// The same map, of so many times larger cells and as large a picture. Errors: as radio_map.
DrawnMap coarser(const DrawnMap& asked, const Scene& scene, int times, const Limits& limits);

/// {"map":{…},"version":"…"}: what POST /radio/map takes, without what is as it would be anyhow:
/// the same for requests that ask for the same map in other words. Canonical text (RFC 8785).
std::string recipe_of(const DrawnMap& asked, const KnownScene& scene);

/// The file of a map; a PNG carries its recipe. Errors: as radio_map; InputError of a picture with
/// too many pixels; Stopped.
Picture draw_map(const DrawnMap& asked, const Scene& scene, const std::string& recipe,
                 const Limits& limits, const Workers& workers);

}  // namespace tia::server
