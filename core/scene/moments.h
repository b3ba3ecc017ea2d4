// The part of a scene that moves, of many objects those alone that tracks move: what it takes to
// find a moment does not grow with the objects that stand still.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// MovingScene: the scene with fewer objects, and tracks that find them there.
struct MovingScene {
  Scene scene;
  std::vector<std::size_t> moved;  ///< which objects of the whole scene its own are, ascending
};

/// Domain: a scene with an animation. Returns: none where what is wrong with a moment may depend on
/// other objects, too, or which objects there are, or what all wear: where tracks move materials,
/// the ambient light, copies, models, what is not numbers, or the key light, or make an object come
/// and go.
std::optional<MovingScene> moving_scene(const Scene& scene);

/// Moments: a scene at one time after the other. The list of all objects is handed on from moment
/// to moment, and copied only where the one before is still in use.
class Moments {
 public:
  /// Domain: a scene with an animation, which outlives this.
  explicit Moments(const Scene& scene);

  /// Which objects differ from moment to moment, ascending, where they are few among many; else
  /// none, and at() is of no use.
  const std::vector<std::size_t>& moved() const { return moved_; }
  bool are_few() const { return !moved_.empty(); }
  /// at_time(scene, seconds, {}, at, stop). Domain: are_few(). Errors: as at_time.
  /// Cost: of a list that is handed on, O(moved objects).
  Scene at(double seconds, const Place& at, const std::stop_token& stop);

 private:
  const Scene& scene_;
  Scene part_;
  std::vector<std::size_t> moved_;
  SharedList<Object> all_;  // of the moment before
};

}  // namespace tia
