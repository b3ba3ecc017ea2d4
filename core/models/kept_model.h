// KeptModel: a model as it is kept for scenes to show.
#pragma once

#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/models/model.h"

namespace tia {

/// KeptModel. Domain: a model that check_model has passed; the pictures of its images, as
/// decode_images gives them.
struct KeptModel {
  std::shared_ptr<const Model> model;
  std::vector<std::shared_ptr<const ImageRgba8>> images{};
};

}  // namespace tia
