// images, samplers, textures and texture infos: KHR_texture_transform, EXT_texture_webp. What the
// pictures show is not looked at here.
#pragma once

#include <string_view>
#include <vector>

#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// Strength: the number that a normal's or occlusion's texture info has, and its range.
struct Strength {
  std::string_view name;
  Range range;
};

/// GltfTextures: which of the model's textures a document's became. A texture without a picture
/// that can be read becomes none, with a warning.
class GltfTextures {
 public:
  /// Reads them into the model: as many images as the document has, where those that no texture
  /// names, or whose bytes an earlier one holds, have no file.
  /// Errors: as faults; `limit` where all images together hold more bytes than came.
  GltfTextures(const GltfSource& source, Model& model);

  /// How the texture info of that name looks its texture up; none where it is not there or its
  /// texture has no picture, so that its factor stays.
  MaybeTexture use(const GltfObject& owner, std::string_view name, Strength strength = {}) const;
  Model& model() const { return *model_; }

 private:
  Model* model_;
  std::vector<MaybeIndex> numbers_;  // by the document's
};

}  // namespace tia::gltf
