#include "core/models/model_pyramids.h"

namespace tia {

ModelPyramids::Pyramid ModelPyramids::of(const Image& image, Encoding encoding, bool halves) {
  const std::lock_guard lock(mutex_);
  Pyramid& known = known_[{image.get(), encoding, halves}];
  if (!known) known = std::make_shared<const MipPyramid>(image, encoding, halves);
  return known;
}

}  // namespace tia
