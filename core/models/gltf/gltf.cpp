#include "core/models/gltf/gltf.h"

#include "core/input/json.h"
#include "core/models/gltf/glb.h"
#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_head.h"
#include "core/models/gltf/gltf_parts.h"
#include "core/models/gltf/gltf_uses.h"
#include "core/models/gltf/gltf_words.h"

namespace tia {
namespace gltf {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

// What is wrong with the text is a fault like any other.
std::optional<Value> parsed(std::string_view json, const ModelLimits& limits, Faults& faults) {
  constexpr std::size_t depth = 64;  // extras are the writer's own
  try {
    return parse_json(json, {.depth = depth, .values = limits.json_values, .option = {}},
                      faults.stop());
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) faults.add(fault);
  }
  return std::nullopt;
}

void read_parts(const GltfSource& source, Model& model) {
  for (const auto read : {read_materials, read_views, read_meshes, read_nodes, read_motion})
    if (!source.faults.full()) read(source, model);
  if (source.faults.empty()) check_uses(source.root);
}

void read_document(const GlbParts& document, const ModelFiles& files, const ModelLimits& limits,
                   Faults& faults, Model& model) {
  const std::optional<Value> json = parsed(without_mark(document.json), limits, faults);
  if (!json) return;
  const GltfObject root(&*json, Place{}, faults);
  if (!read_head(root, model)) return;
  const GltfBytes bytes(root, {files, document.bytes, limits}, model);
  read_parts({root, bytes, files, limits, faults}, model);
}

}  // namespace
}  // namespace gltf

bool is_gltf(ModelBytes file) {
  if (gltf::is_glb(file)) return true;
  const std::string_view text = gltf::without_mark(gltf::text_of(file));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '{' && text.find("\"asset\"") != text.npos;
}

void read_gltf(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model) {
  const ModelBytes file = files.main_file().bytes;
  const bool boxed = gltf::is_glb(file);
  model.format = boxed ? "glb" : "gltf";
  const auto document = boxed ? gltf::open_glb(file, faults, model)
                              : std::optional(gltf::GlbParts{gltf::text_of(file), std::nullopt});
  if (document) gltf::read_document(*document, files, limits, faults, model);
}

}  // namespace tia
