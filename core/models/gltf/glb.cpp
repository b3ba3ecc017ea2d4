#include "core/models/gltf/glb.h"

#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

constexpr std::uint32_t glb_json = 0x4E4F534A, glb_bytes = 0x004E4942;  // "JSON", "BIN\0"
constexpr std::size_t glb_header = 12, chunk_header = 8;

struct GlbChunk {
  std::uint32_t type = 0;
  ModelBytes bytes;
};

void malformed_glb(Faults& faults, std::string got, std::string allowed) {
  faults.add({FaultKind::malformed, "", Value(std::move(got)), std::move(allowed)});
}

// The next chunk, which is taken off the rest.
std::optional<GlbChunk> take_chunk(ModelBytes& rest, Faults& faults) {
  if (rest.size() < chunk_header) {
    malformed_glb(faults, bytes_text(rest.size()), "a GLB chunk's header of 8 bytes");
    return std::nullopt;
  }
  const std::uint64_t length = load<std::uint32_t>(rest.data());
  const GlbChunk chunk{load<std::uint32_t>(rest.data() + 4), {}};
  rest = rest.subspan(chunk_header);
  if (length > rest.size() || length % 4 != 0) {
    malformed_glb(faults, "a chunk of " + bytes_text(length),
                  "a GLB chunk of a multiple of 4 bytes, at most the " +
                      std::to_string(rest.size()) + " that are left");
    return std::nullopt;
  }
  const ModelBytes bytes = rest.first(length);
  rest = rest.subspan(length);
  return GlbChunk{chunk.type, bytes};
}

// What is in the box by its header; none and a fault where that is wrong.
std::optional<ModelBytes> inside_glb(ModelBytes file, Faults& faults, Model& model) {
  if (file.size() < glb_header) {
    malformed_glb(faults, bytes_text(file.size()), "a GLB header of 12 bytes");
    return std::nullopt;
  }
  const std::uint32_t version = load<std::uint32_t>(file.data() + 4);
  if (version != 2) {
    malformed_glb(faults, "version " + std::to_string(version), "GLB of version 2");
    return std::nullopt;
  }
  const std::uint64_t length = load<std::uint32_t>(file.data() + 8);
  if (length > file.size() || length < glb_header) {
    malformed_glb(faults, bytes_text(file.size()),
                  "as many bytes as the GLB's header says: " + std::to_string(length));
    return std::nullopt;
  }
  if (length < file.size())
    model.warn({"", 0, bytes_text(file.size() - length) + " after the GLB's end are not read"});
  return file.subspan(glb_header, length - glb_header);
}

}  // namespace

bool is_glb(ModelBytes file) {
  return file.size() >= 4 && load<std::uint32_t>(file.data()) == 0x46546C67;  // "glTF"
}

std::optional<GlbParts> open_glb(ModelBytes file, Faults& faults, Model& model) {
  std::optional<ModelBytes> rest = inside_glb(file, faults, model);
  if (!rest) return std::nullopt;
  GlbParts parts;
  for (std::size_t i = 0; i == 0 || !rest->empty(); ++i) {
    const std::optional<GlbChunk> chunk = take_chunk(*rest, faults);
    if (!chunk) return std::nullopt;
    const bool is_json = chunk->type == glb_json, is_bytes = chunk->type == glb_bytes;
    if (is_json != (i == 0) || (is_bytes && i != 1)) {
      malformed_glb(faults,
                    "chunk " + std::to_string(i + 1) + " of type " + std::to_string(chunk->type),
                    "the JSON chunk first and once, then a BIN chunk or none, then others");
      return std::nullopt;
    }
    if (is_json) parts.json = text_of(chunk->bytes);
    if (is_bytes) parts.bytes = chunk->bytes;
  }
  return parts;
}

}  // namespace tia::gltf
