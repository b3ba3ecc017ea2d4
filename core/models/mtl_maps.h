// The pictures that MTL files name, with the options before their names.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/models/model.h"
#include "core/models/mtl_reading.h"

namespace tia {

/// The most different names of pictures in an MTL file.
inline constexpr std::size_t most_mtl_names = 2048;

/// MtlMaps: makes one image of each file, and one texture of each image and wrap.
class MtlMaps {
 public:
  explicit MtlMaps(MtlReading& reading);

  /// What stands after a statement's name: options, then the file's name, which may have blanks.
  /// -s and -o scale and move, -clamp on ends the repetition, -bm is a normal map's strength.
  /// Returns: nothing, and a warning or a fault, where the picture did not come or is none.
  MaybeTexture read(std::string_view statement, ObjWords words);

 private:
  MaybeIndex image(std::string_view name);
  MaybeIndex find_image(std::string_view name);
  ModelIndex texture(ModelIndex image, Wrap wrap);

  MtlReading& reading_;
  std::map<std::string, MaybeIndex, std::less<>> names_;  // as this file has them
  std::map<std::string, ModelIndex, std::less<>> images_;
  std::map<std::pair<ModelIndex, Wrap>, ModelIndex> textures_;
};

}  // namespace tia
