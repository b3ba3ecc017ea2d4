// The pictures that the README shows are what this version renders. Pixels are compared, not files:
// another version of the encoder's library may pack the same pixels otherwise.
#include <gtest/gtest.h>

#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

struct Golden {
  std::string name, target;
};
class GoldenPicture : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, IsWhatThisVersionRenders) {
  const auto& [name, target] = GetParam();
  Host host;
  const Response now = host.get(target);
  ASSERT_EQ(now.status, 200);
  const auto published =
      decode_png(file_bytes(std::string(TIA_SOURCE_DIR) + "/tests/golden/" + name + ".png"));
  EXPECT_TRUE(decode_png(now.body) == published);
}

INSTANTIATE_TEST_SUITE_P(Readme, GoldenPicture,
                         testing::Values(Golden{"none", "/render"}, Golden{"a", "/render?key=a"},
                                         Golden{"d", "/render?key=d"}, Golden{"s", "/render?key=s"},
                                         Golden{"w", "/render?key=w"},
                                         Golden{"shapes", "/render?scene=shapes&samples=16"}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace tia::test
