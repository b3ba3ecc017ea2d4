// EXT_meshopt_compression: what is packed of a glTF document's views.
#pragma once

#include <optional>
#include <vector>

#include "core/models/gltf/gltf_filters.h"
#include "core/models/gltf/gltf_object.h"
#include "core/models/gltf/gltf_view.h"
#include "core/models/meshopt.h"

namespace tia::gltf {

inline constexpr std::string_view meshopt_name = "EXT_meshopt_compression";

/// MeshoptView: what the extension says of a view; `packed`: where its bytes lie in their buffer.
struct MeshoptView {
  GltfView packed;
  std::uint64_t count = 0;
  std::size_t stride = 0;
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
};

/// What an extension's object says. Errors: none, and faults: of what is beyond the extension's
/// rules or does not make up the view.
std::optional<MeshoptView> read_meshopt(const GltfObject& extension, const GltfView& view);

/// The view's bytes. Domain: a view whose packed bytes are there. Errors: none, and a fault of what
/// cannot be unpacked, or not into so many: 100 for each that is packed, from 64 KiB on.
std::optional<std::vector<std::uint8_t>> unpack(const GltfObject& extension,
                                                const MeshoptView& view);

}  // namespace tia::gltf
