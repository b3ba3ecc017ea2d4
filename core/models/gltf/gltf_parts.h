// What the parts of the glTF reader share, and the parts: each reads its lists of the document into
// the model.
#pragma once

#include "core/models/gltf/gltf_object.h"
#include "core/models/model_files.h"

namespace tia::gltf {

/// GltfBytes: where the bytes of a document's buffers are: as came, or decoded from data URIs.
class GltfBytes;

/// GltfSource: a document while it is read.
struct GltfSource {
  const GltfObject& root;  ///< the whole JSON
  const GltfBytes& bytes;
  const ModelFiles& files;
  const ModelLimits& limits;
  Faults& faults;
};

/// materials, textures, samplers, images: KHR_materials_*, KHR_texture_transform, EXT_texture_webp.
void read_materials(const GltfSource& source, Model& model);
/// cameras, KHR_lights_punctual, KHR_materials_variants' names.
void read_views(const GltfSource& source, Model& model);
/// meshes: their accessors, KHR_mesh_quantization, and which variants wear what.
void read_meshes(const GltfSource& source, Model& model);
/// nodes, scenes, EXT_mesh_gpu_instancing.
void read_nodes(const GltfSource& source, Model& model);
/// skins and animations.
void read_motion(const GltfSource& source, Model& model);

/// The bytes of a buffer view, or nothing and a fault at that place.
ModelBytes view_bytes(const GltfSource& source, ModelIndex view, const Place& at);
/// The bytes that a `uri` means, a data URI's decoded into `own`: a file that came beside, or
/// nothing and a fault at that place.
ModelBytes uri_bytes(const ModelFiles& files, std::string_view uri, const Place& at, Faults& faults,
                     std::vector<std::uint8_t>& own);

}  // namespace tia::gltf
