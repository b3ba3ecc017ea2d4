// time and frame: a moment of an animated scene is a plain scene, over HTTP.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// A light that goes over, a ball that comes at 1 s, and a ball of a model's size of time.
const std::string moving_light = R"({"animation":{"duration":2,"fps":4,"tracks":[
    {"target":"/key_light/position","keys":[[0,[-9,9,0]],[2,[9,9,0]]],"interpolation":"smooth"},
    {"target":"/objects/b","visible":[[1,2]]},
    {"target":"/objects/b/radius","formula":"t/2"}]},
  "objects":[{"type":"sphere","center":[0,0,-9],"radius":1},
             {"name":"b","type":"sphere","center":[2,0,-9],"radius":1}]})";

std::string id_of_moving(Host& keeper, const std::string& scene) {
  return *find(*parse_json(keeper.post("/scenes", scene).body).as<Value::Object>(), "id")
              ->as<std::string>();
}
std::string moment_drawn(Host& at, const std::string& query) {
  const Response response = at.get("/render?width=24&height=16&" + query);
  EXPECT_EQ(response.status, 200) << response.body;
  return response.body;
}

TEST(Moments, ArePicturesOfThePlainScene) {
  Host keeper, other;
  const std::string id = id_of_moving(keeper, moving_light);
  for (const char* moment : {"time=1.25", "frame=5"}) {
    SCOPED_TRACE(moment);
    const Response scene = keeper.get("/scenes/" + id + "?" + moment);
    ASSERT_EQ(scene.status, 200) << scene.body;
    EXPECT_EQ(parse_json(scene.body).as<Value::Object>()->size(), 2) << "objects and lights";
    EXPECT_THAT(scene.body, HasSubstr(R"("radius":0.625)"));
    const std::string query = "width=24&height=16&scene=" + id + "&" + moment;
    const std::string body = R"({"width":24,"height":16,"scene":)" + scene.body + "}";
    const Response frame = keeper.get("/render?" + query), plain = other.post("/render", body);
    ASSERT_EQ(frame.status, 200) << frame.body;
    EXPECT_TRUE(frame.body == plain.body);
    EXPECT_EQ(header(frame, "ETag"), header(plain, "ETag"));
    EXPECT_EQ(keeper.get("/explain?x=9&y=8&" + query).body,
              other.post("/explain", R"({"x":9,"y":8,)" + body.substr(1)).body);
    EXPECT_TRUE(other.post("/render", frame.body, "image/png").body == frame.body);
    EXPECT_THAT(other.post("/verify", frame.body, "image/png").body, HasSubstr(R"("same")"));
  }
}

TEST(Moments, AreTheTimeZeroWhereNoneIsAskedFor) {
  Host keeper;
  const std::string id = id_of_moving(keeper, moving_light), scene = "scene=" + id;
  EXPECT_TRUE(moment_drawn(keeper, scene) == moment_drawn(keeper, scene + "&time=0"));
  EXPECT_TRUE(moment_drawn(keeper, scene) == moment_drawn(keeper, scene + "&frame=0"));
  EXPECT_FALSE(moment_drawn(keeper, scene) == moment_drawn(keeper, scene + "&frame=1"));
  EXPECT_EQ(keeper.get("/scenes/" + id).body, canonical_text(read_scene(moving_light)))
      << "the scene itself still moves";
}

// The camera is patched before, as the light is moved, which a track then moves.
TEST(Moments, ComeAfterTheRequestsOwnChanges) {
  Host keeper;
  const std::string id = id_of_moving(keeper, moving_light), moment = "scene=" + id + "&time=1.5";
  EXPECT_TRUE(moment_drawn(keeper, moment + "&light=1,2,3") == moment_drawn(keeper, moment));
  EXPECT_FALSE(moment_drawn(keeper, moment + "&camera=%7B%22fov_degrees%22:50%7D") ==
               moment_drawn(keeper, moment));
}

struct MomentFault {
  const char* law;
  const char* query;
  const char* type;
  const char* pointer;
  const char* allowed;
};
void PrintTo(const MomentFault& fault, std::ostream* out) { *out << fault.query; }
class MomentFaultOf : public testing::TestWithParam<MomentFault> {};

TEST_P(MomentFaultOf, IsNamed) {
  const auto& [law, query, type, pointer, allowed] = GetParam();
  static Host keeper;
  static const std::string id = id_of_moving(keeper, moving_light);
  for (const std::string& target :
       {"/render?scene=" + id + "&" + query, "/scenes/" + id + "?" + query}) {
    const Response response = keeper.get(target);
    EXPECT_EQ(response.status, 422) << response.body;
    EXPECT_EQ(problem_of(response).type, std::string("/problems/") + type);
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, pointer);
    EXPECT_THAT(error.allowed, HasSubstr(allowed));
  }
}

const MomentFault moment_faults[] = {
    {"BeyondTheEnd", "time=2.5", "out-of-range", "/time", "a number from 0 to 2 (s)"},
    {"BeforeTheBeginning", "time=-1", "out-of-range", "/time", "from 0"},
    {"FrameBeyondTheLast", "frame=8", "out-of-range", "/frame", "an integer from 0 to 7"},
    {"FrameOfAFraction", "frame=1.5", "wrong-type", "/frame", "an integer"},
    {"Both", "time=1&frame=1", "conflict", "/frame", "time or frame"},
    {"Unknown", "tme=1", "unknown-name", "/tme", "time"},
};
INSTANTIATE_TEST_SUITE_P(All, MomentFaultOf, testing::ValuesIn(moment_faults), law_of);

TEST(Moments, OfASceneThatDoesNotMoveAreAConflict) {
  for (const char* target : {"/render?time=0", "/scenes/thesis?time=0"}) {
    const ProblemError error = only_error(host().get(target));
    EXPECT_EQ(error.pointer, "/time");
    EXPECT_THAT(error.allowed, HasSubstr("does not move"));
  }
  EXPECT_EQ(host().get("/scenes/none?time=0").status, 404);
}

TEST(Moments, FaultsOfAllTracksAreToldWithTheTime) {
  const std::string scene = R"({"animation":{"duration":2,"tracks":[
      {"target":"/objects/0/radius","formula":"1-t"},
      {"target":"/objects/0/color","formula":"1"}]},
    "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]})";
  const Response drawn = host().post("/render", R"({"time":1.5,"scene":)" + scene + "}");
  EXPECT_EQ(drawn.status, 422);
  EXPECT_THAT(drawn.body, HasSubstr("/scene/animation/tracks/0"));
  EXPECT_THAT(drawn.body, HasSubstr("at 1.5 s at /objects/0/radius"));
  EXPECT_THAT(drawn.body, HasSubstr("/scene/animation/tracks/1/target"));
  const Response kept = host().post("/scenes", scene);
  EXPECT_EQ(kept.status, 422);
  EXPECT_THAT(kept.body, HasSubstr(R"("pointer":"/animation/tracks/1/target")"));
  EXPECT_THAT(kept.body, HasSubstr("at 1 s at /objects/0/radius"));
  EXPECT_THAT(kept.body, HasSubstr(R"("pointer":"/animation/tracks/0")"));
}

}  // namespace
}  // namespace tia::test
