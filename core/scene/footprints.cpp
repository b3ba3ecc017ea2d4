#include "core/scene/footprints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/input/json.h"

#include "core/math/deterministic.h"

namespace tia {
namespace {

constexpr double level_metres = 3, usual_levels = 3;

/// Footprint: a polygon in degrees, the outer ring first, and how high it is.
struct Footprint {
  std::string name;
  std::vector<Ring> rings;
  double low = 0, high = 0;
};

[[noreturn]] void refuse(FaultKind kind, const Place& at, const Value& got,
                         const std::string& allowed) {
  throw InputError({kind, at.pointer(), excerpt(got), allowed});
}

const Value& member(const Value& of, std::string_view name, const Place& at) {
  const auto* object = of.as<Value::Object>();
  if (object == nullptr) refuse(FaultKind::wrong_type, at, of, "an object of GeoJSON");
  if (const Value* found = find(*object, name)) return *found;
  throw InputError({FaultKind::missing, at.at(name).pointer(), std::nullopt,
                    "what GeoJSON (RFC 7946) has there"});
}
const Value::Array& array_in(const Value& value, const Place& at, const char* allowed) {
  const auto* list = value.as<Value::Array>();
  if (list == nullptr) refuse(FaultKind::wrong_type, at, value, allowed);
  return *list;
}

PlanPoint position_in(const Value& value, const Place& at) {
  constexpr const char* allowed = "[longitude, latitude], degrees in -180 to 180 and -85 to 85";
  const Value::Array& list = array_in(value, at, allowed);
  if (list.size() < 2 || list[0].as<double>() == nullptr || list[1].as<double>() == nullptr)
    refuse(FaultKind::wrong_type, at, value, allowed);
  const PlanPoint place{*list[0].as<double>(), *list[1].as<double>()};
  if (!(std::fabs(place.x) <= 180 && std::fabs(place.y) <= 85))
    refuse(FaultKind::out_of_range, at, value, allowed);
  return place;
}

Ring ring_in(const Value& value, const Place& at) {
  constexpr const char* allowed = "a ring of four positions at least, the last the first again";
  const Value::Array& list = array_in(value, at, allowed);
  Ring ring;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const PlanPoint place = position_in(list[i], at.at(i));
    if (ring.empty() || !(place == ring.back())) ring.push_back(place);
  }
  if (ring.size() < 4 || !(ring.front() == ring.back()))
    refuse(FaultKind::out_of_range, at, value, allowed);
  ring.pop_back();
  if (doubled_area(ring) == 0) refuse(FaultKind::out_of_range, at, value, "a ring around an area");
  return ring;
}

std::vector<Ring> rings_in(const Value& value, const Place& at) {
  const Value::Array& list = array_in(value, at, "a polygon's rings, the outer one first");
  if (list.empty()) refuse(FaultKind::out_of_range, at, value, "a polygon's outer ring");
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < list.size(); ++i) rings.push_back(ring_in(list[i], at.at(i)));
  return rings;
}

// A number, or one written as OpenStreetMap does: "12", "12.5 m".
std::optional<double> metres_in(const Value::Object& properties, std::string_view name,
                                const Place& at) {
  const Value* value = find(properties, name);
  if (value == nullptr || value->as<std::nullptr_t>() != nullptr) return std::nullopt;
  const double* number = value->as<double>();
  Value parsed;
  if (const auto* text = value->as<std::string>()) {
    std::string digits = *text;
    if (digits.ends_with("m")) digits.pop_back();
    while (digits.ends_with(" ")) digits.pop_back();
    try {
      parsed = parse_json(digits);
      number = parsed.as<double>();
    } catch (const InputError&) {
    }
  }
  if (number == nullptr || !(*number >= 0 && *number <= 10'000))
    refuse(FaultKind::out_of_range, at.at(name), *value, "metres, 0 to 10000");
  return *number;
}

/// Footprints: goes through a GeoJSON and collects its polygons.
class Footprints {
 public:
  std::vector<Footprint> take() { return std::move(all_); }

  void add(const Value& value, const Place& at) {
    const Value& type = member(value, "type", at);
    const auto* text = type.as<std::string>();
    if (text != nullptr && *text == "FeatureCollection") {
      const Place list = at.at("features");
      const Value::Array& features =
          array_in(member(value, "features", at), list, "a list of features");
      for (std::size_t i = 0; i < features.size(); ++i) add(features[i], list.at(i));
    } else if (text != nullptr && *text == "Feature") {
      add_feature(value, at);
    } else {
      add_geometry(value, {}, at);
    }
  }

 private:
  void add_feature(const Value& feature, const Place& at) {
    const Value& geometry = member(feature, "geometry", at);
    if (geometry.as<std::nullptr_t>() != nullptr) return;
    Footprint like;
    const auto* members = feature.as<Value::Object>();
    const Value* properties = find(*members, "properties");
    const auto* named = properties != nullptr ? properties->as<Value::Object>() : nullptr;
    const Place in = at.at("properties");
    const Value::Object none;
    const Value::Object& told = named != nullptr ? *named : none;
    like.low = metres_in(told, "min_height", in).value_or(0);
    const double levels = metres_in(told, "building:levels", in).value_or(usual_levels);
    like.high = metres_in(told, "height", in).value_or(levels * level_metres);
    if (!(like.high > like.low))
      throw InputError({FaultKind::out_of_range, in.at("height").pointer(), Value(like.high),
                        "more than min_height, which is " + number_text(like.low)});
    if (const Value* name = find(told, "name"))
      if (const auto* is = name->as<std::string>()) like.name = is->substr(0, 64);
    add_geometry(geometry, like, at.at("geometry"));
  }

  void add_geometry(const Value& geometry, const Footprint& like, const Place& at) {
    constexpr const char* allowed =
        "FeatureCollection, Feature, Polygon, MultiPolygon or GeometryCollection";
    const Value& type = member(geometry, "type", at);
    const auto* text = type.as<std::string>();
    const std::string kind = text != nullptr ? *text : "";
    if (kind == "Polygon") {
      put(like, rings_in(member(geometry, "coordinates", at), at.at("coordinates")));
    } else if (kind == "MultiPolygon") {
      const Place list = at.at("coordinates");
      const Value::Array& polygons =
          array_in(member(geometry, "coordinates", at), list, "a list of polygons");
      for (std::size_t i = 0; i < polygons.size(); ++i)
        put(like, rings_in(polygons[i], list.at(i)));
    } else if (kind == "GeometryCollection") {
      const Place list = at.at("geometries");
      const Value::Array& parts =
          array_in(member(geometry, "geometries", at), list, "a list of geometries");
      for (std::size_t i = 0; i < parts.size(); ++i) add_geometry(parts[i], like, list.at(i));
    } else if (kind != "Point" && kind != "MultiPoint" && kind != "LineString" &&
               kind != "MultiLineString") {
      refuse(FaultKind::unknown_name, at.at("type"), type, allowed);
    }
  }
  void put(Footprint like, std::vector<Ring> rings) {
    if (like.high == 0) like.high = usual_levels * level_metres;
    like.rings = std::move(rings);
    all_.push_back(std::move(like));
  }

  std::vector<Footprint> all_;
};

/// Around all positions. Space/units: degrees.
struct Frame {
  PlanPoint low{200, 200}, high{-200, -200};
  void hold(const PlanPoint& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

// Walls of two triangles, and floor and roof: closed, its outer side told by the order of corners.
Mesh block_of(const Footprint& from, const std::vector<Ring>& rings) {
  std::vector<double> positions;
  std::vector<std::uint32_t> indices;
  std::uint32_t count = 0;
  for (const Ring& ring : rings) count += static_cast<std::uint32_t>(ring.size());
  for (const double y : {from.low, from.high})
    for (const Ring& ring : rings)
      for (const PlanPoint& p : ring) positions.insert(positions.end(), {p.x, y, p.y});
  // With x to the right and z down, what turns from x towards z is seen clockwise from above.
  const bool turned = doubled_area(rings.front()) > 0;
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (turned) std::swap(b, c);
    indices.insert(indices.end(), {a, b, c});
  };
  std::uint32_t first = 0;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const auto size = static_cast<std::uint32_t>(rings[k].size());
    const bool hole_turned = (doubled_area(rings[k]) > 0) == turned && k > 0;
    for (std::uint32_t i = 0; i < size; ++i) {
      std::uint32_t a = first + i, b = first + (i + 1) % size;
      if (hole_turned) std::swap(a, b);
      triangle(a, b, b + count);
      triangle(a, b + count, a + count);
    }
    first += size;
  }
  const std::vector<std::uint32_t> caps = triangles_of(rings);
  for (std::size_t i = 0; i < caps.size(); i += 3) {
    triangle(caps[i] + count, caps[i + 1] + count, caps[i + 2] + count);
    triangle(caps[i], caps[i + 2], caps[i + 1]);
  }
  Mesh mesh;
  mesh.positions.values.assign(positions.begin(), positions.end());
  mesh.indices.values.assign(indices.begin(), indices.end());
  return mesh;
}

Object ground_of() {
  Object ground;
  ground.name = "ground";
  ground.shape = Plane{{0, 0, 0}, {0, 1, 0}};
  Finish finish;
  finish.color = Color{0.3, 0.32, 0.3};
  Material material;
  material.kind = finish;
  ground.material = Boxed<Material>(std::move(material));
  return ground;
}

}  // namespace

Geodesy Geodesy::at(double longitude, double latitude) {
  constexpr double major = 6'378'137, flattening = 1 / 298.257223563;  // WGS 84
  constexpr double square = flattening * (2 - flattening), degree = pi / 180;
  const auto [sine, cosine] = sincos_of(latitude * degree);
  const double w = 1 - square * sine * sine;
  const double meridian = major * (1 - square) / (w * std::sqrt(w));
  const double normal = major / std::sqrt(w);
  return {longitude, latitude, normal * cosine * degree, meridian * degree};
}

Scene scene_of_footprints(const Value& geojson) {
  Footprints collected;
  collected.add(geojson, Place{});
  const std::vector<Footprint> all = collected.take();
  if (all.empty())
    throw InputError({FaultKind::missing, "", std::nullopt, "a Polygon or a MultiPolygon"});
  Frame frame;
  for (const Footprint& each : all)
    for (const PlanPoint& p : each.rings.front()) frame.hold(p);
  const Geodesy geodesy =
      Geodesy::at((frame.low.x + frame.high.x) / 2, (frame.low.y + frame.high.y) / 2);
  Scene scene;
  scene.title = "Buildings";
  scene.objects.push_back(ground_of());
  double top = 0;
  for (const Footprint& each : all) {
    std::vector<Ring> rings = each.rings;
    for (Ring& ring : rings)
      for (PlanPoint& p : ring) p = geodesy.plan(p.x, p.y);
    Object block;
    block.name = each.name;
    block.shape = block_of(each, rings);
    scene.objects.push_back(std::move(block));
    top = std::max(top, each.high);
  }
  const PlanPoint corner = geodesy.plan(frame.high.x, frame.low.y);
  const double size = std::max({corner.x, corner.y, top});
  scene.camera.location = {0, 1.6 * size, 1.9 * size};
  scene.camera.look_at = Vec3d{};
  scene.camera.fov_degrees = 50;
  DirectionalLight sun;
  sun.direction = {-0.5, -1, -0.4};
  Light light;
  light.kind = sun;
  scene.lights.push_back(light);
  return scene;
}

}  // namespace tia
