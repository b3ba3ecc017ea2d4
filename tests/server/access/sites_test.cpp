// Who may ask what: names that the server answers to (DNS rebinding), and writes from other sites
// (Fetch Metadata Request Headers, W3C; OWASP's "Cross-Site Request Forgery Prevention").
#include "server/operation/config.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

Config with(std::vector<Setting> settings) { return read_config(settings); }

Host& on_loopback() {
  static Host shared(with({{"host", "127.0.0.1", ""}}));
  return shared;
}
Host& on_all() {
  static Host shared(with({{"host", "0.0.0.0", ""}}));
  return shared;
}

int status_as(Host& asked, const std::string& name, const std::string& target = "/version") {
  return asked.get(target, {{"Host", name}}).status;
}

TEST(Hosts, OfLoopbackAreItsOwnNames) {
  for (const char* name : {"localhost", "LocalHost:8080", "127.0.0.1", "127.0.0.1:9", "127.1.2.3",
                           "[::1]", "[::1]:8080"})
    EXPECT_EQ(status_as(on_loopback(), name), 200) << name;
  for (const char* name :
       {"rebound.example", "rebound.example:8080", "localhost.example", "10.0.0.1", "[::2]", "x"}) {
    const Response refused = on_loopback().get("/version", {{"Host", name}});
    EXPECT_EQ(refused.status, 421) << name;
    EXPECT_EQ(problem_of(refused).type, "/problems/misdirected");
    EXPECT_THAT(problem_of(refused).detail, testing::HasSubstr("TIA_HOSTS"));
  }
}

TEST(Hosts, OfLoopbackAreNoNamesThatBeginAsItsAddresses) {
  for (const char* name :
       {"127.evil.example", "127.0.0.1.evil.example", "127.0.0.1x", "127.", "127.0.0.1%x"})
    EXPECT_EQ(status_as(on_loopback(), name), 421) << name;
  EXPECT_EQ(status_as(on_loopback(), "127.9.8.7:80"), 200);
}

TEST(Hosts, OfAllAddressesAreAnyNames) { EXPECT_EQ(status_as(on_all(), "any.example"), 200); }

TEST(Hosts, AreThoseOfTheListWhereThereIsOne) {
  Host named(with({{"host", "0.0.0.0", ""}, {"hosts", "tia.example,10.0.0.7", ""}}));
  for (const char* name : {"tia.example", "TIA.example:443", "10.0.0.7:8080"})
    EXPECT_EQ(status_as(named, name), 200) << name;
  for (const char* name : {"localhost", "a.tia.example", "tia.example.b"})
    EXPECT_EQ(status_as(named, name), 421) << name;
  Host any(with({{"host", "127.0.0.1", ""}, {"hosts", "*", ""}}));
  EXPECT_EQ(status_as(any, "rebound.example"), 200);
}

TEST(Hosts, DoNotMatterToProbesWhichAskByAddress) {
  for (const char* probe : {"/healthz", "/readyz"})
    EXPECT_EQ(status_as(on_loopback(), "10.0.0.1:8080", probe), 200) << probe;
}

TEST(Hosts, AnExcerptOfALongNameIsTold) {
  const Response refused = on_loopback().get("/version", {{"Host", std::string(5000, 'x')}});
  EXPECT_EQ(refused.status, 421);
  EXPECT_LT(refused.body.size(), 1000U);
}

constexpr const char* written_scene = R"({"title":"written from afar"})";

int write_with(const Headers& headers, Host& asked = on_all()) {
  Headers all{{"Host", "tia.example"}, {"Content-Type", "application/json"}};
  all.insert(all.end(), headers.begin(), headers.end());
  const Response response = asked.ask("POST", "/scenes", written_scene, all);
  if (response.status == 403) {
    EXPECT_EQ(problem_of(response).type, "/problems/forbidden");
    EXPECT_THAT(problem_of(response).detail, testing::HasSubstr("TIA_CORS_ORIGINS"));
  }
  return response.status;
}

TEST(Writes, OfScriptsAndOfTheServersOwnPagesPass) {
  EXPECT_EQ(write_with({}), 201);
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "same-origin"}, {"Origin", "http://tia.example"}}), 201);
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "none"}}), 201);
  EXPECT_EQ(write_with({{"Origin", "http://tia.example"}}), 201);   // an older browser
  EXPECT_EQ(write_with({{"Origin", "https://Tia.example"}}), 201);  // a proxy has ended TLS
}

TEST(Writes, OfOtherSitesAreForbidden) {
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "cross-site"}, {"Origin", "https://evil.example"}}),
            403);
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "cross-site"}}), 403);
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "same-site"}, {"Origin", "http://b.tia.example"}}), 403);
  EXPECT_EQ(write_with({{"Origin", "https://evil.example"}}), 403);
  EXPECT_EQ(write_with({{"Origin", "http://tia.example:81"}}), 403);
  EXPECT_EQ(write_with({{"Origin", "null"}}), 403);  // a sandboxed frame
}

TEST(Writes, AreThoseOfEveryMethodButTheSafeOnes) {
  const Headers afar{{"Sec-Fetch-Site", "cross-site"}, {"Origin", "https://evil.example"}};
  for (const char* method : {"GET", "HEAD", "OPTIONS"})
    EXPECT_NE(on_all().ask(method, "/scenes", "", afar).status, 403) << method;
  for (const char* target : {"/render", "/explain", "/compare", "/verify", "/simulate", "/scenes"})
    EXPECT_EQ(on_all().ask("POST", target, "{}", afar).status, 403) << target;
  EXPECT_EQ(on_all().ask("DELETE", "/scenes/" + std::string(64, '0'), "", afar).status, 403);
}

TEST(Writes, OfOriginsThatCorsNamesPass) {
  Host sharing(with({{"hosts", "*", ""}, {"cors_origins", "https://a.example", ""}}));
  EXPECT_EQ(
      write_with({{"Sec-Fetch-Site", "cross-site"}, {"Origin", "https://a.example"}}, sharing),
      201);
  EXPECT_EQ(
      write_with({{"Sec-Fetch-Site", "cross-site"}, {"Origin", "https://b.example"}}, sharing),
      403);
  Host open(with({{"hosts", "*", ""}, {"cors_origins", "*", ""}}));
  EXPECT_EQ(write_with({{"Sec-Fetch-Site", "cross-site"}, {"Origin", "https://b.example"}}, open),
            201);
}

}  // namespace
}  // namespace tia::test
