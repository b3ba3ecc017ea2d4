// /explain: a pixel's ray, the request's camera and light, faults.
#include "core/math/deterministic.h"
#include "tests/server/handlers/explain_support.h"

namespace tia::test {
namespace {

// ---- pixels ------------------------------------------------------------------------------------

// The thesis: xx = (2x+1-W)/W tan(fov/2) W/H, yy = (H-2y-1)/H tan(fov/2), direction (xx, yy, -1).
TEST(Explain, APixelsRayIsTheThesis) {
  const double tangent = tan_of(12.5 * pi / 180);
  for (const auto& [x, y] :
       std::vector<std::pair<int, int>>{{0, 0}, {639, 479}, {320, 240}, {17, 401}}) {
    const Value answer = answer_to({{"x", x}, {"y", y}});
    EXPECT_EQ(at(answer, "pixel"), Value(Value::Array{x, y}));
    EXPECT_EQ(number_at(answer, "sample"), 0);
    const double xx = (2.0 * x + 1 - 640) / 640 * tangent * 640 / 480;
    const double yy = (480 - 2.0 * y - 1) / 480 * tangent;
    expect_near(vec(at(at(answer, "ray"), "origin")), {0, 0, 0}, 0);
    expect_near(vec(at(at(answer, "ray"), "direction")), normalize(Vec3d{xx, yy, -1}), 1e-15);
  }
}

TEST(Explain, ThePixelInTheMiddleMeetsTheThesisBall) {
  const auto hits = hits_of(answer_to({{"x", 320}, {"y", 240}}));
  ASSERT_GE(hits.size(), 2U);
  EXPECT_EQ(hits[0].object, "ball");
  EXPECT_NEAR(hits[0].t, 16, 1e-4);  // half a pixel off the axis
  EXPECT_TRUE(hits[0].front);
}

TEST(Explain, SeesTheSceneAfterItsKeyAndThroughTheRequestsCamera) {
  const auto lamp =
      hits_of(answer_to({{"x", 50},
                         {"y", 50},
                         {"width", 101},
                         {"height", 101},
                         {"light", array({0, 0, -50})},
                         {"camera", Value::Object{{"location", array({0, 0, -60})}}}}));
  ASSERT_GE(lamp.size(), 1U);  // it looks from behind at the lamp of radius 3, 10 away
  EXPECT_EQ(lamp[0].object, "/key_light");
  EXPECT_NEAR(lamp[0].t, 7, 1e-9);
}

Value notes_of(const std::string& scene) {
  const Value answer = answer_to({{"x", 320}, {"y", 240}, {"scene", parse_json(scene)}});
  const Value* notes = find(*answer.as<Value::Object>(), "notes");
  return notes != nullptr ? *notes : Value();
}

TEST(Explain, NotesWhatTheIntegratorLeavesOut) {
  EXPECT_EQ(notes_of(R"({"options":{"exposure":1}})"), Value());
  const Value notes = notes_of(R"({"fog":{"density":1},"options":{"clamp":1,"ao_radius":1}})");
  EXPECT_EQ(to_json(notes), R"([{"about":"only path sees fog","pointer":"/fog"},)"
                            R"({"about":"only ambient_occlusion looks so far",)"
                            R"("pointer":"/options/ao_radius"},)"
                            R"({"about":"only path's samples are clamped",)"
                            R"("pointer":"/options/clamp"}])");
}

// A torus has no area that is asked for, as a ball has.
TEST(Explain, NotesTwentyObjectsThatPathMeetsByChance) {
  const auto glowing = [](int count) {
    std::string objects = R"({"type":"sphere","center":[0,0,-9],"radius":1,"material":"glow"})";
    for (int i = 0; i < count; ++i)
      objects += R"(,{"type":"torus","major_radius":2,"minor_radius":0.5,"material":"glow"})";
    return notes_of(R"({"materials":{"glow":{"emission":1}},"objects":[)" + objects + "]}");
  };
  EXPECT_EQ(glowing(0), Value());
  const Value notes = glowing(25);
  ASSERT_EQ(notes.as<Value::Array>()->size(), 20U);
  EXPECT_EQ(at((*notes.as<Value::Array>())[0], "pointer"), Value("/objects/1"));
}

TEST(Explain, GetAndPostSayTheSame) {
  const std::string by_get =
      host().get("/explain?ray.origin=0,0,0&ray.direction=0,0.1,-1&key=a").body;
  EXPECT_EQ(host()
                .post("/explain", R"({"key":"a","ray":{"origin":[0,0,0],"direction":[0,0.1,-1]}})")
                .body,
            by_get);
  EXPECT_EQ(
      host()
          .get("/explain?key=a&ray=" + url_encode(R"({"origin":[0,0,0],"direction":[0,0.1,-1]})"))
          .body,
      by_get);
  EXPECT_EQ(host().get("/explain?x=7&y=9").body, host().post("/explain", R"({"x":7,"y":9})").body);
  EXPECT_EQ(host().head("/explain?x=7&y=9").status, 200);
}

// ---- faults ------------------------------------------------------------------------------------

struct RefusedRequest {
  const char* query;
  const char* type;
  const char* pointer;
  const char* allowed;
};
TEST(Explain, FaultsAreNamedAlikeWhereverTheyAre) {
  const RefusedRequest faults[] = {
      {"x=640&y=0", "out-of-range", "/x", "an integer from 0 to 639"},
      {"x=0&y=480", "out-of-range", "/y", "an integer from 0 to 479"},
      {"x=20&y=0&width=20&height=20", "out-of-range", "/x", "from 0 to 19"},
      {"x=-1&y=0", "out-of-range", "/x", "from 0"},
      {"x=0.5&y=0", "wrong-type", "/x", "an integer"},
      {"x=3", "missing", "/y", "from 0 to 479"},
      {"y=3", "missing", "/x", "ray"},
      {"x=3&ray.origin=0,0,0&ray.direction=0,0,-1", "conflict", "/x", "or ray"},
      {"ray.origin=0,0,0&ray.direction=0,0,0", "out-of-range", "/ray/direction", "some length"},
      {"ray.origin=0,0,0&ray.direction=1e-200,0,0", "out-of-range", "/ray/direction",
       "some length"},
      {"ray.origin=0,0,0", "missing", "/ray/direction", "3 numbers"},
      {"ray.origin=0,0&ray.direction=0,0,1", "wrong-type", "/ray/origin", "3 numbers"},
      {"ray.origin=0,0,2e9&ray.direction=0,0,1", "out-of-range", "/ray/origin/2", "1000000000"},
      {"ray.orign=0,0,0&ray.origin=0,0,0&ray.direction=0,0,1", "unknown-name", "/ray/orign",
       "origin"},
      {"ray=up", "wrong-type", "/ray", "an object"},
      {"x=1&y=1&crop=0,0,2,2", "unknown-name", "/crop", "scene, key, light"},
      {"x=1&y=1&sample=1", "out-of-range", "/sample", "from 0 to 0"},
      {"x=1&y=1&samples=4&sample=4", "out-of-range", "/sample", "from 0 to 3"},
      {"x=1&y=1&integrator=albedo", "out-of-range", "/integrator", "thesis or whitted"},
      {"x=1&y=1&integrator=normal", "out-of-range", "/integrator", "thesis or whitted"},
      {"x=1&y=1&max_depth=65", "out-of-range", "/max_depth", "from 0 to 64"},
      {"x=1&y=1&seed=-1", "out-of-range", "/seed", "from 0"},
      {"x=1&y=1&scene.title=a", "unknown-name", "/scene.title", "scene"},
      {"x=1&y=1&scene=thesi", "unknown-name", "/scene", "thesis"},
      {"x=1&y=1&width=5000&height=5000", "limit", "/width", "TIA_MAX_PIXELS"},
      {"ray.origin=0,0,0&ray.origin=1,0,0", "malformed", "/ray/origin", "once"},
      {"ray=up&ray.origin=1,0,0", "malformed", "/ray", "once"},
      {"ray.origin=0,0,0&ray=up", "malformed", "/ray", "once"},
  };
  for (const RefusedRequest& fault : faults) {
    SCOPED_TRACE(fault.query);
    const Response response = host().get(std::string("/explain?").append(fault.query));
    EXPECT_EQ(problem_of(response).type, std::string("/problems/").append(fault.type));
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, fault.pointer);
    EXPECT_THAT(error.allowed, testing::HasSubstr(fault.allowed));
  }
}

TEST(Explain, WithoutPixelAndRayBothCoordinatesAreMissing) {
  const Problem problem = problem_of(host().get("/explain"));
  EXPECT_EQ(problem.type, "/problems/missing");
  ASSERT_EQ(problem.errors.size(), 2U);
  EXPECT_EQ(problem.errors[0].pointer, "/x");
  EXPECT_EQ(problem.errors[1].pointer, "/y");
}

}  // namespace
}  // namespace tia::test
