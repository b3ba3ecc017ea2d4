// Quotas: how many requests and rays a key has, and what is told of it.
#include "server/access/quotas.h"

#include <random>
#include <thread>

#include "tests/server/access/access_support.h"

namespace tia::test {
namespace {

// A bucket that holds `burst` tokens, filled by one each interval, told by what is in it. Source:
// Tanenbaum and Wetherall, Computer Networks (2011), 5.4.2 (token bucket).
struct TokenBucket {
  RequestRate rate;
  std::int64_t held = rate.refill(), at = 0;  // held: in shares of a token that an interval has

  bool take(std::int64_t now) {
    held = std::min(rate.refill(), held + (now - at));
    at = now;
    if (held < rate.interval) return false;
    held -= rate.interval;
    return true;
  }
};

class BucketLaw : public testing::TestWithParam<unsigned> {};

TEST_P(BucketLaw, TakesWhatABucketOfTokensTakesAndNeverMoreThanRateTimesTimePlusBurst) {
  std::mt19937_64 chance(GetParam());
  const double per_second = std::exp(std::uniform_real_distribution(-3.0, 8.0)(chance));
  const auto burst = std::uniform_int_distribution<std::int64_t>(1, 20)(chance);
  const RequestRate rate = RequestRate::of(per_second, burst);
  OwnQuotas quotas;
  std::int64_t now = 1'000'000 * one_second;
  TokenBucket bucket{rate};
  bucket.at = now;
  std::vector<std::int64_t> taken;
  for (int i = 0; i < 1000; ++i) {
    if (chance() % 3 != 0)
      now += static_cast<std::int64_t>(chance() % static_cast<std::uint64_t>(2 * rate.interval));
    if (chance() % 200 == 0) now += rate.refill();
    const RequestsLeft before = quotas.look("a", rate, now);
    const RequestsLeft is = quotas.take("a", rate, now);
    ASSERT_EQ(is.is_taken, bucket.take(now));
    ASSERT_EQ(is.left, bucket.held / rate.interval);
    ASSERT_EQ(is.to_full, rate.refill() - bucket.held);
    ASSERT_EQ(before.wait, is.is_taken ? 0 : rate.interval - bucket.held);
    if (is.is_taken) taken.push_back(now);
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    for (std::size_t k = i; k < taken.size(); ++k)
      ASSERT_LE(static_cast<double>(k - i + 1),
                per_second * static_cast<double>(taken[k] - taken[i]) / one_second +
                    static_cast<double>(burst) + 1e-9);
  EXPECT_GT(taken.size(), 10U);
}
INSTANTIATE_TEST_SUITE_P(ByChance, BucketLaw, testing::Range(1U, 9U));

TEST(Quotas, AClockThatGoesBackEmptiesTheBucketAndNoMore) {
  OwnQuotas quotas;
  const RequestRate rate = RequestRate::of(1, 3);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(quotas.take("a", rate, 1000 * one_second).is_taken);
  const RequestsLeft after = quotas.take("a", rate, 10 * one_second);
  EXPECT_FALSE(after.is_taken);
  EXPECT_EQ(after.wait, one_second);
  EXPECT_TRUE(quotas.take("a", rate, 11 * one_second + after.wait).is_taken);
}

TEST(Quotas, AreAKeysOwn) {
  OwnQuotas quotas;
  const RequestRate rate = RequestRate::of(1, 1);
  EXPECT_TRUE(quotas.take("a", rate, one_second).is_taken);
  EXPECT_FALSE(quotas.take("a", rate, one_second).is_taken);
  EXPECT_TRUE(quotas.take("b", rate, one_second).is_taken);
}

TEST(Quotas, OfRaysBeginAnewAtMidnightUtc) {
  const KeyFiles files(entry_of("a", R"("rays_per_day":1000)"));
  Metrics metrics;
  std::int64_t now = (20'000 * std::int64_t{86'400} + 86'399) * one_second;
  Access access(files.config, metrics, [&] { return now; });
  access.charge("a", 400);
  EXPECT_NO_THROW(access.check_rays("a", 600));
  try {
    access.check_rays("a", 601);
    ADD_FAILURE() << "too many";
  } catch (const AccessRefusal& refusal) {
    EXPECT_EQ(refusal.type(), "quota");
    EXPECT_EQ(refusal.headers().front(), (std::pair<std::string, std::string>{"Retry-After", "1"}));
  }
  access.charge("a", 5000);  // what was under way
  EXPECT_THROW(access.check_rays("a", 1), AccessRefusal);
  EXPECT_NO_THROW(access.check_rays("a", 0));
  now += one_second;
  EXPECT_NO_THROW(access.check_rays("a", 1000));
}

std::int64_t rays_in(const Response& response) {
  std::int64_t sum = 0;
  std::istringstream list(*header(response, "Tia-Rays"));
  for (std::string each; std::getline(list >> std::ws, each, ',');)
    if (!each.starts_with("cut=")) sum += std::stoll(each.substr(each.find('=') + 1));
  return sum;
}

bool was_drawn(const Response& response) {
  const std::string status = header(response, "Cache-Status").value_or("");
  return status.find("fwd=") != status.npos && status.find("collapsed") == status.npos;
}

// Eight clients at once, by two keys, of whom several ask for the same at the same time.
TEST(Quotas, ChargeTheRaysOfDrawnAnswersExactly) {
  const KeyFiles files(entry_of("a", R"("rays_per_day":1000000000)") + "," + entry_of("b"));
  Host host(files.config);
  std::map<std::string, std::atomic<std::int64_t>> told;
  told["a"] = told["b"] = 0;
  std::atomic<int> drawn = 0, others = 0;
  {
    std::vector<std::jthread> clients;
    for (int client = 0; client < 8; ++client)
      clients.emplace_back([&, client] {
        const std::string id = client % 2 == 0 ? "a" : "b";
        for (int i = 0; i < test::rounds(8, 4); ++i) {
          const Response response = ask_through(
              host, asking_as(id, "/render?key=a&width=64&height=48&seed=" + std::to_string(i)));
          ASSERT_EQ(response.status, 200);
          (was_drawn(response) ? drawn : others)++;
          if (was_drawn(response)) told[id] += rays_in(response);
        }
      });
  }
  EXPECT_EQ(drawn, test::rounds(8, 4));
  EXPECT_EQ(others, 7 * test::rounds(8, 4));
  const Response metrics = ask_through(host, asking_as("b", "/metrics"));
  const auto series = series_of(metrics.body);
  for (const std::string id : {"a", "b"}) {
    const auto found = series.find(R"(tia_key_rays_total{key=")" + id + "\"}");
    EXPECT_EQ(found == series.end() ? 0 : found->second, static_cast<double>(told[id])) << id;
  }
  const Response last =
      ask_through(host, asking_as("a", "/render?key=a&width=64&height=48&seed=0"));
  EXPECT_THAT(*header(last, "RateLimit"),
              testing::StartsWith("\"rays\";r=" + std::to_string(1'000'000'000 - told["a"])));
  EXPECT_EQ(header(last, "RateLimit-Policy"), "\"rays\";q=1000000000;w=86400");
}

TEST(Quotas, RefuseWhatIsForeseenToTakeMoreRaysThanAreLeftAndNoPictureThatIsKept) {
  const KeyFiles files(entry_of("a", R"("rays_per_day":4000)", R"("render")"));
  Host host(files.config);
  const auto ask = [&](const std::string& query) {
    return ask_through(host, asking_as("a", "/render?width=40&height=40&" + query));
  };
  const Response first = ask("key=a");
  ASSERT_EQ(first.status, 200);
  ASSERT_GT(rays_in(first), 2400);  // so that another 1600 from the eye are too many
  for (const char* target : {"samples=4&seed=1", "key=d", "key=d&stream=events"}) {
    const Response response = ask(target);
    if (response.parts) {  // what stands in its way is told at the first part
      EXPECT_THROW(response.parts({[](std::string_view) {}}), AccessRefusal);
      continue;
    }
    EXPECT_EQ(response.status, 429) << target;
    EXPECT_EQ(problem_of(response).type, "/problems/quota");
    EXPECT_LE(std::stol(*header(response, "Retry-After")), 86'400);
  }
  EXPECT_EQ(ask("key=a").status, 200);
  const Response film =
      ask_through(host, asking_as("a", "/film?scene=lamp-round&width=40&height=30&to=1"));
  EXPECT_EQ(film.status, 429);
}

TEST(Quotas, OfRequestsAreTold) {
  const KeyFiles files(entry_of("a", R"("requests_per_s":0.01,"burst":2)") + "," +
                       entry_of("anonymous", R"("requests_per_s":0.001)"));
  Host host(files.config);
  const std::string target = "/render?width=8&height=8";
  const Response first = ask_through(host, asking_as("a", target));
  EXPECT_EQ(header(first, "RateLimit-Policy"), "\"requests\";q=2;w=200");
  EXPECT_THAT(*header(first, "RateLimit"), testing::MatchesRegex("\"requests\";r=1;t=(100|99)"));
  EXPECT_EQ(ask_through(host, asking_as("a", "/healthz")).status, 200);  // which is not counted
  EXPECT_EQ(ask_through(host, asking_as("a", target)).status, 200);
  const Response refused = ask_through(host, asking_as("a", target));
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(problem_of(refused).type, "/problems/quota");
  EXPECT_THAT(*header(refused, "Retry-After"), testing::AnyOf("100", "99"));
  EXPECT_EQ(ask_through(host, asking_as("", target)).status, 200);
  EXPECT_EQ(ask_through(host, asking_as("", target)).status, 429);
}

// What is sent from memory is a request like others.
TEST(Quotas, CountWhatTheCacheAnswersAtOnce) {
  const KeyFiles files(entry_of("a", R"("requests_per_s":0.01,"burst":3)"));
  Host host(files.config);
  Request request = asking_as("a", "/render?width=8&height=8");
  host.service().access.identify(request);
  ASSERT_EQ(host.ask(request).status, 200);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(answer_from_memory(request, host.service()));
  EXPECT_FALSE(answer_from_memory(request, host.service()));
  EXPECT_EQ(host.ask(request).status, 429);
}

}  // namespace
}  // namespace tia::test
