// Contract: filters are the specification's formulas. What they are given is packed by
// libmeshoptimizer, whose own filters round as the processor does.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "core/models/gltf/gltf_filters.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

using gltf::MeshoptFilter;

template <class T>
std::vector<T> filtered(MeshoptFilter filter, std::size_t stride, std::vector<T> numbers) {
  gltf::apply_filter(filter, stride,
                     {reinterpret_cast<std::uint8_t*>(numbers.data()), numbers.size() * sizeof(T)});
  return numbers;
}

// A square of 2^(b-1) - 1 steps from its middle to its side: the encoder rounds two coordinates by
// half a step each, the filter's integers by half of theirs.
TEST(MeshoptFilters, UnitVectorsComeBackWithinTheirSteps) {
  Random random(3);
  std::vector<float> vectors;
  for (int i = 0; i < 500; ++i) {
    const Vec3d n = random.direction();
    for (const double each : {n.x, n.y, n.z, 1.0}) vectors.push_back(static_cast<float>(each));
  }
  std::vector<std::int8_t> bytes(vectors.size());
  std::vector<std::int16_t> shorts(vectors.size());
  meshopt_encodeFilterOct(bytes.data(), 500, 4, 8, vectors.data());
  meshopt_encodeFilterOct(shorts.data(), 500, 8, 12, vectors.data());
  bytes = filtered(MeshoptFilter::octahedral, 4, bytes);
  shorts = filtered(MeshoptFilter::octahedral, 8, shorts);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    ASSERT_NEAR(bytes[i] / 127.0, double{vectors[i]}, std::sqrt(3) / 127 + 0.5 / 127) << i;
    ASSERT_NEAR(shorts[i] / 32767.0, double{vectors[i]}, std::sqrt(3) / 2047 + 1e-4) << i;
  }
  const std::vector<std::int8_t> zeros{0, 0, 0, 5};  // no `one`: the middle
  EXPECT_EQ(filtered(MeshoptFilter::octahedral, 4, zeros),
            (std::vector<std::int8_t>{0, 0, 127, 5}));
}

// Three numbers are off by e = sqrt(1/2) / 2047 / 2 at most, the fourth, w >= 1/2, by
// (x + y + z) e / w <= 1.5 e / 0.5 = 5.2e-4, and all by half a step of 1 / 32767.
TEST(MeshoptFilters, QuaternionsComeBackWithinTheirSteps) {
  Random random(4);
  std::vector<float> turns;
  for (int i = 0; i < 500; ++i) {
    const Vec3d n = random.direction();
    const double half = random.in(0, std::numbers::pi);
    for (const double each :
         {n.x * std::sin(half), n.y * std::sin(half), n.z * std::sin(half), std::cos(half)})
      turns.push_back(static_cast<float>(each));
  }
  std::vector<std::int16_t> packed(turns.size());
  meshopt_encodeFilterQuat(packed.data(), 500, 8, 12, turns.data());
  packed = filtered(MeshoptFilter::quaternion, 8, packed);
  for (std::size_t i = 0; i < turns.size(); i += 4) {
    double cosine = 0;  // q and -q turn alike
    for (std::size_t k = i; k < i + 4; ++k) cosine += packed[k] * double{turns[k]};
    for (std::size_t k = i; k < i + 4; ++k)
      ASSERT_NEAR(packed[k] / 32767.0, std::copysign(1, cosine) * turns[k], 5.4e-4) << k;
  }
}

TEST(MeshoptFilters, ExponentialsAreTheirProducts) {
  Random random(5);
  std::vector<std::uint32_t> packed;
  std::vector<float> expected;
  for (int i = 0; i < 1000; ++i) {
    const int exponent = random.whole(-128, 104),
              mantissa = random.whole(-(1 << 23), (1 << 23) - 1);
    packed.push_back(static_cast<std::uint32_t>(exponent) << 24U |
                     (static_cast<std::uint32_t>(mantissa) & 0xFF'FFFFU));
    expected.push_back(static_cast<float>(std::ldexp(mantissa, exponent)));
  }
  const auto words = filtered(MeshoptFilter::exponential, 8, packed);
  for (std::size_t i = 0; i < words.size(); ++i)
    ASSERT_EQ(words[i], std::bit_cast<std::uint32_t>(expected[i])) << i;
}

}  // namespace
}  // namespace tia::test
