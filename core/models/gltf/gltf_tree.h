// The tree of a glTF document's nodes.
#pragma once

#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// The nodes without a parent. Errors: faults of nodes with two parents, of circles and of trees
/// deeper than the limit, at the pointers that gltf-validator has. Cost: linear; no recursion.
/// Domain: children that are nodes.
std::vector<ModelIndex> check_tree(const GltfSource& source, const std::vector<ModelNode>& nodes);

}  // namespace tia::gltf
