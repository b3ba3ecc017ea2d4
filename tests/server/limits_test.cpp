// What a request may hold and how long a client may take, in the contract's own numbers: each limit
// is met and passed by one, and nothing here is computed from the constant that it pins. What would
// take seconds, or a hundred thousand requests, is named as it is.
#include "core/render/explanation_size.h"
#include "core/scene/read_scene.h"
#include "server/contract/problem.h"
#include "server/http/timeouts.h"
#include "server/operation/admission.h"
#include "server/operation/log.h"
#include "server/requests/recipe.h"
#include "server/stores/known_targets.h"
#include "server/stores/scene_digest.h"
#include "server/stores/scene_file.h"
#include "server/stores/scene_store.h"
#include "tests/server/http/reader_support.h"
#include "tests/server/http/request_forms.h"
#include "tests/server/requests/recipe_support.h"

namespace tia::test {
namespace {

// ---- heads ----------------------------------------------------------------------------------

// The status with which a request is refused, or 0.
int refusal_of(const std::string& bytes) { return read_whole(bytes).status; }

TEST(LimitNumbers, AHeadHas16384Bytes) {
  const std::size_t rest = forms::get("X: \r\n").size();
  const auto head = [&](std::size_t size) {
    return forms::get("X: " + std::string(size - rest, 'a') + "\r\n");
  };
  EXPECT_EQ(refusal_of(head(16'384)), 0);
  EXPECT_EQ(refusal_of(head(16'385)), 431);
}

TEST(LimitNumbers, AHeadHas100Fields) {
  EXPECT_EQ(refusal_of(forms::get(forms::fields(99))), 0);  // and Host
  EXPECT_EQ(refusal_of(forms::get(forms::fields(100))), 431);
}

TEST(LimitNumbers, ATargetHas4096Bytes) {
  const std::string path = "/render?width=8&height=8";
  EXPECT_EQ(host().get(path + std::string(4096 - path.size(), '&')).status, 200);
  EXPECT_EQ(host().get(path + std::string(4097 - path.size(), '&')).status, 414);
}

// 64 bytes more than a target's, for the method and the version.
TEST(LimitNumbers, AFirstLineHas4160Bytes) {
  EXPECT_EQ(refusal_of(std::string(4160, 'A')), 0);
  EXPECT_EQ(refusal_of(std::string(4161, 'A')), 414);
}

TEST(LimitNumbers, ARequestsIdHas64Bytes) {
  EXPECT_EQ(request_id(std::string(64, 'a')), std::string(64, 'a'));
  EXPECT_NE(request_id(std::string(65, 'a')), std::string(65, 'a'));
}

// ---- chunks ---------------------------------------------------------------------------------

TEST(LimitNumbers, ALineOfAChunksSizeHas256Bytes) {
  const auto line = [](std::size_t size) {
    return forms::chunks("1;" + std::string(size - 4, 'a') + "\r\nx");
  };
  EXPECT_EQ(refusal_of(line(256)), 0);
  EXPECT_EQ(refusal_of(line(257)), 400);
}

TEST(LimitNumbers, ATrailerHas4096Bytes) {
  const auto trailer = [](std::size_t size) {  // from the last size's line end on
    return forms::chunks("0\r\nX: " + std::string(size - 9, 'a') + "\r\n\r\n");
  };
  EXPECT_EQ(refusal_of(trailer(4096)), 0);
  EXPECT_EQ(refusal_of(trailer(4097)), 431);
}

TEST(LimitNumbers, AChunkHas2To40Bytes) {
  const auto ends = [](std::string_view size) {
    std::string body;
    return ChunkDecoder({1LL << 41}).decode(size, body);
  };
  EXPECT_FALSE(ends("10000000000\r\n"));
  EXPECT_THROW(ends("10000000001\r\n"), HttpError);
}

// ---- admission ------------------------------------------------------------------------------

Cost cost_of(double rays) { return {Cost::usual_ray * rays, false}; }

// Whether no place of that many rays' kind is left, in a service where nobody waits.
bool is_full(Admission& admission, double rays) {
  try {
    [[maybe_unused]] const auto ticket = admission.enter(cost_of(rays), "a", {});
    return false;
  } catch (const HttpError&) {
    return true;
  }
}
constexpr double poster_rays = 1e9;

TEST(LimitNumbers, LightWorkHas2097152Rays) {
  Admission admission({.tickets = 4, .queue = 0});
  const auto one = admission.enter(cost_of(poster_rays), "a", {}),
             other = admission.enter(cost_of(poster_rays), "a", {});
  EXPECT_FALSE(is_full(admission, 2'097'152));
  EXPECT_TRUE(is_full(admission, 2'097'153));
}

TEST(LimitNumbers, LightWorkTurnsOutHeavyAfter2097152RaysOr33554432Tests) {
  const std::pair<std::int64_t, std::int64_t> beyond[] = {{2'097'153, 0}, {0, 33'554'433}};
  for (const auto& [rays, tests] : beyond) {
    Admission admission({.tickets = 4, .queue = 0});
    const auto heavy = admission.enter(cost_of(poster_rays), "a", {});
    auto picture = admission.enter(cost_of(1), "a", {});
    picture.has_done(2'097'152, 33'554'432);
    EXPECT_FALSE(is_full(admission, poster_rays));
    picture.has_done(rays, tests);
    EXPECT_TRUE(is_full(admission, poster_rays));
  }
}

TEST(LimitNumbers, AShortTextHas65536Bytes) {
  Admission admission({.tickets = 4, .queue = 0});
  const auto reading = admission.read(1 << 20, "a", {});
  EXPECT_NO_THROW([[maybe_unused]] const auto ticket = admission.read(65'536, "a", {}));
  EXPECT_THROW([[maybe_unused]] const auto ticket = admission.read(65'537, "a", {}), HttpError);
}

// ---- what is kept, and told -----------------------------------------------------------------

TEST(LimitNumbers, TenThousandScenesAreKept) {
  SceneStore store(1 << 30);
  Scene scene;
  std::string first, second;
  for (int i = 0; i <= 10'000; ++i) {
    EXPECT_EQ(store.count(), static_cast<std::size_t>(i));
    scene.title = std::to_string(i);
    (i == 0 ? first : second) = store.keep(scene);
  }
  EXPECT_EQ(store.count(), 10'000U);
  EXPECT_FALSE(store.find(first));
  EXPECT_TRUE(store.find(second));
}

// Whether the recipe of balls' picture tells the balls, whose names fill up their bytes.
bool is_told(std::size_t bytes) {
  constexpr std::size_t balls = 1500;
  const auto named = [](std::size_t size) {
    std::string list;
    for (std::size_t i = 0; i < balls; ++i)
      list += R"(,{"type":"sphere","center":[0,0,-9],"radius":1,"name":")" +
              std::string(size / balls + (i < size % balls ? 1 : 0), 'n') + "\"}";
    return R"({"objects":[)" + list.substr(1) + "]}";
  };
  const std::size_t others = digest_of_objects(read_scene(named(balls))).all.bytes - balls;
  const std::string scene = named(bytes - others);
  EXPECT_EQ(digest_of_objects(read_scene(scene)).all.bytes, bytes);
  const Response drawn = host().post("/render", R"({"width":8,"height":8,"scene":)" + scene + "}");
  EXPECT_EQ(drawn.status, 200);
  return recipe_text(drawn.body).find("sha256:") == std::string::npos;
}

TEST(LimitNumbers, ARecipeTells262144BytesOfObjects) {
  EXPECT_TRUE(is_told(262'144));
  EXPECT_FALSE(is_told(262'145));
}

// ---- what is answered -----------------------------------------------------------------------

TEST(LimitNumbers, AProblemsDetailHas2048Bytes) {
  const auto detail = [](std::size_t size) {
    const auto failed = failure("busy", std::string(size, 'd'));
    return problem_of(problem_response(failed, {"GET", "/", {}, "", Host::id})).detail;
  };
  EXPECT_EQ(detail(2048), std::string(2048, 'd'));
  EXPECT_NE(detail(2049), std::string(2049, 'd'));
}

TEST(LimitNumbers, OfWhatIsAnsweredAndKept) {
  EXPECT_EQ(longest_problem, 16'384U);
  EXPECT_EQ(longest_explanation, 4'194'304U);
  EXPECT_EQ(most_owners, 64);
  EXPECT_EQ(KnownTargets::most_bytes, 4'194'304U);
  EXPECT_EQ(CostMemory::most_scenes, 4096U);
}

// ---- timeouts -------------------------------------------------------------------------------

TEST(LimitNumbers, OfTimeouts) {
  using namespace std::chrono;
  EXPECT_EQ(timeouts::head, milliseconds(5000));
  EXPECT_EQ(timeouts::body, milliseconds(5000));
  EXPECT_EQ(timeouts::answer, milliseconds(8000));
  EXPECT_EQ(timeouts::idle, milliseconds(30'000));
  EXPECT_EQ(timeouts::linger, milliseconds(2000));
  EXPECT_EQ(timeouts::stuck, milliseconds(1000));
  EXPECT_EQ(timeouts::rest, milliseconds(1000));
  EXPECT_EQ(timeouts::drained, milliseconds(250));
  EXPECT_EQ(timeouts::memory, milliseconds(1));
  EXPECT_EQ(MemoryAccount::most_wait, milliseconds(2000));
  EXPECT_EQ(timeouts::slowest_rate, 65'536U);
  EXPECT_EQ(timeouts::at_slowest_rate(1 << 20), milliseconds(16'000));
}

TEST(LimitNumbers, OfAConnection) {
  EXPECT_EQ(timeouts::most_requests, 100'000U);
  EXPECT_EQ(timeouts::most_ahead, 65'536U);
  EXPECT_EQ(timeouts::most_at_once, 262'144U);
  EXPECT_EQ(timeouts::most_parts, 262'144U);
  EXPECT_EQ(Log::most_bytes, 1'048'576U);
}

}  // namespace
}  // namespace tia::test
