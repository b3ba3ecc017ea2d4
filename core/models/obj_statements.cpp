#include "core/models/obj_statements.h"

#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "core/models/obj_corner.h"
#include "core/models/obj_libraries.h"
#include "core/models/obj_lines.h"
#include "core/models/obj_reading.h"
#include "core/models/obj_rows.h"

namespace tia {
namespace {

/// ObjReader: goes through the lines.
class ObjReader {
 public:
  ObjReader(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model)
      : reading_(files.main_file().bytes, limits, faults, model),
        libraries_(files, faults, model) {}

  ObjContent read() {
    while (reading_.next()) statement(ObjWords(reading_.line()));
    content_.lacks_library = libraries_.lacks_one();
    return std::move(content_);
  }

 private:
  void statement(ObjWords words) {
    const std::string_view word = words.take();
    if (word.empty()) return;
    if (word.size() == 1) return short_statement(word, words);
    if (word == "vn") read_obj_normal(words, reading_, content_);
    else if (word == "vt") read_obj_uv(words, reading_, content_);
    else if (word == "usemtl") use_material(words.rest());
    else if (word == "mtllib") libraries_.read(words.rest(), reading_.number());
    else skip(word);
  }
  void short_statement(std::string_view letter, const ObjWords& words) {
    switch (letter[0]) {
      case 'v': return read_obj_position(words, reading_, content_);
      case 'f': return face(words);
      case 'p': return points(words);
      case 'o': return begin_object(ObjWords(words).rest());
      case 'g': return begin_group(words);
      case 's': return;  // smoothing groups: what is smooth has normals
      default: return skip(letter);
    }
  }
  void skip(std::string_view word) {
    const std::string name = excerpt_of(word, 64);
    reading_.warn_once(name, name + ": statements of this kind are not taken");
  }

  // ---- elements -------------------------------------------------------------------------------

  // Appends the corners of a line. Returns: how many; none, with a fault, where a word is no
  // corner.
  std::size_t read_corners(ObjWords words, ObjCorners& corners, std::uint64_t most) {
    const ObjCounts counts{content_.positions.size() / 3, content_.uvs.size() / 2,
                           content_.normals.size() / 3};
    const std::size_t before = corners.size();
    while (!words.empty()) {
      ObjCorner corner;
      const auto wrong = take_obj_corner(words, counts, corner);
      const bool too_many = corners.size() - before >= most;
      if (!wrong && !too_many) {
        corners.push_back(corner);
        continue;
      }
      corners.shrink(before);
      if (wrong) reading_.fault(*wrong, words.take(), obj_corner_words(*wrong, counts));
      else reading_.stop(reading_.line(), most, "corners of a polygon");
      return 0;
    }
    return corners.size() - before;
  }
  void face(const ObjWords& words) {
    ObjCorners& all = content_.faces.corners;
    const ModelLimits& limits = reading_.limits();
    const std::size_t faults = reading_.faults();
    all.for_each_list([&](auto& list) { reading_.make_room(3, list); });
    const std::size_t corners = read_corners(words, all, limits.polygon_corners);
    if (reading_.faults() != faults) return;
    if (corners < 3) {
      all.shrink(all.size() - corners);
      return reading_.fault(FaultKind::malformed, reading_.line(), "f and three corners or more");
    }
    triangles_ += corners - 2;
    if (triangles_ > limits.triangles)
      return reading_.stop(reading_.line(), limits.triangles, "triangles");
    add_element(content_.faces, corners);
  }
  void points(const ObjWords& words) {
    ObjElements& points = content_.points;
    const std::uint64_t most = reading_.limits().vertices;
    const std::size_t count = read_corners(words, points.corners, most);
    if (points.corners.size() > most) return reading_.stop(reading_.line(), most, "points");
    for (std::size_t i = 0; i < count; ++i) add_element(points, 1);
  }
  // An element of the next corners that no run has yet.
  void add_element(ObjElements& elements, std::size_t corners) {
    if (begins_mesh_ && !begin_mesh()) return;
    const auto mesh = static_cast<std::uint32_t>(content_.meshes.size() - 1);
    const ObjRun last = elements.runs.empty() ? ObjRun{} : elements.runs.back();
    if (last.count == 0 || last.mesh != mesh || last.material != material_)
      elements.runs.push_back(
          {mesh, material_, elements.sizes.size(), 0, last.first_corner + last.corners, 0});
    reading_.make_room(1, elements.sizes);
    elements.sizes.push_back(static_cast<std::uint32_t>(corners));
    ++elements.runs.back().count;
    elements.runs.back().corners += corners;
  }

  // ---- state ----------------------------------------------------------------------------------

  // Where the first element comes: many names have none after them.
  bool begin_mesh() {
    const std::uint64_t most = reading_.limits().nodes;
    if (content_.meshes.size() >= most) {
      reading_.stop(mesh_, most, "objects (o) or groups (g), which are nodes");
      return false;
    }
    content_.meshes.push_back(mesh_);
    begins_mesh_ = false;
    return true;
  }
  void begin_object(std::string_view name) {
    has_objects_ = true;
    begins_mesh_ = true;
    mesh_ = name;
  }
  // The same group once more goes on.
  void begin_group(ObjWords words) {
    if (has_objects_) return;
    std::string name;
    for (ObjWords left(words.rest()); !left.empty();)
      name.append(name.empty() ? "" : " ").append(left.take());
    begins_mesh_ = begins_mesh_ || name != mesh_;
    mesh_ = std::move(name);
  }
  void use_material(std::string_view name) {
    auto found = materials_.find(name);
    if (found == materials_.end()) {
      const auto index = static_cast<std::uint32_t>(content_.materials.size());
      found = materials_.emplace(name, index).first;
      content_.materials.push_back({std::string(name), reading_.number()});
    }
    material_ = found->second;
  }

  ObjReading reading_;
  ObjLibraries libraries_;
  ObjContent content_;
  std::map<std::string, std::uint32_t, std::less<>> materials_;
  std::string mesh_;  // the name of the present mesh, or of the next one
  std::uint32_t material_ = 0;
  std::uint64_t triangles_ = 0;
  bool begins_mesh_ = true, has_objects_ = false;
};

}  // namespace

ObjContent read_obj_content(const ModelFiles& files, const ModelLimits& limits, Faults& faults,
                            Model& model) {
  return ObjReader(files, limits, faults, model).read();
}

}  // namespace tia
