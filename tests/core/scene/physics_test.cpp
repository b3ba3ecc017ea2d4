// Physics as it is read: what may be wrong with it, and its canonical text.
#include <gtest/gtest.h>

#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;

std::string with(const std::string& fields) { return R"({"physics":{)" + fields + "}}"; }
std::string body(const std::string& fields) {
  return with(R"("bodies":[{"object":"b",)" + fields + "}]");
}

TEST(Physics, FaultsAreNamed) {
  test::expect_scene_refused(with(""), {{missing, "/physics/bodies", "", ""}});
  test::expect_scene_refused(with(R"("bodies":[])"),
                             {{wrong_type, "/physics/bodies", "[]", "at least 1"}});
  test::expect_scene_refused(with(R"("bodies":[{"object":"b","mass":1}],"duration":0)"),
                             {{out_of_range, "/physics/duration", "0", "above 0"}});
  test::expect_scene_refused(with(R"("bodies":[{"object":"b","mass":1}],"solver":"bullet")"),
                             {{unknown_name, "/physics/solver", "\"bullet\"", "exact, rigid"}});
  const std::string at = "/physics/bodies/0";
  test::expect_scene_refused(with(R"("bodies":[{"mass":1}])"), {{missing, at + "/object", "", ""}});
  test::expect_scene_refused(with(R"("bodies":[{"object":"b"}])"),
                             {{missing, at, "", "mass or density"}});
  test::expect_scene_refused(body(R"("mass":1,"density":1)"),
                             {{conflict, at, "", "mass or density"}});
  test::expect_scene_refused(body(R"("mass":0)"), {{out_of_range, at + "/mass", "0", "above 0"}});
  test::expect_scene_refused(body(R"("density":-1)"),
                             {{out_of_range, at + "/density", "-1", "above 0"}});
  test::expect_scene_refused(body(R"("mass":1,"restitution":1.5)"),
                             {{out_of_range, at + "/restitution", "1.5", "from 0 to 1"}});
  test::expect_scene_refused(body(R"("mass":1,"friction":-1)"),
                             {{out_of_range, at + "/friction", "-1", "from 0"}});
  test::expect_scene_refused(body(R"("mass":1,"bounce":1)"),
                             {{unknown_name, at + "/bounce", "\"bounce\"", "restitution"}});
  test::expect_scene_refused(body(R"("mass":1,"spin":[0,1,0])"),
                             {{conflict, at + "/spin", "[0,1,0]", "solver rigid"}});
}

TEST(Physics, FaultsOfPairsAreNamed) {
  const auto pair = [](const std::string& objects) {
    return with(R"("bodies":[{"object":"b","mass":1}],"pairs":[{"objects":)" + objects + "}]");
  };
  const std::string at = "/physics/pairs/0/objects";
  test::expect_scene_refused(pair(R"(["b"])"), {{wrong_type, at, R"(["b"])", "at least 2"}});
  test::expect_scene_refused(pair(R"(["b","c","d"])"),
                             {{out_of_range, at, R"(["b","c","d"])", "two objects"}});
  test::expect_scene_refused(pair(R"(["b","b"])"), {{conflict, at + "/1", "\"b\"", "another"}});
}

TEST(Physics, CanonicalTextLeavesDefaultsOut) {
  const std::string short_text = with(R"("bodies":[{"mass":2,"object":"b"}])");
  EXPECT_EQ(canonical_text(read_scene(short_text)), short_text);
  const std::string long_text =
      with(R"("bodies":[{"friction":0.5,"mass":2,"object":"b","restitution":1,"spin":[0,0,0],)"
           R"("velocity":[0,0,0]}],"duration":5,"fixed":[],"gravity":[0,-9.81,0],"pairs":[],)"
           R"("solver":"exact")");
  EXPECT_EQ(canonical_text(read_scene(long_text)), short_text);
  const std::string all = with(
      R"("bodies":[{"density":7.8,"friction":0.25,"object":"b","restitution":0.5,"spin":[0,1,0],)"
      R"("velocity":[1,2,3]}],"duration":2,"fixed":[{"friction":1,"object":"f",)"
      R"("restitution":0.5}],"gravity":[0,0,0],"pairs":[{"friction":0.125,"objects":["b","f"],)"
      R"("restitution":0}],"solver":"rigid")");
  EXPECT_EQ(canonical_text(read_scene(all)), all);
}

}  // namespace
}  // namespace tia
