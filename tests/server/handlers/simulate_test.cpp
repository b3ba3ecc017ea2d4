// Scenes with physics over HTTP: simulated once, then moments as those of tracks.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string bounce = R"({"objects":[
    {"name":"floor","type":"plane","point":[0,-2,0],"normal":[0,1,0]},
    {"name":"ball","type":"sphere","center":[0,0.5,-9],"radius":0.5}],
  "lights":[{"type":"point","position":[4,6,-3]}],
  "physics":{"gravity":[0,-8,0],"duration":2,
      "bodies":[{"object":"ball","mass":2,"restitution":0.5}],"fixed":[{"object":"floor"}]}})";

std::string with_scene(const std::string& scene, const std::string& more = "") {
  return "{" + more + R"("scene":)" + scene + "}";
}

TEST(Simulating, AnswersTracksContactsAndEnergy) {
  const Response response = host().post("/simulate", with_scene(bounce));
  ASSERT_EQ(response.status, 200) << response.body;
  const Value told = parse_json(response.body);
  EXPECT_EQ(find(*at(told, "scene").as<Value::Object>(), "physics"), nullptr);
  // Down from 0.5 to -1.5 under 8: after sqrt(2 2 / 8) s, with 8 sqrt(1/2), 3/2 of which turn.
  const Value first = at(told, "contacts").as<Value::Array>()->front();
  EXPECT_NEAR(number_at(first, "time"), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(number_at(first, "impulse"), 2 * 1.5 * 8 * std::sqrt(0.5), 1e-11);
  EXPECT_EQ(text_at(first, "a"), "ball");
  EXPECT_EQ(text_at(first, "b"), "floor");
  EXPECT_GE(number_at(told, "events"), 1);
  const auto& energy = *at(told, "energy").as<Value::Array>();
  const auto& start = *energy.front().as<Value::Array>();
  EXPECT_EQ(start[1], Value(0));
  EXPECT_NEAR(*start[2].as<double>(), 2 * 8 * 0.5, 1e-12);
}

TEST(Simulating, AMomentIsThatOfTheTracksToTheByte) {
  Host keeper, other;
  const Value told = parse_json(keeper.post("/simulate", with_scene(bounce)).body);
  const std::string baked = to_json(at(told, "scene"));
  const std::string size = R"("width":24,"height":16,)";
  for (const std::string time : {"0", "0.5", "0.75", "1.75"}) {
    SCOPED_TRACE(time);
    const std::string moment = size + R"("time":)" + time + ",";
    const Response frame = keeper.post("/render", with_scene(bounce, moment));
    const Response of_tracks = other.post("/render", with_scene(baked, moment));
    ASSERT_EQ(frame.status, 200) << frame.body;
    EXPECT_TRUE(frame.body == of_tracks.body);
    EXPECT_EQ(header(frame, "ETag"), header(of_tracks, "ETag"));
    const std::string pixel = moment + R"("x":11,"y":8,)";
    EXPECT_EQ(keeper.post("/explain", with_scene(bounce, pixel)).body,
              other.post("/explain", with_scene(baked, pixel)).body);
    // A picture draws itself again: its recipe holds the plain scene of its moment.
    EXPECT_TRUE(other.post("/render", frame.body, "image/png").body == frame.body);
    EXPECT_THAT(other.post("/verify", frame.body, "image/png").body, HasSubstr(R"("same")"));
  }
  const auto still = [&](const std::string& more) {
    return keeper.post("/render", with_scene(bounce, size + more)).body;
  };
  EXPECT_TRUE(still("") == still(R"("time":0,)"));
  EXPECT_FALSE(still("") == still(R"("time":0.5,)"));
}

TEST(Simulating, OfAKeptSceneIsByItsId) {
  Host keeper;
  const Response kept = keeper.post("/scenes", bounce);
  ASSERT_EQ(kept.status, 201) << kept.body;
  const std::string id = text_at(parse_json(kept.body), "id");
  EXPECT_EQ(keeper.get("/scenes/" + id).body, canonical_text(read_scene(bounce)));
  EXPECT_EQ(keeper.post("/simulate", R"({"scene":")" + id + R"("})").body,
            keeper.post("/simulate", with_scene(bounce)).body);
  const Response plain = keeper.get("/scenes/" + id + "?time=0.5");
  ASSERT_EQ(plain.status, 200) << plain.body;
  const Scene at_half = read_scene(plain.body);  // it has fallen by 8 / 2 / 4
  EXPECT_NEAR(at_half.objects[1].transform.affine().offset.y, -1, 1e-12);
  EXPECT_THAT(plain.body, testing::Not(HasSubstr("physics")));
  EXPECT_EQ(only_error(keeper.get("/scenes/" + id + "?time=2.5")).pointer, "/time");
}

TEST(Simulating, FaultsAreToldAtTheirPlaces) {
  const std::string wrong = R"({"objects":[{"name":"box","type":"box","min":[0,0,0],"max":[1,1,1]}],
    "physics":{"bodies":[{"object":"box","mass":1},{"object":"bxo","mass":1}]}})";
  for (const char* path : {"/simulate", "/render", "/explain?"}) {
    const std::string more = path[1] == 'e' ? R"("x":1,"y":1,)" : "";
    const Response response =
        host().post(path[1] == 'e' ? "/explain" : path, with_scene(wrong, more));
    EXPECT_EQ(response.status, 422);
    const Problem problem = problem_of(response);
    ASSERT_EQ(problem.errors.size(), 2) << response.body;
    EXPECT_EQ(problem.errors[0].pointer, "/scene/physics/bodies/1/object");
    EXPECT_EQ(problem.errors[0].nearest, "box");
    EXPECT_EQ(problem.errors[1].pointer, "/scene/physics/bodies/0/object");
  }
  const Response kept = host().post("/scenes", wrong);
  EXPECT_EQ(kept.status, 422);
  EXPECT_EQ(problem_of(kept).errors[0].pointer, "/physics/bodies/1/object");
  EXPECT_EQ(only_error(host().post("/simulate", R"({"scene":"thesis"})")).pointer,
            "/scene/physics");
  EXPECT_EQ(only_error(host().post("/simulate", "{}")).pointer, "/scene");
  EXPECT_EQ(only_error(host().post("/simulate", R"({"scene":"thesi"})")).nearest, "thesis");
}

TEST(Simulating, TakesMaxEventsAndNoMore) {
  Config config;
  config.max_events = 40;
  Host narrow(config);
  const Response response = narrow.post("/simulate", with_scene(R"({"objects":[
      {"name":"ball","type":"sphere","center":[0,0,0],"radius":1},
      {"name":"room","type":"box","min":[-2,-2,-2],"max":[2,2,2]}],
    "physics":{"gravity":[0,0,0],"duration":10,"fixed":[{"object":"room"}],
      "bodies":[{"object":"ball","mass":1,"velocity":[20,0,0]}]}})"));
  EXPECT_EQ(response.status, 422);
  const ProblemError error = only_error(response);
  EXPECT_EQ(error.pointer, "/scene/physics/duration");
  EXPECT_THAT(error.allowed, HasSubstr("at most 40 events (option TIA_MAX_EVENTS)"));
}

TEST(Simulating, EndsWhenNobodyWaitsForIt) {
  Host left;
  left.stop();
  EXPECT_EQ(left.post("/simulate", with_scene(bounce)).status, 503);
}

}  // namespace
}  // namespace tia::test
