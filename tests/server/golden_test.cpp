// The pictures that the pages show are what this version renders. Pixels are compared, not files:
// another version of the encoder's library may pack the same pixels otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "server/stores/digest.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string golden(const std::string& name) {
  return file_bytes(std::string(TIA_SOURCE_DIR) + "/tests/golden/" + name);
}

TEST(GoldenFiles, AreReadAlikeByTwoReaders) {
  int files = 0;
  for (const auto& each :
       std::filesystem::recursive_directory_iterator(std::string(TIA_SOURCE_DIR) + "/tests/golden"))
    if (each.path().extension() == ".png") {
      SCOPED_TRACE(each.path());
      EXPECT_NO_THROW(decode_png(file_bytes(each.path())));
      ++files;
    }
  EXPECT_GT(files, 30);
}

struct Golden {
  std::string name, target;
};
class GoldenPicture : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, IsWhatThisVersionRenders) {
  const auto& [name, target] = GetParam();
  Host host;
  const Response now = host.get(target);
  ASSERT_EQ(now.status, 200);
  const auto published = decode_png(golden(name + ".png"));
  EXPECT_TRUE(decode_png(now.body) == published);
}

INSTANTIATE_TEST_SUITE_P(Pages, GoldenPicture,
                         testing::Values(Golden{"none", "/render"}, Golden{"a", "/render?key=a"},
                                         Golden{"d", "/render?key=d"}, Golden{"s", "/render?key=s"},
                                         Golden{"w", "/render?key=w"},
                                         Golden{"shapes", "/render?scene=shapes&samples=16"}),
                         [](const auto& one) { return one.param.name; });

// ---- the gallery --------------------------------------------------------------------------------

// gallery.sha256, in sha256sum's format: the PFM of each scene at 160x120, as the scene asks.
std::map<std::string, std::string> stated_hashes() {
  std::map<std::string, std::string> hashes;
  std::istringstream lines(golden("gallery.sha256"));
  for (std::string hash, file; lines >> hash >> file;)
    hashes[file.substr(0, file.find('.'))] = hash;
  return hashes;
}

TEST(GoldenGallery, EverySceneHasAStatedHash) {
  const Gallery gallery;
  const auto hashes = stated_hashes();
  EXPECT_EQ(hashes.size(), gallery.scenes().size());
  for (const auto& [name, scene] : gallery.scenes()) EXPECT_TRUE(hashes.contains(name)) << name;
}

class GoldenScene : public testing::TestWithParam<std::pair<const std::string, std::string>> {};

// Of the page's picture a window of the middle is compared: all of it would take long.
TEST_P(GoldenScene, IsDrawnAtItsStatedHashAndAsThePageShowsIt) {
  constexpr int x0 = 280, y0 = 200, x1 = 380, y1 = 280;
  const auto& [name, hash] = GetParam();
  Host host;
  EXPECT_EQ(sha256_hex(host.get("/render?width=160&height=120&format=pfm&scene=" + name).body),
            hash);
  if (name == "thesis" || name == "shapes") return;  // compared above
  if (sanitized()) return;                           // one picture shows it the same ways
  const Response now = host.get("/render?crop=280,200,380,280&scene=" + name);
  const auto published = decode_png(golden("gallery/" + name + ".png"));
  ASSERT_EQ(published.width, 640);
  EXPECT_TRUE(decode_png(now.body) == published.window(x0, y0, x1, y1));
}

INSTANTIATE_TEST_SUITE_P(Gallery, GoldenScene, testing::ValuesIn(stated_hashes()),
                         [](const auto& one) {
                           std::string name = one.param.first;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace tia::test
