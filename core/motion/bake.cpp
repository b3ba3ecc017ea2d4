#include "core/motion/bake.h"

namespace tia {
namespace {

SharedValue triple(const Vec3d& v) { return write_value(v); }

/// ParabolaKeys: the keys of one body's translation.
class ParabolaKeys {
 public:
  ParabolaKeys(const Affine& parent, const Vec3d& start)
      : inner_(parent.inverse()), start_(start) {}

  void add(const Knot& knot) {
    const SharedValue leaving = triple(inner_.vector(knot.velocity));
    if (!keys_.empty() && knot.time <= keys_.back().time) keys_.back().after = leaving;
    else keys_.push_back(key(knot.time, knot.center, arriving_ ? *arriving_ : leaving, leaving));
  }
  // That it flies from that knot on until then.
  void fly(const Knot& from, double until) {
    arriving_ = triple(inner_.vector(velocity_at(from, until)));
  }
  void end(const Knot& from, double until) {
    keys_.push_back(key(until, center_at(from, until), *arriving_, *arriving_));
  }
  std::vector<AnimationKey> keys() && { return std::move(keys_); }

 private:
  AnimationKey key(double time, const Vec3d& at, SharedValue in, SharedValue out) const {
    return {time, triple(inner_.vector(at - start_)), Ease::none, std::move(in), std::move(out)};
  }

  Affine inner_;
  Vec3d start_;
  std::optional<SharedValue> arriving_;
  std::vector<AnimationKey> keys_;
};

}  // namespace

void bake_parabolas(const PlacedObject& object, const std::vector<Knot>& knots, double until,
                    Simulation& into) {
  ParabolaKeys keys(object.parent, knots.front().center);
  for (std::size_t i = 0; i < knots.size() && knots[i].time < until; ++i) {
    keys.add(knots[i]);
    const bool is_last = i + 1 == knots.size() || knots[i + 1].time >= until;
    keys.fly(knots[i], is_last ? until : knots[i + 1].time);
    if (is_last) keys.end(knots[i], until);
  }
  into.steps.push_back({object.path, {Translate{}}});
  Track track;
  track.target = pointer_of(object.path) + "/transform/" +
                 std::to_string(object.object->transform.steps.size()) + "/translate";
  track.interpolation = KeyInterpolation::bezier;
  track.keys = std::move(keys).keys();
  into.tracks.push_back(std::move(track));
}

}  // namespace tia
