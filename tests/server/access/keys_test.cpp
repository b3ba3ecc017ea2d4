// Keys: their file, what each may do, who is refused and how.
#include <set>

#include "server/handlers/route_table.h"
#include "tests/server/access/access_support.h"
#include "tests/server/contract/openapi_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// ---- the file -------------------------------------------------------------------------------

TEST(KeyFile, IsReadWhole) {
  const auto keys = read_keys("[" + entry_of("a", R"("requests_per_s":0.5,"burst":7,
      "rays_per_day":1000000000000,"jobs":3,"kept_bytes":0,"priority":"high",
      "expires":"2024-02-29T23:59:59Z")") +
                              "," + entry_of("anonymous", "", "") + "]");
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].id.text, "a");
  EXPECT_EQ(keys[0].may, (std::vector{Right::render, Right::scenes, Right::metrics}));
  EXPECT_EQ(keys[0].requests_per_s, 0.5);
  EXPECT_EQ(keys[0].burst, 7);
  EXPECT_EQ(keys[0].rays_per_day, 1'000'000'000'000);
  EXPECT_EQ(keys[0].jobs, 3);
  EXPECT_EQ(keys[0].kept_bytes, 0);
  EXPECT_EQ(keys[0].priority, KeyPriority::high);
  EXPECT_EQ(keys[0].expires->seconds, 1'709'251'199);  // date -d 2024-02-29T23:59:59Z +%s
  EXPECT_TRUE(keys[1].is_anonymous() && keys[1].may.empty());
}

std::string fault_of(const std::string& json) {
  try {
    read_keys(json);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(KeyFile, FaultsAreToldByTheirPlace) {
  const std::string good = entry_of("a");
  const std::pair<std::string, const char*> faulty[] = {
      {"{}", "an array"},
      {"[", "malformed"},
      {"[" + good + "," + entry_of("b", R"("rays":5)") + "]", "/1/rays"},
      {"[" + good + "," + good + "]", "/1/id"},
      {"[" + entry_of("a.b") + "]", "/0/id"},
      {"[" + entry_of("other") + "]", "/0/id"},
      {R"([{"may":[],"sha256":")" + std::string(64, '0') + "\"}]", "/0/id"},
      {R"([{"id":"a","may":[]}])", "/0/sha256"},
      {R"([{"id":"a","may":[],"sha256":"hidden-secret"}])", "/0/sha256"},
      {R"([{"id":"anonymous","may":[],"sha256":")" + std::string(64, '0') + "\"}]", "/0/sha256"},
      {"[" + entry_of("a", "", R"("render","rendr")") + "]", "/0/may/1"},
      {"[" + entry_of("a", R"("burst":5)") + "]", "/0/burst"},
      {"[" + entry_of("a", R"("requests_per_s":0)") + "]", "/0/requests_per_s"},
      {"[" + entry_of("a", R"("rays_per_day":1.5)") + "]", "/0/rays_per_day"},
      {"[" + entry_of("a", R"("expires":"2023-02-29T00:00:00Z")") + "]", "/0/expires"},
      {"[" + entry_of("a", R"("expires":"2024-02-28T24:00:00Z")") + "]", "/0/expires"},
  };
  for (const auto& [json, place] : faulty) {
    const std::string fault = fault_of(json);
    if (std::string_view(place) != "malformed") EXPECT_THAT(fault, HasSubstr(place)) << json;
    EXPECT_NE(fault, "") << json;
    EXPECT_THAT(fault, testing::Not(HasSubstr("hidden-secret")));
  }
}

TEST(SigningFile, FaultsAreToldByTheirLineAndNoSecretIs) {
  const std::string hex(KeyFiles::hex);
  for (const std::string& line :
       {std::string("K1"), "K1 " + hex, "K1 " + hex + " a b", "K1 " + hex.substr(1) + " a",
        "K1 " + hex.substr(2) + " a", "K1 " + hex + "zz a", "K! " + hex + " a",
        "K1 " + hex + " a.b", "K0 " + hex + " a"}) {
    try {
      read_signing_keys("# first\nK0 " + hex + " a\r\n" + line + "\n");
      ADD_FAILURE() << line;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("line 3: "));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr(hex.substr(2, 30))));
    }
  }
}

TEST(SigningFile, NamesKeysThatThereAre) {
  const auto fault = [](const KeyFiles& files) {
    try {
      KeyRing ring(files.config);
      return std::string();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  const std::string line = "K1 " + std::string(KeyFiles::hex) + " b\n";
  EXPECT_THAT(fault(KeyFiles(entry_of("a"), line)), HasSubstr("allowed: an id of TIA_KEYS_FILE"));
  EXPECT_EQ(fault(KeyFiles(entry_of("b"), line)), "");
  KeyFiles alone(entry_of("b"), line);
  alone.config.keys_file = "";
  EXPECT_THAT(fault(alone), HasSubstr("none without TIA_KEYS_FILE"));
}

// ---- who may --------------------------------------------------------------------------------

TEST(Keys, OfEachRightOpenItsRoutesAndNoOthers) {
  std::string entries;
  for (const std::string_view right : Names<Right>::names)
    entries += (entries.empty() ? "" : ",") +
               entry_of("k-" + std::string(right), "", '"' + std::string(right) + '"');
  const KeyFiles files(entries);
  Metrics metrics;
  Access access(files.config, metrics);
  for (const Route& route : routes())
    for (std::size_t i = 0; i < Names<Right>::names.size(); ++i) {
      const std::string id = "k-" + std::string(Names<Right>::names[i]);
      const bool may = std::ranges::all_of(
          route.rights, [&](Right each) { return static_cast<std::size_t>(each) == i; });
      EXPECT_EQ(refusal_of(access, asking_as(id, "/"), route.rights), may ? "" : "right")
          << route.name;
    }
}

// What tells nothing of anybody's, and the page itself, which keys are entered in.
TEST(Keys, AreNeededForAllButWhatIsAnybodys) {
  const std::set<std::string_view> open{"get_health",  "get_ready",   "get_version",
                                        "get_openapi", "get_problem", "get_scene_schema",
                                        "get_docs",    "get_page"};
  const KeyFiles files("");
  Host host(files.config);
  for (const Route& route : routes()) {
    const bool is_page = route.name.starts_with("get_page_file");
    EXPECT_EQ(route.rights.empty(), open.contains(route.name) || is_page) << route.name;
    for (const std::string_view target : route.examples)
      EXPECT_EQ(ask_through(host, asking_as("", std::string(target))).status == 401,
                !route.rights.empty());
  }
}

TEST(Keys, AreToldOfInTheDocument) {
  for (const Route& route : routes()) {
    const Value* security = find(as_object(operation(std::string(route.name))), "security");
    ASSERT_EQ(security != nullptr, !route.rights.empty()) << route.name;
    if (security == nullptr) continue;
    Value::Array rights;
    for (const Right right : route.rights) rights.emplace_back(name_of(right));
    const auto& ways = as_array(*security);
    ASSERT_EQ(ways.size(), route.method == "GET" ? 3U : 2U);
    EXPECT_EQ(at(ways.front(), "key"), Value(rights));
    if (ways.size() == 3) EXPECT_EQ(at(ways[1], "sig"), Value(rights));
    EXPECT_TRUE(as_object(ways.back()).empty());
  }
  for (const char* scheme : {"key", "exp", "kid", "sig"})
    EXPECT_FALSE(text_at(component("securitySchemes", scheme), "description").empty());
}

TEST(Keys, ThatDoNotHoldAreUnauthorized) {
  const KeyFiles files(entry_of("a") + "," +
                       entry_of("old", R"("expires":"2020-01-01T00:00:00Z")") + "," +
                       entry_of("anonymous"));
  Host host(files.config);
  const std::string good = secret_of("a");
  const std::pair<std::string, const char*> tokens[] = {{"a." + good + "x", "secret"},
                                                        {"a.", "secret"},
                                                        {"b." + good, "unknown"},
                                                        {"a" + good, "form"},
                                                        {"", "form"},
                                                        {"." + good, "unknown"},
                                                        {"A." + good, "unknown"},
                                                        {"anonymous.", "unknown"},
                                                        {"old." + secret_of("old"), "expired"}};
  for (const auto& [token, why] : tokens) {
    Request request{"GET", "/scenes", {{"Authorization", "Bearer " + token}}, "", Host::id};
    EXPECT_EQ(refusal_of(host.service().access, request), why) << token;
    const Response response = ask_through(host, request);
    EXPECT_EQ(response.status, 401) << token;
    EXPECT_EQ(problem_of(response).type, "/problems/unauthorized");
    EXPECT_EQ(header(response, "WWW-Authenticate"),
              "Bearer realm=\"tia\", error=\"invalid_token\"");
    EXPECT_THAT(response.body, testing::Not(HasSubstr(good)));
    request.target = "/healthz";
    EXPECT_EQ(ask_through(host, request).status, 200);
  }
  for (const char* word : {"bearer ", "BEARER ", "Bearer  "}) {
    const Request request{
        "GET", "/scenes", {{"Authorization", word + ("a." + good)}}, "", Host::id};
    EXPECT_EQ(ask_through(host, request).status, 200) << word;
  }
  const Request basic{"GET", "/scenes", {{"Authorization", "Basic YTpi"}}, "", Host::id};
  EXPECT_EQ(ask_through(host, basic).status, 200);  // a proxy's, and no key
}

TEST(Keys, WithoutTheRightAreForbidden) {
  const KeyFiles files(entry_of("a", "", R"("scenes")"));
  Host host(files.config);
  const Response refused = ask_through(host, asking_as("a", "/render"));
  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(problem_of(refused).type, "/problems/forbidden");
  EXPECT_THAT(problem_of(refused).detail, HasSubstr("render"));
  const Response unknown = ask_through(host, asking_as("", "/scenes"));
  EXPECT_EQ(unknown.status, 401);
  EXPECT_EQ(header(unknown, "WWW-Authenticate"), "Bearer realm=\"tia\"");
}

TEST(Keys, AreNotAskedForWithoutAFileButForWhatIsForAdmin) {
  Metrics metrics;
  const Config config;
  Access access(config, metrics);
  for (const Right right :
       {Right::render, Right::explain, Right::scenes, Right::models, Right::jobs, Right::metrics})
    EXPECT_EQ(refusal_of(access, asking_as("a", "/"), {right}), "");
  EXPECT_EQ(refusal_of(access, asking_as("a", "/"), {Right::admin}), "none");
}

TEST(Keys, HaveMetricsOfTheirOwnUpToAHundred) {
  Metrics metrics;
  for (int i = 0; i < 150; ++i) {
    const std::string key = "k" + std::to_string(i);
    metrics.count_rays_of(key, 10);
    metrics.count_refusal(key, "right");
  }
  const auto series = series_of(metrics.text({}));
  EXPECT_EQ(series.at(R"(tia_key_rays_total{key="k99"})"), 10);
  EXPECT_EQ(series.at(R"(tia_key_rays_total{key="other"})"), 500);
  EXPECT_EQ(series.at(R"(tia_key_refusals_total{key="other"})"), 50);
  EXPECT_EQ(series.at(R"(tia_keys_refused_total{why="right"})"), 150);
  EXPECT_EQ(
      std::ranges::count_if(
          series, [](const auto& each) { return each.first.starts_with("tia_key_rays_total"); }),
      102);
}

// ---- the program ----------------------------------------------------------------------------

std::string line_of(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(lines, line);
  return line;
}

int status_with(const Tia& tia, const std::string& token, const std::string& target) {
  const std::string field = token.empty() ? "" : "Authorization: Bearer " + token + "\r\n";
  return exchange(tia.port(), "GET " + target + " HTTP/1.1\r\nHost: x\r\n" + field + "\r\n").status;
}

// From the making of a key and a URL to the log, which knows ids and no secret.
TEST(KeysOfTheProgram, ServeWhoHasThemAndAreReadAnew) {
  const Finished made = run({"key", "alice"}), other = run({"key", "bob"});
  const std::string token = line_of(made.out, 1), entry = line_of(made.out, 2);
  ASSERT_TRUE(token.starts_with("alice.")) << made.err;
  const KeyFiles files(entry, "K1 " + std::string(KeyFiles::hex) + " alice\n");
  const Process::Words options{
      "--port", "0", "--keys-file", files.config.keys_file, "--sign-file", files.config.sign_file};
  const Tia tia(options);
  const std::string target = "/render?width=8&height=8";
  EXPECT_EQ(status_with(tia, token, target), 200);
  EXPECT_EQ(status_with(tia, token + "x", target), 401);
  EXPECT_EQ(status_with(tia, "", target), 401);
  const Finished signing =
      run({"sign", "http://x" + target, "--for", "60", "--sign-file", files.config.sign_file});
  const std::string url = line_of(signing.out, 1);
  ASSERT_TRUE(url.starts_with("http://x" + target + "&exp=")) << signing.err;
  const std::string code = url.substr(url.find("&sig=") + 5);
  EXPECT_EQ(status_with(tia, "", url.substr(8)), 200);
  EXPECT_EQ(status_with(tia, "", url.substr(8) + "x"), 401);
  exchange(tia.port(), "GET " + url.substr(8) + " HTTP/1.1\r\nHost: x\r\nBad header\r\n\r\n");

  const std::string next = line_of(other.out, 1);
  EXPECT_EQ(status_with(tia, next, target), 401);
  files.write("keys.json", "[{}]");
  const auto told = [&](const char* text) {
    ::kill(tia.pid(), SIGHUP);
    return eventually([&] { return tia.err().find(text) != std::string::npos; });
  };
  EXPECT_TRUE(told("/0/id"));  // a faulty file changes nothing
  EXPECT_EQ(status_with(tia, token, target), 200);
  files.write("keys.json", "[" + entry + "," + line_of(other.out, 2) + "]");
  EXPECT_TRUE(told("read anew"));
  EXPECT_EQ(status_with(tia, next, target), 200);
  EXPECT_TRUE(eventually([&] { return tia.err().find(R"("key":"bob")") != std::string::npos; }));
  const std::string log = tia.err();
  EXPECT_THAT(log, HasSubstr(R"("key":"alice")"));
  for (const std::string& secret : {token.substr(6), next.substr(4), code, std::string("sig=")})
    EXPECT_THAT(log, testing::Not(HasSubstr(secret)));
}

TEST(KeysOfTheProgram, ThatAreFaultyEndTheStart) {
  const KeyFiles files(R"({"id":"a"})");
  const Finished end = run({"--port", "0", "--keys-file", files.config.keys_file});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("TIA_KEYS_FILE"));
  EXPECT_THAT(end.err, HasSubstr("/0/may"));
  EXPECT_EQ(run({"--port", "0", "--keys-file", files.folder.file("none")}).status, 2);
  EXPECT_EQ(run({"key", "a.b"}).status, 2);
  EXPECT_EQ(run({"sign", "/render"}).status, 2);
}

TEST(KeysOfTheProgram, OnAllAddressesWithoutAProxyAreWarnedOf) {
  const KeyFiles files(entry_of("a"));
  const Process::Words words{"--port",  "0",           "--host",
                             "0.0.0.0", "--keys-file", files.config.keys_file};
  EXPECT_THAT(Tia(words).err(), HasSubstr("TIA_TRUSTED_PROXIES"));
  Process::Words behind = words;
  behind.insert(behind.end(), {"--trusted-proxies", "10.0.0.1"});
  EXPECT_THAT(Tia(behind).err(), testing::Not(HasSubstr("TIA_TRUSTED_PROXIES")));
}

}  // namespace
}  // namespace tia::test
