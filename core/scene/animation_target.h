// Where a track's target is in a scene that is written as JSON.
#pragma once

#include <string>
#include <vector>

#include "core/input/errors.h"
#include "core/scene/animation_track.h"

namespace tia {

/// TargetPath: the steps of a JSON Pointer (RFC 6901), names of list elements as their numbers.
using TargetPath = std::vector<std::string>;

/// The steps of a pointer as it is written; none where it is no pointer or the whole scene.
TargetPath steps_of(std::string_view pointer);
std::string pointer_of(const TargetPath& path);
/// Whether `path` is `above` or inside of it.
bool is_within(const TargetPath& path, const TargetPath& above);
/// The number of a list's element; none of what is no number.
std::optional<std::size_t> number_of_step(std::string_view step);

/// The steps in this scene. Returns: none and a fault at `at` where a list has no such element or
/// several of that name, or where there is neither list nor object.
TargetPath found_target(const TargetPath& steps, const Value& scene, const std::string& at,
                        Faults& faults);

/// Puts a value there, and objects on the way where nothing is written. Domain: a found path.
void put_at(Value& scene, const TargetPath& path, Value value);
/// What is there, or null.
Value* value_in(Value& scene, const TargetPath& path);

/// What the numbers there are, by the field's name: a colour is what the schema says is one.
TrackTarget kind_of_target(const TargetPath& path);

}  // namespace tia
