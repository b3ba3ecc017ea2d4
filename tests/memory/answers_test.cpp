// R16: an allocation fails, any of them, in any thread. What comes back is the right answer or a
// problem that says so; what stays behind is nothing.
#include <barrier>
#include <thread>

#include "core/film/compressor.h"
#include "tests/core/film/files.h"
#include "tests/memory/scarce_memory.h"
#include "tests/memory/silence.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

constexpr long never = 1L << 60;

/// Desk: a service that nobody has used yet.
class Desk {
 public:
  Desk() {  // until all threads live: what they take to begin is not the answer's
    std::barrier all(threads);
    backend_.pool.for_each(threads, threads, {}, [&](int) { all.arrive_and_wait(); });
  }
  Service& service() { return backend_.service; }

 private:
  static const Gallery& gallery() {
    static const Gallery all;
    [[maybe_unused]] static const auto read = all.listing();  // as it is for any later request
    return all;
  }
  static constexpr int threads = 3;
  static Config with_threads() {
    Config config;
    config.threads = threads;
    return config;
  }
  Backend backend_{with_threads(), gallery()};
};

// ---- what is asked --------------------------------------------------------------------------

std::string small_picture() {
  Desk desk;
  return *answer({"GET", "/render?width=8&height=6", {}, "", "id"}, desk.service()).shared;
}

struct Asked {
  const char* law;
  int status;
  Request request;
};
void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.request.target; }

Request get(const std::string& target) { return {"GET", target, {}, "", "id"}; }
Request post(const std::string& target, const std::string& body) {
  return {"POST", target, {{"Content-Type", "application/json"}}, body, "id"};
}

const std::string png = base64(
    to_text(tia::test::png({2, 2, 8, rgb}, "\x10\x20\x30\x40\x50\x60\x70\x10\x30\x50\x70\x20")));
const std::string jpeg = base64(to_text(flat_jpeg({140, 120, 130})));

// A mesh, solids, walls, formulas of all kinds, textures, copies and lamps.
const std::string all_kinds = R"({"title":"all kinds","camera":{"location":[0,2,9]},
  "materials":{"marble":{"texture":{"type":"marble","colors":[[0.1,0.2,0.3],[0.9,0.8,0.7]]}}},
  "objects":[
   {"type":"mesh","positions":[0,0,0,1,0,0,0,1,0,1,1,1],"indices":[0,1,2,1,3,2],
    "material":"marble"},
   {"type":"csg","operation":"difference","material":{"texture":{"type":"image","data":
     ")" + png + R"("}},"children":[
      {"type":"box","min":[-3,-1,-1],"max":[-1,1,1]},{"type":"sphere","center":[-1,0,1],"radius":1}]},
   {"type":"implicit","f":"sin(x)+y","bounds":{"min":[-2,-2,-2],
    "max":[2,2,2]},"transform":[{"translate":[3,0,0]}],"material":{"reflection":0.5}},
   {"type":"parametric","x":"u","y":"v","z":"u*v","u":[-1,1],"v":[1,2]},
   {"type":"algebraic","terms":[[4,0,0,1],[0,4,0,1],[0,0,4,1],[0,0,0,-1]],
    "transform":[{"translate":[0,-2,0]}]},
   {"type":"voxels","size":[2,3,4],"occupied":[[3,1],[2,0],[4,2]],
    "materials":["marble",{"color":[1,0,0]}]},
   {"type":"group","repeat":{"count":[2,2,1],"step":[1,1,1]},"children":[{"type":"sphere",
    "center":[0,-3,0],"radius":0.3,"material":{"transmission":0.8,"ior":1.5}}]},
   {"type":"walls","points":[[0,-5],[2,-5],[3,-4]],"height":1,"thickness":0.2,
    "openings":[{"from":0.5,"to":1,"lintel":0.8}]},
   {"type":"torus","major_radius":3,"minor_radius":0.2,"material":{"texture":{"type":"image",
    "data":")" + jpeg + R"("}}}],
  "lights":[{"type":"point","position":[4,5,6]}]})";

// A ball that bounces once and meets another one.
const std::string falling_ball = R"({"scene":{"objects":[
   {"name":"floor","type":"plane","point":[0,0,0],"normal":[0,1,0]},
   {"name":"a","type":"sphere","center":[0,1.1,0],"radius":1},
   {"name":"b","type":"sphere","center":[2.2,3,0],"radius":1}],
  "physics":{"duration":0.3,"fixed":[{"object":"floor"}],"bodies":[
   {"object":"a","mass":1},{"object":"b","mass":2,"velocity":[-4,0,0]}]}}})";

std::vector<Asked> requests() {
  const std::string of_all_kinds = R"({"width":6,"height":4,"scene":)" + all_kinds;
  return {
      {"Thesis", 200, get("/render?width=16&height=12&key=a")},
      {"Linear", 200,
       get("/render?width=16&height=12&format=pfm&samples=2&camera=" +
           url_encode(R"({"fov_degrees":50})"))},
      {"Radiance", 200, get("/render?width=16&height=12&key=a&format=hdr")},
      {"AllKinds", 200, post("/render", of_all_kinds + "}")},
      {"ByKey", 200, get("/render?scene=prism&key=s&width=6&height=4&samples=1&threshold=0")},
      {"Strips", 200, post("/render", R"({"width":700,"height":560,"scene":{}})")},
      {"PictureSentBack", 200, {"POST", "/render", {}, small_picture(), "id"}},
      {"Verified", 200, {"POST", "/verify", {}, small_picture(), "id"}},
      {"Explanation", 200, get("/explain?scene=snell&width=64&height=48&x=32&y=20")},
      {"KeptScene", 201, post("/scenes", all_kinds)},
      {"Simulated", 200, post("/simulate", falling_ball)},
      {"Scene", 200, get("/scenes/klein")},
      {"Scenes", 200, get("/scenes")},
      {"Schema", 200, get("/schema/scene.json")},
      {"Page", 200, get("/")},
      {"Version", 200, get("/version")},
      {"Faults", 422, post("/render", R"({"width":0,"hight":5,"scene":{"objects":[{"type":"spher"},
                                   {"type":"sphere","radius":-1}],"lights":7}})")},
      {"FaultOfAQuery", 422, get("/render?width=8&light=1,2&camera=%7B%22fov%22%3A1%7D")},
      {"NoJson", 400, post("/render", R"({"a":[1,2,{"b":"c")")},
      {"UnknownScene", 422, get("/render?scene=tesis")},
      {"UnknownPath", 404, get("/rendr")},
      {"WrongMethod", 405, {"PUT", "/render", {}, "", "id"}},
  };
}

// ---- what comes back ------------------------------------------------------------------------

struct Outcome {
  std::optional<Response> response;  ///< none: there was no memory even for a problem
  bool was_short = false;
  long allocations = 0;
};

// In a thread of its own, which has nothing from calls before.
Outcome ask(Service& service, const Request& request, long n = never,
            Shortage shortage = Shortage::once) {
  Outcome outcome;
  std::thread([&] {
    run_out_of_memory(n, shortage);
    try {
      outcome.response = answer(request, service);
    } catch (const std::bad_alloc&) {
    }
    outcome.was_short = end_shortage();
    outcome.allocations = allocations();
  }).join();
  return outcome;
}

bool equal(const Response& a, const Response& b) {
  const auto body = [](const Response& of) { return of.shared ? *of.shared : of.body; };
  return a.status == b.status && a.content_type == b.content_type && body(a) == body(b);
}

class ScarceMemory : public testing::TestWithParam<Asked> {
 protected:
  // What is made once, for all requests or all failures, is made here.
  ScarceMemory() {
    const Compressor one, other, third;  // however many threads compress at once later
    right_ = *ask(Desk().service(), request_).response;
    EXPECT_EQ(right_.status, GetParam().status) << right_.body;
    for (const Shortage shortage : {Shortage::once, Shortage::lasting})
      ask(Desk().service(), request_, 1, shortage);
  }

  // Errors of what came back while the n-th allocation failed, and after that.
  void expect_right(long n, Shortage shortage) {
    Desk desk;
    const Outcome outcome = ask(desk.service(), request_, n, shortage);
    was_short_ = outcome.was_short;
    if (!outcome.response) {
      EXPECT_EQ(shortage, Shortage::lasting);
    } else if (!equal(*outcome.response, right_)) {
      EXPECT_TRUE(was_short_);
      EXPECT_EQ(outcome.response->status, 503) << outcome.response->body;
      EXPECT_EQ(problem_of(*outcome.response).type, "/problems/memory");
    }
    EXPECT_TRUE(equal(*ask(desk.service(), request_).response, right_));
  }

  void expect_nothing_left(long n, Shortage shortage) {
    const long before = live_pieces();
    expect_right(n, shortage);
    EXPECT_EQ(live_pieces(), before);
  }

  const Request request_ = GetParam().request;
  Response right_;
  bool was_short_ = false;
};

// Every one of the first thousands, then fewer and fewer; under a sanitizer, which takes ten times
// as long, a seventh of them.
long step() { return sanitized() ? 7 : 1; }

TEST_P(ScarceMemory, IsToldOrOvercomeAndForgotten) {
  const Silence silence;
  for (const Shortage shortage : {Shortage::once, Shortage::lasting}) {
    long n = 1;
    do {
      SCOPED_TRACE(n);
      expect_nothing_left(n, shortage);
      n += step() + n / 2000;
    } while (was_short_ && !HasFailure());
    RecordProperty(shortage == Shortage::once ? "once" : "lasting", static_cast<int>(n));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ScarceMemory, testing::ValuesIn(requests()), law_of);

}  // namespace
}  // namespace tia::test
