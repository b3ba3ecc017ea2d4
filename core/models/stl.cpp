#include "core/models/stl.h"

#include <bit>
#include <cmath>
#include <string>

#include "core/models/stl_solid.h"
#include "core/models/text_words.h"

namespace tia {
namespace {

constexpr std::size_t stl_head = 84, stl_triangle = 50;

std::uint32_t stl_word(ModelBytes file, std::size_t at) {
  return std::uint32_t{file[at]} | std::uint32_t{file[at + 1]} << 8U |
         std::uint32_t{file[at + 2]} << 16U | std::uint32_t{file[at + 3]} << 24U;
}

bool is_binary_stl(ModelBytes file) {
  return file.size() >= stl_head && (file.size() - stl_head) % stl_triangle == 0 &&
         (file.size() - stl_head) / stl_triangle == stl_word(file, stl_head - 4);
}

bool is_text_stl(std::string_view text) { return is_word(cut_word(text), "solid"); }

std::string_view stl_text_of(ModelBytes file) {
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

// The corners of a triangle, which stand behind its normal.
void read_stl_corners(ModelBytes triangle, std::size_t number, StlVertices& vertices,
                      Faults& faults) {
  for (std::size_t at = 12; at < 48; at += 12) {
    StlPoint point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] = double{std::bit_cast<float>(stl_word(triangle, at + 4 * axis))};
      if (std::fabs(point[axis]) <= most_coordinate) continue;
      faults.add({FaultKind::out_of_range, "", shown_number(point[axis]),
                  "numbers from -1e9 to 1e9, as corners of triangle " + std::to_string(number)});
      return;
    }
    vertices.add(point);
  }
}

void read_binary_stl(ModelBytes file, const ModelLimits& limits, Faults& faults, Model& model) {
  const std::size_t count = (file.size() - stl_head) / stl_triangle;
  if (count == 0 || !check_stl_triangles(count, limits, faults)) return;
  StlSolid solid;
  solid.vertices.reserve(count);
  for (std::size_t i = 0; i < count && !faults.full(); ++i)
    read_stl_corners(file.subspan(stl_head + stl_triangle * i, stl_triangle), i, solid.vertices,
                     faults);
  if (faults.empty()) add_stl_solid(solid, limits, faults, model);
}

void check_stl_vertices(const ModelLimits& limits, Faults& faults, const Model& model) {
  std::uint64_t vertices = 0;
  for (const ModelMesh& mesh : model.meshes) vertices += mesh.parts.front().vertices();
  if (vertices > limits.vertices)
    faults.add({FaultKind::limit, "", Value(std::to_string(vertices) + " vertices"),
                "a model of at most " + std::to_string(limits.vertices) + " vertices"});
}

}  // namespace

bool is_stl(ModelBytes file) { return is_binary_stl(file) || is_text_stl(stl_text_of(file)); }

void read_stl(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model) {
  const ModelBytes file = files.main_file().bytes;
  model.format = "stl";
  model.z_up = true;
  model.materials.emplace_back();
  model.scenes.emplace_back();
  if (is_binary_stl(file)) read_binary_stl(file, limits, faults, model);
  else read_stl_text(stl_text_of(file), limits, faults, model);
  check_stl_vertices(limits, faults, model);
}

}  // namespace tia
