#include "core/scene/animation_check.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/scene/at_time.h"
#include "core/scene/moments.h"
#include "core/scene/read_scene.h"

namespace tia {
namespace {

// Some 0.3 s, at what writing and reading a scene takes.
constexpr std::size_t most_bytes = 8 << 20, fewest_moments = 8;

// Ascending, each once.
std::vector<double> moments_of(const Animation& animation) {
  std::set<double> times{0};
  const auto add = [&](double time) {
    if (0 <= time && time <= animation.duration) times.insert(time);
  };
  for (int frame = 0; frame < animation.frames(); ++frame) add(frame / animation.fps);
  for (const Track& track : animation.tracks) {
    if (track.keys)
      for (const AnimationKey& key : *track.keys) add(key.time);
    if (track.visible)
      for (const auto& [from, to] : *track.visible) add(from), add(to);
  }
  return {times.begin(), times.end()};
}

// At most so many, evenly, the first among them.
std::vector<double> thinned(const std::vector<double>& times, std::size_t most) {
  if (times.size() <= most) return times;
  std::vector<double> fewer;
  for (std::size_t i = 0; i < most; ++i) fewer.push_back(times[i * times.size() / most]);
  return fewer;
}

std::vector<Fault> faults_at(double seconds, const Scene& scene, const Middles& middles,
                             const std::stop_token& stop) {
  try {
    at_time(scene, seconds, middles, {}, stop);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

}  // namespace

void check_animation(const Scene& scene, const std::stop_token& stop) {
  if (!scene.animation) return;
  const auto part = moving_scene(scene);  // whose tracks have the same numbers
  const Scene& moving = part ? part->scene : scene;
  const Middles middles = moves_key_light(*scene.animation) ? middles_of(scene, stop) : Middles{};
  const std::size_t most = std::max(most_bytes / canonical_text(moving).size(), fewest_moments);
  Faults all(stop);
  const auto is_known = [&](const Fault& fault) { return all.at(fault.pointer); };
  for (const double seconds : thinned(moments_of(*scene.animation), most)) {
    if (all.full()) break;
    std::vector<Fault> found = faults_at(seconds, moving, middles, stop);
    if (std::ranges::all_of(found, is_known)) continue;
    if (part) found = faults_at(seconds, scene, middles, stop);
    std::erase_if(found, is_known);
    for (Fault& fault : found) all.add(std::move(fault));
  }
  all.raise();
}

}  // namespace tia
