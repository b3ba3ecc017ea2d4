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
}

}  // namespace
}  // namespace tia
