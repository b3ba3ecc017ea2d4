// The mip pyramids of a model's images: made when they are first asked for, and once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "core/materials/mip_pyramid.h"

namespace tia {

/// ModelPyramids: of one kept model. Any thread may ask; while one is made the others wait.
class ModelPyramids {
 public:
  using Image = std::shared_ptr<const ImageRgba8>;
  using Pyramid = std::shared_ptr<const MipPyramid>;

  /// Domain: one of the model's images, of 1 pixel at least.
  Pyramid of(const Image& image, Encoding encoding, bool halves);

 private:
  std::mutex mutex_;
  std::map<std::tuple<const ImageRgba8*, Encoding, bool>, Pyramid> known_;
};

}  // namespace tia
