// Where a glTF document's numbers lie: its buffers, views and accessors. Nothing is copied but what
// stands in data URIs or is packed.
#pragma once

#include <optional>

#include "core/models/gltf/gltf_accessors.h"
#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// GltfCame: what a document's bytes are taken from.
struct GltfCame {
  const ModelFiles& files;
  std::optional<ModelBytes> bin;  ///< a GLB's own
  const ModelLimits& limits;
};

class GltfBytes {
 public:
  /// Errors: faults of what lies beyond what it lies in, and of files that did not come.
  GltfBytes(const GltfObject& root, const GltfCame& came, Model& model);

  const std::vector<GltfView>& views() const { return views_; }
  const std::vector<Accessor>& accessors() const { return accessors_; }

 private:
  struct Buffer {
    std::optional<std::uint64_t> length;
    ModelBytes bytes;
    bool there = false;
    bool fallback = false;  ///< of views that are packed elsewhere
  };
  void read_buffer(const GltfObject& object, std::size_t number, const GltfCame& came,
                   Model& model);
  std::optional<ModelBytes> buffer_bytes(const GltfObject& object, std::size_t number,
                                         const GltfCame& came);
  void read_view(const GltfObject& object);
  void place_view(const GltfObject& object, std::size_t buffer, GltfView& view) const;
  void unpack_view(const GltfObject& extension, GltfView& view);

  std::vector<std::vector<std::uint8_t>> decoded_;  // from data URIs and packed views
  std::uint64_t packed_left_ = 0;                   // bytes that may still be unpacked
  std::vector<Buffer> buffers_;
  std::vector<GltfView> views_;
  std::vector<Accessor> accessors_;
};

/// The accessor that a member names. Returns: null where there is none, and where it cannot be
/// used, which is a fault then.
const Accessor* accessor_for(const GltfSource& source, const GltfObject& owner,
                             std::string_view name, const AccessorRule& rule);

}  // namespace tia::gltf
