// What a key press or a light position does to a scene.
#pragma once

#include <stop_token>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// The keys that a scene answers to: its own, or a, d, s, w.
std::vector<std::string_view> keys_of(const Scene& scene);

/// Middles: of the boxes around a scene's objects, of those that have finite ones: what a camera
/// looks at that names no point.
using Middles = std::vector<Vec3d>;
/// None where the camera names a point. Cost: as bounds_of() of each object. Errors: Stopped.
Middles middles_of(const Scene& scene, const std::stop_token& stop = {});

/// The scene after a key. Errors: InputError at `pointer` for a key that the scene does not know,
/// or for a patch that does not leave a scene. Stopped.
Scene press(const Scene& scene, std::string_view key, const Middles& middles,
            std::string_view pointer = "/key", const std::stop_token& stop = {});
inline Scene press(const Scene& scene, std::string_view key, std::string_view pointer = "/key") {
  return press(scene, key, middles_of(scene), pointer);
}

/// Tries every key that the scene binds. A patch is tried on those parts of the scene that it
/// merges with or that refer to what it changes: only they can go wrong.
/// Errors: InputError at /keys/NAME of each whose patch does not leave a scene or that puts the
/// light where it cannot shine from; limit at /keys where there are more than 100 patches, or where
/// they merge with more than 16 MiB of text, or read more than 134 217 728 cells and pixels, a
/// JPEG's with each of its scans. Stopped.
void check_keys(const Scene& scene, const std::stop_token& stop = {});

/// Whether that key moves the key light and changes nothing else. Domain: a key that it answers to.
bool moves_light_only(const Scene& scene, std::string_view key);

/// The scene with its key light at a position: the key light, else the first light, else a new
/// point light. Errors: InputError at `pointer` where that light cannot stand there.
Scene with_light(Scene scene, const Vec3d& position, const Middles& middles,
                 std::string_view pointer = "/light");
inline Scene with_light(const Scene& scene, const Vec3d& position,
                        std::string_view pointer = "/light") {
  return with_light(scene, position, middles_of(scene), pointer);
}

}  // namespace tia
