#include "server/requests/map_request.h"

#include <algorithm>

#include "core/film/pfm.h"
#include "core/film/png.h"
#include "core/film/png_text.h"
#include "core/input/json.h"
#include "core/version.h"
#include "server/requests/radio_request.h"
#include "server/requests/recipe.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

std::string map_bytes(const DrawnMap& asked, const RadioMap& map, const std::string& recipe) {
  switch (asked.format) {
    case MapFormat::json: return to_json(radio_map_json(asked, map));
    case MapFormat::pfm: {
      std::vector<float> values;
      for (const double each : map.values) values.push_back(static_cast<float>(each));
      return encode_pfm(map.grid.width, map.grid.height, values);
    }
    case MapFormat::png: break;
  }
  std::string png = encode_png(map_picture(map, asked.quantity, asked.look()));
  return with_text(std::move(png), recipe_keyword, recipe);
}

// Of a scene what waves meet, as recipes of pictures tell it.
Value told_bodies(const KnownScene& scene) {
  if (scene.objects.bytes > most_told_bytes) return "sha256:" + hex(scene.objects.digest);
  Scene bodies;
  bodies.materials = scene->materials;
  bodies.objects = scene->objects;
  return write_value(bodies);
}

}  // namespace

void DrawnMap::check(const Place& at, Faults& faults) const {
  RadioMapQuestion::check(at, faults);
  if (range && !((*range)[0] < (*range)[1]))
    faults.add({FaultKind::out_of_range, at.at("range").pointer(), write_value(range),
                "low,high, of which low is less than high"});
}

void RadioMapRequest::check(const Place& at, Faults& faults) const {
  DrawnMap::check(at, faults);
  if (wanted && *wanted != version() && *wanted != full_version())
    faults.add({FaultKind::out_of_range, at.at("version").pointer(), Value(*wanted),
                full_version() + ", which this server draws; or none, for whatever it draws"});
}

MapLimits map_limits(const Limits& limits) {
  MapLimits most;
  static_cast<RadioLimits&>(most) = radio_limits(limits);
  most.max_cells = limits.max_pixels;
  return most;
}

DrawnMap coarser(const DrawnMap& asked, const Scene& scene, int times, const Limits& limits) {
  DrawnMap coarse = asked;
  coarse.cell = times * grid_of(scene, asked, map_limits(limits)).cell;
  coarse.scale = std::min(times * asked.scale, DrawnMap::largest_scale);
  return coarse;
}

std::string recipe_of(const DrawnMap& asked, const KnownScene& scene) {
  Value request = write_value(asked);
  request.as<Value::Object>()->emplace_back("scene", told_bodies(scene));
  return to_json(Value::Object{{"map", std::move(request)}, {"version", full_version()}});
}

Picture draw_map(const DrawnMap& asked, const Scene& scene, const std::string& recipe,
                 const Limits& limits, const Workers& workers) {
  Stopwatch watch;
  Picture picture;
  if (asked.format == MapFormat::png) {
    const MapSize size = picture_size(grid_of(scene, asked, map_limits(limits)), asked.look());
    check_size(size.width, size.height, limits);
  }
  picture.timing.build = watch.lap_ms();
  const RadioMap map = radio_map(scene, asked, map_limits(limits), workers);
  picture.timing.trace = watch.lap_ms();
  picture.rays.primary = map.counts.rays;
  picture.media_type = map_formats[static_cast<std::size_t>(asked.format)].media_type;
  workers.alone([&] { picture.bytes = map_bytes(asked, map, recipe); });
  picture.timing.encode = watch.lap_ms();
  return picture;
}

}  // namespace tia::server
