// An object of a scene with where it stands.
#pragma once

#include "core/scene/animation_target.h"
#include "core/scene/scene.h"

namespace tia {

/// PlacedObject: an object of the scene and where it stands.
struct PlacedObject {
  const Object* object = nullptr;
  TargetPath path;    ///< in the scene: objects, 2, children, 0
  Affine parent{};    ///< from the space of its parent to the scene's
  bool free = true;   ///< its parents move, turn and mirror it at most
  bool alone = true;  ///< none of its parents repeats it

  Affine place() const { return parent * object->transform.affine(); }
};

}  // namespace tia
