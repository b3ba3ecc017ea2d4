// What a light that is moved turns to where the camera names no point: the middles of the objects,
// whose making may be dear, and ends when that is asked for.
#include <gtest/gtest.h>

#include "core/parallel/stopped.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"

namespace tia {
namespace {

Scene scene_of(const std::string& objects, const std::string& more = "") {
  return read_scene(R"({"objects":[)" + objects +
                    R"(],"lights":[{"type":"spot","position":[0,9,0],)"
                    R"("point_at":[0,0,0]}])" +
                    more + "}");
}
const std::string balls =
    R"({"type":"sphere","center":[0,0,-4],"radius":1},{"type":"sphere","center":[2,0,-8],"radius":1})";

TEST(Middles, AreThoseOfObjectsWithFiniteBoxes) {
  const Scene scene = scene_of(balls + R"(,{"type":"plane","point":[0,-1,0],"normal":[0,1,0]})");
  EXPECT_EQ(middles_of(scene), (Middles{{0, 0, -4}, {2, 0, -8}}));
}

TEST(Middles, AreNotNeededWhereTheCameraNamesAPoint) {
  const Scene scene = scene_of(balls, R"(,"camera":{"look_at":[0,0,-5]})");
  EXPECT_TRUE(middles_of(scene).empty());
}

TEST(Middles, ThatAreKnownMoveTheLightAsThoseThatAreNot) {
  const Scene scene = scene_of(balls);
  EXPECT_EQ(with_light(scene, {1, 2, 3}), with_light(scene, {1, 2, 3}, middles_of(scene)));
  for (const std::string_view key : keys_of(scene))
    EXPECT_EQ(press(scene, key), press(scene, key, middles_of(scene)));
}

TEST(Middles, OfObjectsOrOfAGroupEndWhenThatIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  for (const std::string& objects : {balls, R"({"type":"group","children":[)" + balls + "]}"})
    EXPECT_THROW(middles_of(scene_of(objects), source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
