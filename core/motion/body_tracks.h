// What a scene's own tracks do to objects that take part in its physics.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/placed_object.h"

namespace tia {

/// BodyTracks: the tracks that lead to objects. Domain: a scene that outlives it.
class BodyTracks {
 public:
  explicit BodyTracks(const Scene& scene);
  /// A fault at `where` if a track moves the object or one around it, or changes its shape.
  void refuse_moved(const PlacedObject& object, const Place& where, const std::string& called,
                    Faults& faults) const;
  /// When it is there with all that are around it: [from, to); all of time where no track says so;
  /// none where that is no single interval, or before the time 0.
  std::optional<std::array<double, 2>> presence(const PlacedObject& object) const;
  bool comes_or_goes(const PlacedObject& object) const;

 private:
  struct Led {
    const Track* track;
    TargetPath path;
  };
  std::vector<Led> led_;
};

}  // namespace tia
