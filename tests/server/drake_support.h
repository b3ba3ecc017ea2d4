// What Drake's client sends: a scene of walls whose places and colours are known, and the form.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/math/vec3.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/server/support.h"

namespace tia::test {

/// DrakeWall: a triangle with its colour, n/255 each, in the sensor's own axes.
struct DrakeWall {
  Vec3d a, b, c;
  int red, green, blue;
};

/// DrakeSensor: where it is in the world; columns of its node's matrix.
struct DrakeSensor {
  Vec3d right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1}, location{};

  Vec3d in_world(const Vec3d& p) const { return right * p.x + up * p.y + back * p.z + location; }
};

inline std::string number_text(double number) {
  char text[32];
  static_cast<void>(std::snprintf(text, sizeof text, "%.17g", number));
  return text;
}
inline std::string list_text(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + number_text(number);
  return "[" + text + "]";
}

/// As vtkGLTFExporter writes it: a mesh and a material for each, then the camera's node.
inline std::string drake_scene(const std::vector<DrakeWall>& walls, const DrakeSensor& sensor) {
  gltf_files::GltfBuilder file;
  std::string nodes, meshes, materials, all;
  for (const DrakeWall& wall : walls) {
    std::vector<float> corners;
    for (const Vec3d& p : {wall.a, wall.b, wall.c}) {
      const Vec3d q = sensor.in_world(p);
      for (const double x : {q.x, q.y, q.z}) corners.push_back(static_cast<float>(x));
    }
    const std::string number = std::to_string(file.vec3(corners));
    meshes += R"({"primitives":[{"attributes":{"POSITION":)" + number + R"(},"material":)" +
              number + "}]},";
    materials += R"({"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":)" +
                 list_text({wall.red / 255.0, wall.green / 255.0, wall.blue / 255.0, 1}) + "}},";
    nodes += R"({"mesh":)" + number + "},";
    all += number + ",";
  }
  const auto& [r, u, b, p] = sensor;
  nodes += R"({"camera":0,"name":"Camera Node","matrix":)" +
           list_text({r.x, r.y, r.z, 0, u.x, u.y, u.z, 0, b.x, b.y, b.z, 0, p.x, p.y, p.z, 1}) +
           "}";
  meshes.pop_back(), materials.pop_back();
  file.set("meshes", "[" + meshes + "]");
  file.set("materials", "[" + materials + "]");
  file.set("nodes", "[" + nodes + "]");
  file.set("scene", "0");
  file.set("scenes", R"([{"nodes":[)" + all + std::to_string(walls.size()) + "]}]");
  file.set("cameras", R"([{"type":"perspective","perspective":{"yfov":0.8,"znear":0.01}}])");
  return file.json(R"(,"uri":"data:application/octet-stream;base64,)" + base64(to_text(file.bin)) +
                   "\"");
}

/// The fields in the order of Drake's map, numbers by std::to_string.
using DrakeFields = std::vector<std::pair<std::string, std::string>>;
inline DrakeFields drake_fields(const std::string& image_type) {
  DrakeFields fields{
      {"center_x", "31.500000"}, {"center_y", "20.250000"}, {"far", "10.000000"},
      {"focal_x", "50.000000"},  {"focal_y", "40.000000"},  {"fov_x", "1.138871"},
      {"fov_y", "1.081689"},     {"height", "48"},          {"image_type", image_type}};
  if (image_type == "depth")
    fields.insert(fields.end(), {{"max_depth", "5.000000"}, {"min_depth", "2.000000"}});
  fields.insert(fields.end(), {{"near", "0.010000"}, {"submit", "Render"}, {"width", "64"}});
  return fields;
}
inline void set_field(DrakeFields& fields, const std::string& name, const std::string& text) {
  for (auto& field : fields)
    if (field.first == name) return void(field.second = text);
  fields.emplace_back(name, text);
}

/// As libcurl's curl_mime writes it.
inline constexpr const char* drake_boundary = "------------------------c13a866cb4280bc1";
inline std::string drake_type() {
  return std::string("multipart/form-data; boundary=") + drake_boundary;
}
inline std::string drake_form(const DrakeFields& fields, const std::string& scene) {
  const std::string line = std::string("--") + drake_boundary;
  std::string body;
  for (const auto& [name, text] : fields)
    body +=
        line + "\r\nContent-Disposition: form-data; name=\"" + name + "\"\r\n\r\n" + text + "\r\n";
  if (!scene.empty())
    body += line +
            "\r\nContent-Disposition: form-data; name=\"scene\"; "
            "filename=\"0000000000000000001-color.gltf\"\r\nContent-Type: model/gltf+json\r\n\r\n" +
            scene + "\r\n";
  return body + line + "--\r\n";
}

inline Response send_drake(const DrakeFields& fields, const std::string& scene,
                           const std::string& query = "") {
  return host().post("/render" + query, drake_form(fields, scene), drake_type());
}

/// A wall that the sensor sees in its middle.
inline const std::string& plain_scene() {
  static const std::string scene =
      drake_scene({{{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}, 10, 20, 30}}, {});
  return scene;
}

}  // namespace tia::test
