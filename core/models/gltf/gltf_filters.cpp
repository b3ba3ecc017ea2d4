#include "core/models/gltf/gltf_filters.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

// A number from -1 to 1 as an integer, the nearest one; of two the one farther from 0.
template <class Integer>
Integer as_integer(float number) {
  constexpr auto most = static_cast<float>(std::numeric_limits<Integer>::max());
  const float scaled = std::clamp(number, -1.0F, 1.0F) * most;
  return static_cast<Integer>(scaled + (scaled >= 0 ? 0.5F : -0.5F));
}

template <class Integer>
void filter_octahedral(std::uint8_t* element) {
  std::array<Integer, 4> numbers;
  std::memcpy(numbers.data(), element, sizeof numbers);
  const auto one = static_cast<float>(std::max<Integer>(numbers[2], 1));
  float x = static_cast<float>(numbers[0]) / one, y = static_cast<float>(numbers[1]) / one;
  const float z = 1 - std::fabs(x) - std::fabs(y), beyond = std::min(z, 0.0F);
  x += x >= 0 ? beyond : -beyond;
  y += y >= 0 ? beyond : -beyond;
  const float length = std::sqrt(x * x + y * y + z * z);
  numbers[0] = as_integer<Integer>(x / length);
  numbers[1] = as_integer<Integer>(y / length);
  numbers[2] = as_integer<Integer>(z / length);
  std::memcpy(element, numbers.data(), sizeof numbers);
}

void filter_quaternion(std::uint8_t* element) {
  std::array<std::int16_t, 4> numbers;
  std::memcpy(numbers.data(), element, sizeof numbers);
  const auto last = static_cast<unsigned>(static_cast<std::uint16_t>(numbers[3]));
  // The largest number's absolute value is at least that of the others, which are up to this.
  const float range = 0.70710678F / static_cast<float>(static_cast<std::int16_t>(last | 3U));
  const float x = static_cast<float>(numbers[0]) * range;
  const float y = static_cast<float>(numbers[1]) * range;
  const float z = static_cast<float>(numbers[2]) * range;
  const float w = std::sqrt(std::max(0.0F, 1 - x * x - y * y - z * z));
  const std::array<float, 4> turned{w, x, y, z};
  for (unsigned i = 0; i < 4; ++i) numbers[(last + i) % 4] = as_integer<std::int16_t>(turned[i]);
  std::memcpy(element, numbers.data(), sizeof numbers);
}

// As a double the product is exact; what is beyond floats becomes infinite, which is a fault later.
void filter_exponential(std::uint8_t* word) {
  const auto packed = load<std::uint32_t>(word);
  const std::int32_t mantissa = static_cast<std::int32_t>(packed << 8U) >> 8;
  const std::int32_t exponent = static_cast<std::int32_t>(packed) >> 24;
  const auto power = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
  const auto number = static_cast<float>(mantissa * power);
  std::memcpy(word, &number, sizeof number);
}

}  // namespace

bool takes_stride(MeshoptFilter filter, std::size_t stride) {
  switch (filter) {
    case MeshoptFilter::octahedral: return stride == 4 || stride == 8;
    case MeshoptFilter::quaternion: return stride == 8;
    case MeshoptFilter::exponential: return stride % 4 == 0;
    case MeshoptFilter::none: break;
  }
  return true;
}

void apply_filter(MeshoptFilter filter, std::size_t stride, std::span<std::uint8_t> bytes) {
  if (filter == MeshoptFilter::none) return;
  const bool exponential = filter == MeshoptFilter::exponential;
  const auto apply = exponential                           ? filter_exponential
                     : filter == MeshoptFilter::quaternion ? filter_quaternion
                     : stride == 4                         ? filter_octahedral<std::int8_t>
                                                           : filter_octahedral<std::int16_t>;
  for (std::size_t i = 0; i < bytes.size(); i += exponential ? 4 : stride) apply(bytes.data() + i);
}

}  // namespace tia::gltf
