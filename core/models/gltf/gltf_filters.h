// The filters of EXT_meshopt_compression: what unpacked integers stand for. The same bits on every
// machine.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace tia::gltf {

enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };
inline constexpr std::array<std::string_view, 4> meshopt_filter_names{"NONE", "OCTAHEDRAL",
                                                                      "QUATERNION", "EXPONENTIAL"};

/// Whether a filter takes elements of so many bytes.
bool takes_stride(MeshoptFilter filter, std::size_t stride);

/// Applies a filter in place. Domain: whole elements of a stride that it takes.
/// Octahedral: x, y, one, w as bytes or shorts to a unit vector's x, y, z and w; a `one` below 1 is
/// taken as 1. Quaternion: shorts, the largest of four numbers left out. Exponential: words of
/// 24 bits times a power of 2 of 8 bits to floats.
/// Source: Khronos, EXT_meshopt_compression (2020), appendix B.
void apply_filter(MeshoptFilter filter, std::size_t stride, std::span<std::uint8_t> bytes);

}  // namespace tia::gltf
