// Scattering of packets, against that of every lane by itself, to the bit.
#include <gtest/gtest.h>

#include "core/materials/bsdf.h"
#include "core/math/lanes.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using namespace test;

constexpr auto all_lanes = static_cast<std::size_t>(lanes<Wide>);

/// Meetings: as many as a packet has lanes, each of a material at random with directions of its
/// own.
struct Meetings {
  std::array<BsdfParameters<double>, all_lanes> materials;
  std::array<std::array<float, all_lanes>, 21> numbers{};
  bool framed;  ///< whether coats and grain are told in some lanes

  explicit Meetings(Random& random) : framed(random.chance(0.5)) {
    for (std::size_t at = 0; at < all_lanes; ++at) {
      Principled principled = random_principled(random);
      principled.anisotropy_rotation = random.in(0, 6);
      if (random.chance(0.5)) principled.anisotropy = 0;
      if (random.chance(0.3)) principled.roughness = 0;
      materials[at] = shading_of(principled, {}).bsdf;
      const Vec3d n = random.direction();
      put(0, at, normalize(n + random.direction() * 0.9)), put(3, at, n);
      put(6, at, random.direction());
      numbers[9][at] = static_cast<float>(random.in(0.6, 1.7));
      for (std::size_t k = 10; k < 13; ++k) numbers[k][at] = static_cast<float>(random.unit());
      put(13, at, normalize(n + random.direction() * 0.7)), put(16, at, random.direction());
      for (const std::size_t k : {19U, 20U}) numbers[k][at] = random.chance(0.5) ? 1 : 0;
    }
  }
  void put(std::size_t first, std::size_t at, const Vec3d& v) {
    const Vec3f rounded(v);
    numbers[first][at] = rounded.x, numbers[first + 1][at] = rounded.y;
    numbers[first + 2][at] = rounded.z;
  }
};

/// Scattered: what a bsdf says of the meetings from the lane `first` on.
template <class Real>
struct Scattered {
  BsdfValue<Real> value;
  BsdfSample<Real> sample;

  Scattered(const Meetings& of, std::size_t first) {
    const auto real = [&](std::size_t k) { return load<Real>(&of.numbers[k][first]); };
    const auto vector = [&](std::size_t k) {
      return Vec3<Real>{real(k), real(k + 1), real(k + 2)};
    };
    BsdfParameters<Real> parameters;
    for (int i = 0; i < lanes<Real>; ++i)
      parameters.take(of.materials[first + static_cast<std::size_t>(i)],
                      iota<Real>() == Real(static_cast<float>(i)), i == 0);
    const LayerFrames<Real> frames{vector(13), vector(16), real(19) > Real(0), real(20) > Real(0)};
    const Bsdf<Real> bsdf(parameters, vector(0), vector(3), vector(3), real(9), Real(0) == Real(0),
                          of.framed ? &frames : nullptr);
    value = bsdf.value(vector(6));
    sample = bsdf.sample(real(10), real(11), real(12));
  }
  std::vector<float> numbers_of(int i) const {
    const auto has = [&](Mask<Real> mask) { return (bits(mask) >> i & 1U) != 0; };
    const auto of = [&](const Vec3<Real>& v) {
      return std::array{lane(v.x, i), lane(v.y, i), lane(v.z, i)};
    };
    std::vector<float> all{lane(value.pdf, i), has(sample.here) ? 1.0F : 0.0F};
    for (const float each : of(value.f_cos)) all.push_back(each);
    if (!has(sample.here)) return all;
    all.push_back(lane(sample.pdf, i));
    all.push_back(has(sample.transmitted) ? 1.0F : 0.0F);
    for (const auto& v : {sample.wi, sample.weight})
      for (const float each : of(v)) all.push_back(each);
    return all;
  }
};

TEST(BsdfLanes, DoNotSeeEachOther) {
  Random random(845);
  for (int i = 0; i < rounds(500, 10); ++i) {
    const Meetings meetings(random);
    const Scattered<Wide> together(meetings, 0);
    for (std::size_t at = 0; at < all_lanes; ++at)
      ASSERT_EQ(together.numbers_of(static_cast<int>(at)),
                Scattered<float>(meetings, at).numbers_of(0))
          << i;
  }
}

}  // namespace
}  // namespace tia
