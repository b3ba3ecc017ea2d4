// The gallery's models: the files of web/models, by name and by id. What they hold is read as any
// other model is, by ModelStore.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/input/value.h"
#include "core/input/value_codecs.h"

namespace tia::server {

/// GalleryModel: a file that comes with the server.
struct GalleryModel {
  std::string_view name;  ///< "chess": of the file "chess.glb"
  std::string_view bytes;
  std::string id;  ///< SHA-256 of the bytes
  std::string_view format;
};

/// All of them, sorted by name. Cost: the first call goes over all their bytes.
const std::vector<GalleryModel>& gallery_models();

/// The one of that name or id, or null.
const GalleryModel* gallery_model(std::string_view name_or_id);

std::vector<std::string_view> gallery_model_names();

/// What they are called, how large they are and where, as JSON.
std::string gallery_models_listing();
Value gallery_models_schema(Definitions& named);

}  // namespace tia::server
