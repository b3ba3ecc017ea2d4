#include "core/models/formats.h"

#include <algorithm>

#include "core/models/gltf/gltf.h"
#include "core/models/obj.h"
#include "core/models/ply.h"
#include "core/models/stl.h"

namespace tia {
namespace {

// The binary ones first: only they are told apart by a few bytes.
constexpr std::array formats{ModelFormat{"gltf", "GLB, glTF", is_gltf, read_gltf},
                             ModelFormat{"ply", "PLY", is_ply, read_ply},
                             ModelFormat{"stl", "STL", is_stl, read_stl},
                             ModelFormat{"obj", "OBJ", is_obj, read_obj}};

// The first bytes as hexadecimal digits, which a text is shown by as well.
std::string first_bytes(ModelBytes file) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : file.first(std::min<std::size_t>(file.size(), 16))) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

bool shows_something(const Model& model) {
  return std::ranges::any_of(model.meshes, [](const ModelMesh& mesh) {
    return std::ranges::any_of(mesh.parts, [](const ModelPart& part) {
      return part.points ? part.vertices() > 0 : part.triangles() > 0;
    });
  });
}

}  // namespace

std::string model_formats() {
  std::string words;
  for (const ModelFormat& each : formats) {
    if (!words.empty()) words += ", ";
    words += each.words;
  }
  return words;
}

const ModelFormat* format_of(ModelBytes file) {
  const auto* row = std::ranges::find_if(formats, [&](auto& each) { return each.knows(file); });
  return row == formats.end() ? nullptr : row;
}

Model read_model(const ModelFiles& files, const ModelLimits& limits, const std::stop_token& stop) {
  const ModelBytes main = files.main_file().bytes;
  const ModelFormat* format = format_of(main);
  if (format == nullptr)
    throw InputError({FaultKind::unknown_name, "", Value("bytes " + first_bytes(main)),
                      "a file of " + model_formats()});
  Faults faults(stop);
  Model model;
  format->read(files, limits, faults, model);
  faults.raise();
  if (!shows_something(model))
    throw InputError({FaultKind::missing, "", std::nullopt, "a model with a triangle or a point"});
  return model;
}

}  // namespace tia
