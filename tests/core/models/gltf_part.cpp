#include "tests/core/models/gltf_part.h"

#include "core/input/json.h"
#include "core/models/gltf/gltf_bytes.h"

namespace tia::test {

PartRead read_part(GltfPart part, const std::string& json, const std::vector<NamedFile>& files) {
  PartRead read;
  ModelFiles all;
  const Bytes main = to_bytes(json);
  all.all.push_back({"model.gltf", main});
  for (const NamedFile& file : files) all.all.push_back({file.path, file.bytes});
  const Value document = parse_json(json);
  const gltf::GltfObject root(&document, {}, read.faults);
  const ModelLimits limits;
  const gltf::GltfBytes bytes(root, {all, std::nullopt, limits}, read.model);
  part({root, bytes, all, limits, read.faults}, read.model);
  return read;
}

}  // namespace tia::test
