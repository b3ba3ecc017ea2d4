#include "core/models/obj.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/models/obj_lines.h"
#include "core/models/obj_parts.h"
#include "core/models/obj_statements.h"

namespace tia {
namespace {

constexpr std::size_t obj_bytes_without_nul = 4096, obj_bytes_looked_at = 1 << 20;

constexpr std::array<std::string_view, 16> obj_statements{
    "v", "vt", "vn", "vp",  "f",      "l",      "p",      "o",
    "g", "s",  "mg", "lod", "mtllib", "usemtl", "cstype", "usemap"};

bool is_obj_statement(std::string_view word) {
  return std::find(obj_statements.begin(), obj_statements.end(), word) != obj_statements.end();
}

}  // namespace

bool is_obj(ModelBytes file) {
  const ModelBytes start = file.first(std::min(file.size(), obj_bytes_without_nul));
  if (std::find(start.begin(), start.end(), 0) != start.end()) return false;
  const bool is_long = file.size() > obj_bytes_looked_at;
  ObjLines lines(file.first(std::min(file.size(), obj_bytes_looked_at)));
  bool has_any = false, has_position = false, has_other = is_long;
  while (lines.next()) {
    ObjWords words(lines.line());
    const std::string_view word = words.take();
    if (word.empty()) continue;
    const bool is_known = is_obj_statement(word);
    if (!is_known && !has_any) return false;
    has_any = true;
    double x = 0;
    if (word == "v") has_position = has_position || words.take(x) == ObjNumber::taken;
    else has_other = has_other || is_known;
    if (has_position && has_other) return true;
  }
  return false;
}

void read_obj(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model) {
  model.format = "obj";
  model.scenes.emplace_back();
  const ObjContent content = read_obj_content(files, limits, faults, model);
  if (faults.empty()) add_obj_meshes(content, limits, faults, model);
}

}  // namespace tia
