// The pictures that the README shows are what this version renders. Pixels are compared, not files:
// another version of the encoder's library may pack the same pixels otherwise.
#include <gtest/gtest.h>

#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

class GoldenPicture : public testing::TestWithParam<std::string> {};

TEST_P(GoldenPicture, IsWhatThisVersionRenders) {
  const std::string& name = GetParam();
  Host host;
  const Response now = host.get(name == "none" ? "/render" : "/render?key=" + name);
  ASSERT_EQ(now.status, 200);
  const auto published =
      decode_png(file_bytes(std::string(TIA_SOURCE_DIR) + "/tests/golden/" + name + ".png"));
  EXPECT_TRUE(decode_png(now.body) == published);
}

INSTANTIATE_TEST_SUITE_P(Thesis, GoldenPicture, testing::Values("none", "a", "d", "s", "w"),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace tia::test
