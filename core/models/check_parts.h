// What check_model asks of one thing by itself.
#pragma once

#include <cmath>
#include <string>

#include "core/input/errors.h"
#include "core/models/model.h"

namespace tia {

/// A number of a list that is not finite is a fault at its place.
template <class List>
void check_finite(const List& list, const Place& at, Faults& faults) {
  for (std::size_t i = 0; i < list.size() && !faults.full(); ++i)
    if (!std::isfinite(list[i]))
      faults.add({FaultKind::out_of_range, at.at(i).pointer(), std::nullopt, "a finite number"});
}

void check_material(const ModelMaterial& material, std::size_t textures, const Place& at,
                    Faults& faults);
void check_camera(const ModelCamera& camera, const Place& at, Faults& faults);
void check_light(const ModelLight& light, const Place& at, Faults& faults);
/// Its lists; not what they name.
void check_part(const ModelPart& part, const Place& at, Faults& faults);
/// Where it stands, and its instances.
void check_placement(const ModelNode& node, const Place& at, Faults& faults);
/// Its times and values. `targets`: how many morph targets its node has.
void check_channel(const AnimationChannel& channel, std::size_t targets, const Place& at,
                   Faults& faults);

}  // namespace tia
