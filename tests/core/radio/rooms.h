// What the radio tests share: rooms of planes, antennas, the short way from a scene to its paths.
#pragma once

#include <string>
#include <vector>

#include "core/radio/radio_paths.h"
#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia::test {

inline std::string triple(const Vec3d& p) {
  return "[" + number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z) + "]";
}

/// A scene of objects as text, all of one radio material.
inline Scene radio_scene(const std::string& objects, const std::string& material =
                                                         "{\"type\":"
                                                         "\"conductor\"}") {
  return read_scene("{\"materials\":{\"m\":{\"radio\":" + material + "}},\"objects\":[" + objects +
                    "]}");
}
inline std::string plane_text(const Vec3d& point, const Vec3d& normal) {
  return R"({"type":"plane","material":"m","point":)" + triple(point) +
         ",\"normal\":" + triple(normal) + "}";
}
inline std::string box_text(const Vec3d& low, const Vec3d& high) {
  return R"({"type":"box","material":"m","min":)" + triple(low) + ",\"max\":" + triple(high) + "}";
}
inline std::string triangle_text(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return R"({"type":"triangle","material":"m","a":)" + triple(a) + ",\"b\":" + triple(b) +
         ",\"c\":" + triple(c) + "}";
}
/// Six half spaces around a room.
inline std::string room_text(const Vec3d& low, const Vec3d& high) {
  return plane_text(low, {1, 0, 0}) + "," + plane_text(low, {0, 1, 0}) + "," +
         plane_text(low, {0, 0, 1}) + "," + plane_text(high, {-1, 0, 0}) + "," +
         plane_text(high, {0, -1, 0}) + "," + plane_text(high, {0, 0, -1});
}

inline RadioQuestion link(const Vec3d& from, const Vec3d& to, RadioMethod method,
                          double frequency = 1e9) {
  RadioQuestion question;
  question.transmitters.push_back({.position = from});
  question.receivers.push_back({.position = to});
  question.frequency_hz = frequency;
  question.method = method;
  question.min_gain_db = -1000;
  return question;
}
inline Vec3d point_in(Random& random, const Vec3d& low, const Vec3d& high) {
  const double x = random.in(low.x, high.x), y = random.in(low.y, high.y);
  return {x, y, random.in(low.z, high.z)};
}
inline std::vector<RadioPath> paths_of(const Scene& scene, const RadioQuestion& question) {
  return radio_paths(scene, question).pairs.front().paths;
}

}  // namespace tia::test
