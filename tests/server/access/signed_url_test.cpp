// Signed URLs: what holds, what does not, until when, and what is left of them afterwards.
#include <algorithm>

#include "server/access/secrets.h"
#include "tests/server/access/access_support.h"

namespace tia::test {
namespace {

constexpr std::int64_t ends = 2'000'000'000;
constexpr const char* plain_target = "/render?key=a&width=8&height=8";

/// Signed: access by a key "owner" that K1 and K2 sign for, at a time that tests set.
struct Signed {
  KeyFiles files{entry_of("owner", "", R"("render")"),
                 "# comment\n\nK1 " + std::string(KeyFiles::hex) + " owner\nK2 " +
                     std::string(64, 'f') + " owner\n"};
  Metrics metrics;
  std::int64_t now = (ends - 100) * one_second;
  Access access{files.config, metrics, [this] { return now; }};
  const std::string target = signed_target(plain_target, "K1", KeyFiles::signing_secret(), ends);

  std::string why(const std::string& asked, const std::string& method = "GET",
                  const std::vector<Right>& needs = {Right::render}) {
    return refusal_of(access, {method, asked, {}, "", "id"}, needs);
  }
};

// RFC 4231, test case 2, and RFC 4648's alphabet.
TEST(AuthenticationCode, IsThatOfThePublishedVector) {
  EXPECT_EQ(authentication_code("Jefe", "what do ya want for nothing?"),
            "W9zBRr9gdU5qBCQmCJV1x1oAPwidJzmDnexYuWTsOEM");  // 5bdcc146 bf60754e 6a042426 …
  EXPECT_TRUE(same_secret("abc", "abc"));
  EXPECT_FALSE(same_secret("abc", "abd"));
  EXPECT_FALSE(same_secret("abc", "abcd"));
  EXPECT_NE(random_secret(), random_secret());
  EXPECT_EQ(random_secret().size(), 43U);
}

TEST(SignedUrl, HoldsForGetAndHeadAndLeavesThePlainTarget) {
  Signed by;
  for (const char* method : {"GET", "HEAD"}) {
    Request request{method, by.target, {}, "", "id"};
    by.access.identify(request);
    EXPECT_EQ(request.target, plain_target);
    EXPECT_EQ(request.key, "owner");
    EXPECT_NO_THROW(by.access.admit(request, {Right::render}));
  }
  EXPECT_EQ(by.why(signed_target("/render", "K2", std::string(32, '\xff'), ends)), "");
}

TEST(SignedUrl, EverySingleFlippedBitIsRefused) {
  Signed by;
  ASSERT_EQ(by.why(by.target), "");
  for (std::size_t at = 0; at < by.target.size(); ++at)
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string flipped = by.target;
      flipped[at] = static_cast<char>(static_cast<unsigned char>(flipped[at]) ^ (1U << bit));
      EXPECT_NE(by.why(flipped), "") << flipped;
    }
}

TEST(SignedUrl, EveryOtherOrderIsRefusedAndLeavesNothingOfIt) {
  Signed by;
  const std::string code = by.target.substr(by.target.find("&sig=") + 5);
  std::vector<std::string> parts{"exp=" + std::to_string(ends), "kid=K1", "sig=" + code, "key=a",
                                 "width=8&height=8"};
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  int held = 0;
  do {
    std::string target = "/render?";
    for (const std::size_t i : order) target += (target.ends_with('?') ? "" : "&") + parts[i];
    const bool holds = order == std::vector<std::size_t>{3, 4, 0, 1, 2};
    EXPECT_EQ(by.why(target).empty(), holds) << target;
    held += holds ? 1 : 0;
    Request request{"GET", target, {}, "", "id"};
    by.access.identify(request);
    EXPECT_THAT(request.target, testing::Not(testing::HasSubstr(code)));
    EXPECT_THAT(request.target, testing::Not(testing::HasSubstr("exp=")));
  } while (std::ranges::next_permutation(order).found);
  EXPECT_EQ(held, 1);
}

TEST(SignedUrl, WithAnythingMoreIsRefused) {
  Signed by;
  const std::string code = by.target.substr(by.target.find("&sig=") + 5);
  const std::string end = by.target.substr(by.target.find("&exp="));
  for (const std::string& target :
       {by.target + "&sig=" + code, by.target + "&width=9", by.target + "&", by.target + "=",
        "/render?sig=x&" + by.target.substr(8), "/render?exp=1&" + by.target.substr(8),
        "/render?%73ig=" + code, "/render?s%69g=" + code + end, by.target + "&%6bid=K2",
        "/render" + std::string("?") + end.substr(1), std::string("/render?sig="),
        std::string("/render?sig")}) {
    EXPECT_NE(by.why(target), "") << target;
    Request request{"GET", target, {}, "", "id"};
    by.access.identify(request);
    EXPECT_THAT(request.target, testing::Not(testing::HasSubstr(code))) << target;
  }
}

TEST(SignedUrl, IsForItsPathMethodAndRightsAlone) {
  Signed by;
  for (const char* method : {"POST", "DELETE", "PUT", "get"})
    EXPECT_EQ(by.why(by.target, method), "method") << method;
  for (const char* path : {"/film", "/still", "/Render", "/render/", "//render"})
    EXPECT_EQ(by.why(path + by.target.substr(7)), "signature") << path;
  EXPECT_EQ(by.why("http://other.example" + by.target), "signature");
  EXPECT_EQ(by.why(by.target, "GET", {Right::scenes}), "right");
  const std::string unknown = signed_target("/render", "K3", KeyFiles::signing_secret(), ends);
  EXPECT_EQ(by.why(unknown), "unknown");
}

TEST(SignedUrl, EndsAtItsSecond) {
  Signed by;
  by.now = ends * one_second - 1;
  EXPECT_EQ(by.why(by.target), "");
  by.now = ends * one_second;
  EXPECT_EQ(by.why(by.target), "expired");
  const std::string flipped = by.target.substr(0, by.target.size() - 1) + "!";
  EXPECT_EQ(by.why(flipped), "signature");  // of what is not signed nothing is told
}

TEST(SignedUrl, IsPublicUntilItEndsAndAKeysAnswerIsPrivate) {
  Signed by;
  const auto control = [&](Request request, const std::string& told, int status = 200) {
    by.access.identify(request);
    Response response{.status = status, .content_type = "image/png", .body = ""};
    if (!told.empty()) response.headers = {{"Cache-Control", told}};
    by.access.tell(response, request);
    return header(response, "Cache-Control").value_or("");
  };
  const Request by_url{"GET", by.target, {}, "", "id"}, by_key = asking_as("owner", "/render"),
                                                        by_none{"GET", "/render", {}, "", "id"};
  const std::string for_good = "public, max-age=31536000, immutable";
  EXPECT_EQ(control(by_url, for_good), "public, max-age=100");
  EXPECT_EQ(control(by_url, "no-cache"), "public, max-age=100");
  EXPECT_EQ(control(by_url, ""), "public, max-age=100");
  EXPECT_EQ(control(by_key, for_good), "private, max-age=31536000, immutable");
  EXPECT_EQ(control(by_key, "no-cache"), "private, no-cache");
  EXPECT_EQ(control(by_key, ""), "private");
  EXPECT_EQ(control(by_none, for_good), for_good);
  for (const Request& each : {by_url, by_key, by_none})
    EXPECT_EQ(control(each, "no-store"), "no-store");
}

// Its answer is that of the plain target: bytes, tag, addresses.
TEST(SignedUrl, EntersNoRecipeTagOrAddress) {
  Signed by;
  Host host(by.files.config);
  const std::string target =
      "/render?key=a&width=8&height=8&max_rays=100000&samples=2&scene="
      "shapes&integrator=path";
  const std::string at_length =
      signed_target(target, "K1", KeyFiles::signing_secret(), system_time() / one_second + 60);
  const Response plain = ask_through(host, asking_as("owner", target));
  const Response signed_one = ask_through(host, {"GET", at_length, {}, "", Host::id});
  ASSERT_EQ(signed_one.status, 200);
  EXPECT_EQ(signed_one.body, plain.body);
  for (const char* name : {"ETag", "Content-Location", "Tia-Rays"})
    EXPECT_EQ(header(signed_one, name), header(plain, name)) << name;
  for (const auto& [name, value] : signed_one.headers)
    EXPECT_THAT(value, testing::Not(testing::HasSubstr("sig="))) << name;
  EXPECT_THAT(*header(signed_one, "Cache-Control"),
              testing::MatchesRegex("public, max-age=(60|59)"));
}

// What one thread takes for it, by the processor's time.
TEST(AccessTime, OfAKeyOrASignatureIsAtMost20Microseconds) {
  Signed by;
  const int checks = test::rounds(4000, 40);
  const auto took_us = [&](const Request& asked) {
    const std::clock_t start = std::clock();
    for (int i = 0; i < checks; ++i) {
      Request request = asked;
      by.access.identify(request);
      by.access.admit(request, {Right::render});
    }
    return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / checks;
  };
  const double key = took_us(asking_as("owner", plain_target)),
               url = took_us({"GET", by.target, {}, "", "id"});
  RecordProperty("key_us", std::to_string(key));
  RecordProperty("signature_us", std::to_string(url));
  if (sanitized()) return;
  EXPECT_LE(key, 20);
  EXPECT_LE(url, 20);
}

}  // namespace
}  // namespace tia::test
