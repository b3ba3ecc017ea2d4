// Of a scene's objects only those that move are written and read again: what comes out is what the
// scene's own text says with the moved values in it.
#include <gmock/gmock.h>

#include <set>
#include <string>

#include "core/scene/at_time.h"
#include "core/scene/moments.h"
#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia {
namespace {

// Five kinds of objects; of their names some are alike and some missing.
std::string object_text(test::Random& random, int number, double x) {
  const std::string center = "\"center\":[" + std::to_string(x) + ",1,2]";
  const std::string name = number % 4 == 0   ? ""
                           : number % 4 == 1 ? R"("name":"twin",)"
                                             : "\"name\":\"n" + std::to_string(number) + "\",";
  const std::string ball = "{" + name + R"("type":"sphere","radius":0.5,)" + center + "}";
  if (random.whole(0, 3) > 0) return ball;
  return R"({"type":"group","material":"red","transform":[{"translate":[1,2,3]}],"children":[)" +
         ball + "]}";
}

TEST(AtTime, OfManyObjectsIsWhatTheSceneSaysWithTheMovedValuesInIt) {
  test::Random random(31);
  for (int round = 0; round < 100; ++round) {
    const int n = static_cast<int>(random.whole(1, 12));
    std::string before, after, tracks;
    for (int i = 0; i < n; ++i) {
      const bool moves = random.whole(0, 2) == 0, leaves = random.whole(0, 4) == 0;
      const double from = i, to = i + 0.25;
      test::Random same = random;
      const std::string still = object_text(random, i, from);
      const bool is_group = still.starts_with(R"({"type":"group")");
      const std::string called =
          i % 4 > 1 && !is_group ? "n" + std::to_string(i) : std::to_string(i);
      const std::string target = "{\"target\":\"/objects/" + called;
      if (moves)
        tracks += target + (is_group ? "/children/0" : "") + R"(/center/0","keys":[[0,)" +
                  std::to_string(to) + "]]},";
      if (leaves) tracks += target + R"(","visible":[[5,6]]},)";
      before += still + ",";
      if (!leaves) after += object_text(same, i, moves ? to : from) + ",";
    }
    if (tracks.empty()) continue;
    for (std::string* list : {&before, &after, &tracks})
      if (!list->empty()) list->pop_back();
    const std::string head = R"({"materials":{"red":{"color":[1,0,0]}},"objects":[)";
    const Scene moving =
        read_scene(head + before + R"(],"animation":{"duration":9,"tracks":[)" + tracks + "]}}");
    EXPECT_EQ(at_time(moving, 1, {}, {}), read_scene(head + after + "]}")) << before << tracks;
  }
}

// Whatever the order of the times, and whether the moment before is still in use.
TEST(AtTime, OfFewObjectsAmongManyHandsTheListOnFromMomentToMoment) {
  std::string objects;
  for (int i = 0; i < 130; ++i)
    objects += std::string(i > 0 ? "," : "") + R"({"type":"sphere","name":"b)" + std::to_string(i) +
               R"(","radius":1,"center":[)" + std::to_string(3 * i) + ",0,0]}";
  const auto moving = [&](const std::string& more) {
    return read_scene(R"({"objects":[)" + objects + R"x(],"animation":{"duration":9,"tracks":[
        {"target":"/objects/b7/center/1","formula":"t"},
        {"target":"/objects/30/transform/0/translate","keys":[[0,[0,0,0]],[9,[9,9,9]]]},
        {"target":"/camera/location","keys":[[0,[0,0,9]],[9,[9,0,9]]]})x" +
                      more + "]}}");
  };
  Scene scene = moving("");
  scene.objects[30].transform.steps = {Translate{}};
  Moments moments(scene);
  EXPECT_EQ(moments.moved(), (std::vector<std::size_t>{7, 30}));
  Scene before;
  const Object* list = nullptr;
  for (const double seconds : {0.0, 3.5, 1.0, 1.0, 9.0, 0.25}) {
    Scene now = moments.at(seconds, {}, {});
    EXPECT_EQ(now, at_time(scene, seconds, {})) << seconds;
    EXPECT_TRUE(seconds != 9 || now.objects.get().data() == list);
    before = seconds == 1 ? Scene{} : now;
    list = now.objects.get().data();
  }
  for (const char* more : {R"(,{"target":"/objects/3","visible":[[0,1]]})",
                           R"(,{"target":"/ambient_light","formula":"t"})",
                           R"x(,{"target":"/objects/3/material/color","formula":["t","0","0"]})x",
                           R"(,{"target":"/key_light/position","formula":["t","0","0"]})"})
    EXPECT_FALSE(Moments(moving(more)).are_few()) << more;
}

TEST(AtTime, OfFewObjectsAmongManyTellsFaultsOfTheWholeScene) {
  std::string objects;
  for (int i = 0; i < 64; ++i) objects += R"({"type":"sphere","radius":1,"center":[0,0,0]},)";
  objects.pop_back();
  const Scene scene = read_scene(R"({"objects":[)" + objects + R"(],"animation":{"duration":2,
      "tracks":[{"target":"/objects/17/radius","formula":"1-t"}]}})");
  Moments moments(scene);
  ASSERT_TRUE(moments.are_few());
  EXPECT_NO_THROW(moments.at(0.5, {}, {}));
  try {
    moments.at(1.5, {}, {});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.faults().front().allowed, testing::HasSubstr("at /objects/17/radius"));
  }
}

}  // namespace
}  // namespace tia
