#include "core/scene/limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/faults.h"

namespace tia {
namespace {

TEST(Limits, PictureOfExactlyTheMostPixelsPasses) {
  EXPECT_NO_THROW(check_size(4096, 4096, {}));  // 2^24 = 16 777 216
  EXPECT_NO_THROW(check_size(16'777'216, 1, {}));
  EXPECT_NO_THROW(check_size(1, 16'777'216, {}));
  EXPECT_NO_THROW(check_size(10, 10, {.max_pixels = 100}));
}

TEST(Limits, OnePixelMoreIsRefusedNamingTheLimitAndItsOption) {
  using enum FaultKind;
  const auto refusal = [](int width, int height, const Limits& limits) {
    return test::faults_of([=] { check_size(width, height, limits); });
  };
  test::expect_faults(refusal(16'777'217, 1, {}),
                      {{limit, "/width", "\"16777217 x 1\"", "at most 16777216 pixels"}});
  test::expect_faults(refusal(1, 16'777'217, {}),
                      {{limit, "/width", "\"1 x 16777217\"", "option TIA_MAX_PIXELS"}});
  test::expect_faults(refusal(4097, 4096, {}), {{limit, "/width", "\"4097 x 4096\"", "16777216"}});
  test::expect_faults(refusal(101, 1, {.max_pixels = 100}),
                      {{limit, "/width", "\"101 x 1\"", "at most 100 pixels"}});
}

TEST(Limits, LargestSizesDoNotOverflow) {
  constexpr int most = std::numeric_limits<int>::max();
  EXPECT_THROW(check_size(most, most, {}), InputError);
  EXPECT_THROW(check_size(65536, 65536, {}), InputError);  // 2^32
  EXPECT_THROW(check_rays(std::int64_t{1} << 62, 65536, {}), InputError);
}

TEST(Limits, RaysOfAWindowArePredictedAsPixelsTimesSamples) {
  using enum FaultKind;
  EXPECT_NO_THROW(check_rays(31'250, 64'000, {}));  // 2 000 000 000
  EXPECT_NO_THROW(check_rays(0, 65536, {}));
  test::expect_faults(test::faults_of([] { check_rays(31'251, 64'000, {}); }),
                      {{limit, "/samples", "\"31251 pixels of 64000 samples\"",
                        "at most 2000000000 rays (option TIA_MAX_RAYS)"}});
  EXPECT_NO_THROW(check_rays(10, 10, {.max_rays = 100}));
  EXPECT_THROW(check_rays(10, 11, {.max_rays = 100}), InputError);
}

}  // namespace
}  // namespace tia
