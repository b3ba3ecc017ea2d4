// Members of glTF objects that have less to choose from than a range: numbers above 0, words, and
// numbers that end earlier here than in the specification.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/models/gltf/gltf_object.h"

namespace tia::gltf {

/// A number above 0, at most `most`; nothing, and a fault if it is there and another.
std::optional<double> positive(const GltfObject& object, std::string_view name,
                               double most = Range().max);

/// Which of the words a member is; nothing, and a fault if it is there and none of them.
std::optional<std::size_t> word(const GltfObject& object, std::string_view name,
                                std::span<const std::string_view> words);

/// A number from `range.min` on: above `range.max` it is that, with a warning.
double capped(const GltfObject& object, std::string_view name, double standard, Range range,
              Model& model);

}  // namespace tia::gltf
