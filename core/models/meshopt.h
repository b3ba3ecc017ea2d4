// meshoptimizer in: the decoders of its codecs behind bounds. They give integers; the filters that
// make floats of them are ours (gltf_filters.h), for the library's round as the processor does.
#pragma once

#include <cstdint>
#include <span>

#include "core/models/model_files.h"

namespace tia {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };

/// Unpacks `count` elements of `stride` bytes each into `to`, which has as many.
/// Domain: a stride of 4, 8, ... 256 of attributes; of indices 2 or 4, and of triangles with a
/// count that is a multiple of 3. Returns: whether the bytes were exactly so many elements. What
/// indices they are is not looked at. Source: Khronos, EXT_meshopt_compression (2020), appendix A,
/// as meshoptimizer 0.18 reads it.
bool unpack_meshopt(MeshoptMode mode, ModelBytes packed, std::size_t count, std::size_t stride,
                    std::span<std::uint8_t> to);

}  // namespace tia
