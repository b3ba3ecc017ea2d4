// A model as it is kept to be used: what was read of its files.
#pragma once

#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/models/model.h"
#include "core/models/model_pyramids.h"
#include "core/models/model_tangents.h"

namespace tia {

/// KeptModel: a model that fits together, with the pictures of its images.
struct KeptModel {
  std::shared_ptr<const Model> model;
  /// One an image of the model's, as decode_images() gives them; null where it has no file.
  std::vector<std::shared_ptr<const ImageRgba8>> images;
  std::shared_ptr<ModelPyramids> pyramids = std::make_shared<ModelPyramids>();
  std::shared_ptr<ModelTangents> tangents = std::make_shared<ModelTangents>();
};

/// SharedModel: one that is in use outlives its place in a store.
using SharedModel = std::shared_ptr<const KeptModel>;

}  // namespace tia
