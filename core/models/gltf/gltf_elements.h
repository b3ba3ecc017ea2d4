// The numbers of accessors' elements.
#pragma once

#include <limits>

#include "core/models/gltf/gltf_accessors.h"

namespace tia::gltf {

/// What check_model() holds the numbers of vertices, places and animations to.
inline constexpr double farthest = 1e9;

/// The numbers of the first `count` elements, one after the other, a matrix column by column;
/// normalised integers as numbers from -1 or 0 to 1. Domain: an accessor that is good, with so many
/// elements; Number: float, double, or std::uint32_t of unsigned integers. Of absolute values up
/// to `most`.
/// Errors: nothing and a fault: of a number that is not finite or beyond `most` at
/// "/accessors/3"; of sparse indices that are too big or do not ascend at "/accessors/3/sparse".
/// Cost: linear in `count`.
/// Source: Khronos, glTF 2.0 (2021), sections 3.6.2 and 3.11 (f = max(c / 127, -1)).
template <class Number>
std::optional<std::vector<Number>> read_elements(const GltfSource& source, const Accessor& accessor,
                                                 std::uint64_t count,
                                                 double most = std::numeric_limits<double>::max());

extern template std::optional<std::vector<float>> read_elements(const GltfSource&, const Accessor&,
                                                                std::uint64_t, double);
extern template std::optional<std::vector<double>> read_elements(const GltfSource&, const Accessor&,
                                                                 std::uint64_t, double);
extern template std::optional<std::vector<std::uint32_t>> read_elements(const GltfSource&,
                                                                        const Accessor&,
                                                                        std::uint64_t, double);

}  // namespace tia::gltf
