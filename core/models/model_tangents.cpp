#include "core/models/model_tangents.h"

namespace tia {
namespace {

bool have_same_rows(const TextureUse& a, const TextureUse& b) {
  return a.uv_set == b.uv_set && a.offset == b.offset && a.scale == b.scale &&
         a.rotation == b.rotation;
}

}  // namespace

ModelTangents::Tangents ModelTangents::of(const ModelPart& part, const TextureUse& along,
                                          const std::function<TangentLists()>& make) {
  const std::lock_guard lock(mutex_);
  Known& known = known_[&part];
  if (!known.tangents || !have_same_rows(known.along, along))
    known = {along, std::make_shared<const TangentLists>(make())};
  return known.tangents;
}

}  // namespace tia
