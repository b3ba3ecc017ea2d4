// What jobs come to: the bytes, the tag and the rays of POST /render, however they are cut.
#include <algorithm>
#include <set>

#include "core/scene/views.h"
#include "server/stores/gallery_models.h"
#include "tests/server/jobs/jobs_support.h"
#include "tests/server/still_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

/// JobPictures: a server whose jobs are cut into small windows, and another one to compare with,
/// which knows none of its pictures.
class JobPictures : public testing::Test {
 protected:
  JobPictures() { own_.service().jobs.cut_to(16); }
  static std::string job(const std::string& request) {
    return R"({"kind":"render","request":)" + request + "}";
  }
  // Returns: how many parts it had; of a PNG that is cut these are windows of 16 pixels.
  int expect_same(const std::string& request) {
    const Response drawn = apart_.post("/render", request);
    EXPECT_EQ(drawn.status, 200) << drawn.body;
    const std::string id = job_id(own_, job(request));
    const Response result = result_of(own_, id);
    EXPECT_EQ(result.status, 200) << result.body;
    EXPECT_TRUE(result.body == drawn.body) << request;
    for (const char* name : {"ETag", "Tia-Rays", "Tia-Samples", "Tia-Noise"})
      EXPECT_EQ(header(result, name), header(drawn, name)) << name << " of " << request;
    EXPECT_EQ(result.content_type, drawn.content_type);
    const Response again = own_.post("/render", request);
    EXPECT_EQ(header(again, "Cache-Status"), "Tia; hit") << request;
    EXPECT_TRUE(again.body == drawn.body);
    const Value status = parse_json(own_.get("/jobs/" + id).body);
    return static_cast<int>(number_at(at(status, "progress"), "parts"));
  }

  Host own_, apart_;
};

TEST_F(JobPictures, AreThoseOfRenderForEveryGalleryScene) {
  for (const auto& [name, scene] : own_.gallery().scenes()) {
    if (sanitized() && name != "thesis") continue;  // others take minutes to compile, then
    const int parts =
        expect_same(R"({"width":32,"height":24,"samples":2,"scene":")" + name + "\"}");
    const ViewGrid views = views_of(scene->camera, 32, 24);
    const int windows = (32 * views.columns + 15) / 16 * ((24 * views.rows + 15) / 16);
    EXPECT_EQ(parts, scene->sheet ? 1 : windows) << name;
    if (HasFailure()) break;
  }
}

TEST_F(JobPictures, AreThoseOfRenderInEveryFormatAndHoweverTheyAreCut) {
  const std::string start = R"({"key":"a","width":40,"height":28,)";
  EXPECT_EQ(expect_same(start + R"("format":"pfm"})"), 6);
  EXPECT_EQ(expect_same(start + R"("format":"hdr","crop":[3,5,36,27]})"), 6);
  EXPECT_EQ(expect_same(start + R"("format":"tiff","integrator":"depth","depth_range":[1,25]})"),
            6);
  EXPECT_EQ(expect_same(start + R"("format":"exr","aov":["rgba","normal"]})"), 1);
  EXPECT_EQ(expect_same(start + R"("threshold":0.02,"scene":"whitted"})"), 6);
  EXPECT_EQ(expect_same(start + R"("noise":0.05,"integrator":"path"})"), 6);
  EXPECT_EQ(expect_same(start + R"("denoise":true,"integrator":"path","samples":4})"), 1);
  for (const int side : {16, 23, 32, 640}) {
    own_.service().jobs.cut_to(side);
    expect_same(R"({"width":40,"height":28,"seed":)" + std::to_string(side) + "}");
  }
}

TEST_F(JobPictures, OfAStillHaveItsAlpha) {
  const Response scene = own_.get("/still?model=part&as=scene&width=40&height=28");
  ASSERT_EQ(scene.status, 200) << scene.body;
  EXPECT_EQ(expect_same(R"({"width":40,"height":28,"samples":2,"scene":)" + scene.body + "}"), 6);
}

TEST_F(JobPictures, OfALargePictureArePutTogetherInStripsAsItIsDrawn) {
  own_.service().jobs.cut_to(512);
  expect_same(R"({"key":"d","width":800,"height":600})");
}

TEST_F(JobPictures, OfWhoDoesNotWaitAreTheSame) {
  const std::string request = R"({"key":"s","width":40,"height":28})";
  const Response accepted = own_.ask("POST", "/render", request, {{"Prefer", "respond-async"}});
  EXPECT_EQ(header(accepted, "Preference-Applied"), "respond-async");
  EXPECT_TRUE(result_of(own_, job_id(accepted)).body == apart_.post("/render", request).body);
  const std::string budget = R"({"width":8,"height":8,"max_rays":99999,"integrator":"path"})";
  EXPECT_EQ(own_.ask("POST", "/render", budget, {{"Prefer", "respond-async"}}).status, 200)
      << "whose picture is not known beforehand";
}

TEST_F(JobPictures, OfABatchAreOneARequest) {
  const std::string id = job_id(own_, R"({"kind":"batch","request":{"width":16,"height":12},
                       "grid":{"/light":[[4,5,6],[-4,5,6]],"/samples":[1,2,3]}})");
  ASSERT_EQ(ended(own_, id), "done");
  for (int n = 0; n < 6; ++n) {
    const Response one = own_.get("/jobs/" + id + "/results/" + std::to_string(n));
    const std::string light = n < 3 ? "[4,5,6]" : "[-4,5,6]";
    const Response drawn =
        apart_.post("/render", R"({"width":16,"height":12,"light":)" + light + R"(,"samples":)" +
                                   std::to_string(n % 3 + 1) + "}");
    EXPECT_TRUE(one.body == drawn.body) << n;
    EXPECT_EQ(header(one, "ETag"), header(drawn, "ETag"));
    EXPECT_EQ(header(one, "Tia-Rays"), header(drawn, "Tia-Rays"));
  }
  EXPECT_EQ(own_.get("/jobs/" + id + "/results/6").status, 404);
  const Value parts = at(parse_json(own_.get("/jobs/" + id + "/parts?first=4").body), "parts");
  ASSERT_EQ(parts.as<Value::Array>()->size(), 2U);
  EXPECT_EQ(number_at((*parts.as<Value::Array>())[0], "frame"), 4);
}

TEST_F(JobPictures, OfATurntableAreTheViewsOfItsSheet) {
  const std::string id = job_id(own_, R"({"kind":"turntable","views":3,"request":
               {"model":"part","width":24,"height":20,"integrator":"whitted","samples":1}})");
  ASSERT_EQ(ended(own_, id), "done");
  const Png sheet = read_png(
      apart_
          .get("/still?model=part&width=24&height=20&integrator=whitted&samples=1&turntable=3"
               "&columns=1")
          .body);
  for (int n = 0; n < 3; ++n) {
    const Png view = read_png(own_.get("/jobs/" + id + "/results/" + std::to_string(n)).body);
    ASSERT_EQ(view.rgba.size(), sheet.rgba.size() / 3);
    EXPECT_TRUE(std::equal(view.rgba.begin(), view.rgba.end(),
                           sheet.rgba.begin() + std::ptrdiff_t(view.rgba.size()) * n))
        << n;
  }
}

// ---- faults ---------------------------------------------------------------------------------

struct BadJob {
  const char* law;
  const char* body;
  const char* type;
  const char* pointer;
};
void PrintTo(const BadJob& bad, std::ostream* out) { *out << bad.law; }

class BadJobs : public testing::TestWithParam<BadJob> {};

TEST_P(BadJobs, AreRefusedWhereTheyAreWrong) {
  const Response refused = host().post("/jobs", GetParam().body);
  EXPECT_EQ(refused.status, 422) << refused.body;
  const Problem problem = problem_of(refused);
  EXPECT_EQ(problem.type, std::string("/problems/") + GetParam().type);
  ASSERT_FALSE(problem.errors.empty());
  EXPECT_EQ(problem.errors[0].pointer, GetParam().pointer);
}

INSTANTIATE_TEST_SUITE_P(
    Of, BadJobs,
    testing::Values(
        BadJob{"AnUnknownKind", R"({"kind":"film","request":{}})", "unknown-name", "/kind"},
        BadJob{"NoKind", R"({"request":{}})", "missing", "/kind"},
        BadJob{"NoRequest", R"({"kind":"render"})", "missing", "/request"},
        BadJob{"AFaultOfItsRequest", R"({"kind":"render","request":{"width":0}})", "out-of-range",
               "/request/width"},
        BadJob{"AnUnknownScene", R"({"kind":"render","request":{"scene":"nowhere"}})",
               "unknown-name", "/request/scene"},
        BadJob{"ABudget", R"({"kind":"render","request":{"integrator":"path","budget_ms":9}})",
               "conflict", "/request/budget_ms"},
        BadJob{"AFaultOfOneOfMany", R"({"kind":"batch","requests":[{},{},{"width":-1}]})",
               "out-of-range", "/requests/2/width"},
        BadJob{"APointerIntoNothing", R"({"kind":"batch","request":{},"grid":{"/a/b/c":[1]}})",
               "out-of-range", "/grid/~1a~1b~1c"},
        BadJob{"ALightWhereItCannotShineFrom",
               R"({"kind":"batch","request":{"scene":{"camera":{"look_at":[0,0,-9]},"lights":)"
               R"([{"type":"directional","direction":[0,-1,0]}]}},)"
               R"("grid":{"/light":[[0,5,0],[1,5,0],[0,0,-9]]}})",
               "out-of-range", "/request/light"},
        BadJob{"ALargeGrid",
               R"({"kind":"batch","request":{},"grid":{"/seed":[)"
               R"(1,2,3,4,5,6,7,8,9,10]
               ,"/samples":[1,2,3,4,5,6,7,8,9,10],"/width":[1,2,3,4,5,6,7,8,9,10],
               "/height":[1,2,3,4,5,6,7,8,9,10],"/max_depth":[1,2,3,4,5,6,7,8,9,10],
               "/light":[[1,1,1],[2,2,2]]}})",
               "limit", "/grid"},
        BadJob{"TooManyRays",
               R"({"kind":"render","request":{"width":4000,"height":4000,"samples":65536}})",
               "limit", "/request/samples"},
        BadJob{"MoreRaysThanItWants", R"({"kind":"render","max_rays":99,"request":{}})", "limit",
               "/max_rays"},
        BadJob{"NoViews", R"({"kind":"turntable","request":{"model":"part"}})", "missing",
               "/views"},
        BadJob{"TooManyViews", R"({"kind":"turntable","views":3601,"request":{"model":"part"}})",
               "out-of-range", "/views"},
        BadJob{"AnotherKindsMember", R"({"kind":"render","request":{},"views":3})", "conflict",
               "/views"}),
    law_of);

TEST(JobRoutes, AnswerWhereThereIsNothingYetAndNothingAnyMore) {
  Host own;
  EXPECT_EQ(own.get("/jobs/aaaaaaaaaaaaaaaaaaaaaaaaaa").status, 404);
  const std::string id = job_id(
      own, R"({"kind":"render","request":{"integrator":"path","samples":60000,"width":640}})");
  const Response early = own.get("/jobs/" + id + "/result");
  EXPECT_EQ(early.status, 409);
  EXPECT_EQ(problem_of(early).type, "/problems/not-ready");
  EXPECT_EQ(own.ask("DELETE", "/jobs/" + id).status, 204);
  EXPECT_EQ(state_of(own, id), "cancelled");
  EXPECT_EQ(problem_of(own.get("/jobs/" + id + "/result")).type, "/problems/gone");
  EXPECT_EQ(own.ask("DELETE", "/jobs/" + id).status, 204);
  EXPECT_EQ(own.get("/jobs/" + id).status, 404);
  EXPECT_EQ(problem_of(own.ask("GET", "/jobs/" + id, "", {{"Prefer", "wait=61"}})).type,
            "/problems/not-found");
  const Value load = parse_json(own.get("/jobs/load").body);
  EXPECT_EQ(number_at(load, "jobs_unfinished"), 0);
}

TEST(JobRoutes, RefuseAWaitBeyondAMinute) {
  const std::string id = job_id(host(), R"({"kind":"render","request":{"width":8,"height":8}})");
  const Response refused = host().ask("GET", "/jobs/" + id, "", {{"Prefer", "wait=61"}});
  EXPECT_EQ(only_error(refused).pointer, "/Prefer");
}

TEST(JobRoutes, TellAFaultThatOnlyDrawingFinds) {
  Host own;
  const std::string id = job_id(
      own,
      R"({"kind":"render","max_rays":6000,"request":{"scene":"whitted","width":32,"height":24}})");
  EXPECT_EQ(ended(own, id), "failed");
  const Response refused = own.get("/jobs/" + id + "/result");
  EXPECT_EQ(refused.status, 422);
  EXPECT_THAT(refused.body, HasSubstr("/problems/limit"));
}

TEST(JobRoutes, OfFiftyWhoSendOneKeyMakeOneJob) {
  Host own;
  std::vector<std::string> ids(50);
  {
    std::vector<std::jthread> clients;
    for (std::string& id : ids)
      clients.emplace_back([&] {
        id =
            job_id(own.ask("POST", "/jobs", R"({"kind":"render","request":{"width":8,"height":8}})",
                           {{"Idempotency-Key", "one"}, {"Content-Type", "application/json"}}));
      });
  }
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 1U);
  const Response other =
      own.ask("POST", "/jobs", R"({"kind":"render","request":{}})", {{"Idempotency-Key", "one"}});
  EXPECT_EQ(problem_of(other).type, "/problems/conflict");
}

TEST(JobLimits, UnfinishedAreAsManyAsMaxJobsSays) {
  Config config;
  config.max_jobs = 1;
  Host own(config);
  const std::string job =
      R"({"kind":"render","request":{"integrator":"path","samples":60000,"width":640}})";
  const std::string id = job_id(own, job);
  EXPECT_EQ(problem_of(own.post("/jobs", job)).type, "/problems/busy");
  own.ask("DELETE", "/jobs/" + id);
  own.ask("DELETE", "/jobs/" + job_id(own, job));
}

TEST(JobLimits, RaysAreAsManyAsMaxJobRaysSays) {
  Config config;
  config.max_job_rays = 64;
  Host own(config);
  EXPECT_EQ(
      own.post("/jobs", R"({"kind":"render","request":{"width":8,"height":8,"scene":{}}})").status,
      202);
  const Response refused =
      own.post("/jobs", R"({"kind":"render","request":{"width":65,"height":1,"scene":{}}})");
  EXPECT_THAT(problem_of(refused).detail, HasSubstr("TIA_MAX_JOB_RAYS"));
}

}  // namespace
}  // namespace tia::test
