// The pictures that the pages show are what this version renders. Pixels are compared, not files:
// another version of the encoder's library may pack the same pixels otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "server/stores/digest.h"
#include "server/stores/gallery_models.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string golden(const std::string& name) {
  return file_bytes(std::string(TIA_SOURCE_DIR) + "/tests/golden/" + name);
}

TEST(GoldenFiles, AreReadAlikeByTwoReaders) {
  if (sanitized()) GTEST_SKIP() << "calls nothing but the tests' own readers";
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
  std::string name, query;
};
class GoldenPicture : public testing::TestWithParam<Golden> {};

// A window of the pages' pictures, to be drawn where all of one would take long. Where sanitizers
// watch all takes long, and what they look for is in any ray.
struct Part {
  int x0 = 280, y0 = 200, x1 = 380, y1 = 280;
  static Part now() { return sanitized() ? Part{312, 229, 328, 241} : Part{}; }
  std::string query() const {
    return "crop=" + std::to_string(x0) + ',' + std::to_string(y0) + ',' + std::to_string(x1) +
           ',' + std::to_string(y1) + '&';
  }
  Pixels<unsigned char> of(const Pixels<unsigned char>& picture) const {
    return picture.window(x0, y0, x1, y1);
  }
};

TEST_P(GoldenPicture, IsWhatThisVersionRenders) {
  const auto& [name, query] = GetParam();
  Host host;
  const Part part = Part::now();
  const Response now = host.get("/render?" + (sanitized() ? part.query() : "") + query);
  ASSERT_EQ(now.status, 200);
  const auto published = decode_png(golden(name + ".png"));
  EXPECT_TRUE(decode_png(now.body) == (sanitized() ? part.of(published) : published));
}

INSTANTIATE_TEST_SUITE_P(Pages, GoldenPicture,
                         testing::Values(Golden{"none", ""}, Golden{"a", "key=a"},
                                         Golden{"d", "key=d"}, Golden{"s", "key=s"},
                                         Golden{"w", "key=w"},
                                         Golden{"shapes", "scene=shapes&samples=16"}),
                         [](const auto& one) { return one.param.name; });

// ---- the gallery --------------------------------------------------------------------------------

// gallery.sha256, in sha256sum's format: the PFM of each scene at 160x120, as the scene asks, and
// NAME.4.pfm with 4 samples: where rays are chance, few say as much as many; NAME.t1.pfm, and the
// page's picture, at one second.
struct Stated {
  std::string name, options, hash;
  std::string moment = {};
};
std::vector<Stated> stated_hashes(const std::string& list = "gallery.sha256") {
  std::vector<Stated> all;
  std::istringstream lines(golden(list));
  for (std::string hash, file; lines >> hash >> file;) {
    const std::size_t dot = file.find('.'), last = file.rfind('.');
    const std::string how = dot < last ? file.substr(dot + 1, last - dot - 1) : "";
    const std::string moment = how.starts_with('t') ? "&time=" + how.substr(1) : "";
    const std::string samples = how.empty() || !moment.empty() ? "" : "&samples=" + how;
    all.push_back({file.substr(0, dot), samples + moment, hash, moment});
  }
  return all;
}

TEST(GoldenGallery, EverySceneHasAStatedHash) {
  const Gallery gallery;
  std::set<std::string> stated;
  for (const Stated& one : stated_hashes()) stated.insert(one.name);
  EXPECT_EQ(stated.size(), gallery.names().size());
  for (const std::string_view name : gallery.names())
    EXPECT_TRUE(stated.contains(std::string(name))) << name;
}

class GoldenScene : public testing::TestWithParam<Stated> {};

// Pictures of several views side by side are shown at a smaller size of each.
std::string page_size_of(const std::string& scene) {
  return scene == "quilt" ? "width=160&height=120&" : scene == "wall" ? "width=64&height=48&" : "";
}

// Of the page's picture a window of the middle is compared: all of it would take long. So would the
// other where sanitizers watch: the scenes of it are drawn at their hashes by all other builds.
TEST_P(GoldenScene, IsDrawnAtItsStatedHashAndAsThePageShowsIt) {
  const auto& [name, options, hash, moment] = GetParam();
  const std::string scene = "scene=" + name;
  if (!sanitized()) {
    const std::string query = "width=160&height=120&format=pfm&" + scene + options;
    EXPECT_EQ(sha256_hex(host().get("/render?" + query).body), hash);
  }
  if (name == "thesis" || name == "shapes") return;  // compared above
  const Part part = Part::now();
  const Response now = host().get("/render?" + part.query() + page_size_of(name) + scene + moment);
  const auto published = decode_png(golden("gallery/" + name + ".png"));
  ASSERT_EQ(published.width, 640);
  EXPECT_TRUE(decode_png(now.body) == part.of(published));
}

INSTANTIATE_TEST_SUITE_P(Gallery, GoldenScene, testing::ValuesIn(stated_hashes()),
                         [](const auto& one) {
                           std::string name = one.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// ---- the gallery's models -----------------------------------------------------------------------

// stills.sha256: the PFM of each model's still, as the options below ask.
TEST(GoldenStills, EveryModelIsDrawnAtItsStatedHash) {
  const std::vector<Stated> stated = stated_hashes("stills.sha256");
  EXPECT_EQ(stated.size(), server::gallery_models().size());
  const std::string size = sanitized() ? "&width=1&height=1" : "&width=96&height=72";
  for (const auto& [name, options, hash, moment] : stated) {
    SCOPED_TRACE(name);
    const Response still =
        host().get("/still?format=pfm&background=1,1,1&samples=2" + size + "&model=" + name);
    EXPECT_EQ(still.status, 200);
    if (!sanitized()) EXPECT_EQ(sha256_hex(still.body), hash);
  }
}

}  // namespace
}  // namespace tia::test
