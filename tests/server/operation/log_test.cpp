// What the server tells its log and not its clients.
#include <httplib.h>

#include <fstream>
#include <sstream>

#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// A triangle, and two more without area: two corners at one place, and three on one line.
constexpr const char* flat_mesh = R"({"objects":[{"type":"mesh",
    "positions":[-1,-1,-5, 1,-1,-5, 0,1,-5, 0,0,-5],"indices":[0,1,2, 0,0,1, 2,3,3]}]})";
constexpr const char* ignored_triangles = "2 triangles without area are ignored";

const Value* logged(const Response& response) {
  return find(response.log, "triangles without area");
}

TEST(Log, CountsTheTrianglesWithoutAreaThatARequestLeavesOut) {
  Host host;
  const Response response =
      host.post("/render", R"({"width":8,"height":8,"scene":)" + std::string(flat_mesh) + "}");
  EXPECT_EQ(response.status, 200);
  ASSERT_NE(logged(response), nullptr);
  EXPECT_EQ(*logged(response), Value(2));
  for (const auto& [name, value] : response.headers) EXPECT_THAT(value, Not(HasSubstr("area")));
}

TEST(Log, SaysNothingOfAMeshWhoseTrianglesAllHaveArea) {
  Host host;
  EXPECT_EQ(logged(host.post("/render", R"({"width":8,"height":8,"scene":{"objects":[{"type":"mesh",
      "positions":[-1,-1,-5, 1,-1,-5, 0,1,-5],"indices":[0,1,2]}]}})")),
            nullptr);
}

// The lines that a server has written for requests, which it does a little later.
std::vector<Value> lines_of(const Tia& tia, std::size_t count) {
  std::vector<Value> lines;
  eventually([&] {
    lines.clear();
    std::istringstream all(tia.err());
    for (std::string line; std::getline(all, line) && !all.eof();)
      lines.push_back(parse_json(line));
    return lines.size() >= count;
  });
  return lines;
}

TEST(Log, HasOneJsonLineARequest) {
  Tia tia;
  auto client = tia.client();
  client.Get("/render?width=8&height=8", {{"X-Request-Id", "one"}});
  client.Post("/render", {{"X-Request-Id", "two"}}, "{}x", "application/json");
  client.Get("/nowhere", {{"X-Request-Id", "three"}});
  const std::vector<Value> lines = lines_of(tia, 3);
  ASSERT_EQ(lines.size(), 3U);
  const char* const ids[] = {"one", "two", "three"};
  const int status[] = {200, 400, 404};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(text_at(lines[i], "id"), ids[i]);
    EXPECT_EQ(number_at(lines[i], "status"), status[i]);
    EXPECT_EQ(text_at(lines[i], "peer"), "127.0.0.1");
    EXPECT_GT(number_at(lines[i], "answer_bytes"), 0);
    EXPECT_GE(number_at(lines[i], "us"), 0);
    EXPECT_THAT(text_at(lines[i], "time"), testing::MatchesRegex("20[0-9-]+T[0-9:.]+Z"));
  }
  EXPECT_EQ(text_at(lines[0], "target"), "/render?width=8&height=8");
  EXPECT_THAT(text_at(lines[0], "Server-Timing"), HasSubstr("queue;dur="));
  EXPECT_THAT(text_at(lines[0], "Tia-Rays"), HasSubstr("primary=64"));
  EXPECT_EQ(number_at(lines[1], "request_bytes"), 3);
  EXPECT_EQ(text_at(lines[1], "method"), "POST");
}

// W3C Trace Context: what a collector joins the lines of several servers by.
TEST(Log, TellsTheFirst200BytesOfATarget) {
  Tia tia;
  auto client = tia.client();
  const std::string target = "/" + std::string(199, 'a');
  for (const char* more : {"", "b"}) client.Get((target + more).c_str());
  const std::vector<Value> lines = lines_of(tia, 2);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(text_at(lines[0], "target"), target);
  EXPECT_EQ(text_at(lines[1], "target"), target);
}

TEST(Log, TellsWhichTraceARequestBelongsTo) {
  Tia tia;
  const std::string stem = "00-4bf92f3577b34da6a3ce929d0e0e4736-";
  const Response answer =
      plain("GET", "/healthz",
            tia.client().Get("/healthz", {{"traceparent", stem + "00f067aa0ba902b7-01"}}));
  tia.client().Get("/healthz", {{"traceparent", "00-forged\",\"id\":\"1\"-01"}});
  const std::vector<Value> lines = lines_of(tia, 2);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(text_at(lines[0], "trace_id"), stem.substr(3, 32));
  EXPECT_EQ(text_at(lines[0], "parent_id"), "00f067aa0ba902b7");
  EXPECT_EQ(header(answer, "traceparent"), stem + text_at(lines[0], "span_id") + "-01");
  EXPECT_EQ(find(*lines[1].as<Value::Object>(), "trace_id"), nullptr);
}

TEST(Log, NamesTheProblemThatWasToldOfUnreadableRequestsToo) {
  Tia tia;
  exchange(tia.port(), "hello there\r\n\r\n");
  exchange(tia.port(), "GET /" + std::string(5000, 'a') + " HTTP/1.1\r\nHost: x\r\n\r\n");
  exchange(tia.port(), "GET / HTTP/1.1\r\nHost: x\r\nX: " + std::string(20'000, 'a') + "\r\n\r\n");
  exchange(tia.port(), "POST / HTTP/1.1\r\nHost: x\r\n\r\n");
  tia.get("/nowhere");
  tia.get("/render?width=x");
  tia.get("/healthz");
  const std::vector<Value> lines = lines_of(tia, 7);
  ASSERT_EQ(lines.size(), 7U);
  const char* const problems[] = {"malformed",       "uri-too-long", "header-too-large",
                                  "length-required", "not-found",    "wrong-type"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(text_at(lines[i], "problem"), problems[i]);
  EXPECT_EQ(find(*lines[6].as<Value::Object>(), "problem"), nullptr);
}

TEST(Log, ARequestCannotForgeALine) {
  Tia tia;
  exchange(tia.port(), "GET /a%0d%0a\"}{\"id\":\"forged\"} HTTP/1.1\r\nHost: x\r\n\r\n");
  exchange(tia.port(), "GET /\"} HTTP/1.1\r\nHost: x\r\nX-Request-Id: \"x\r\n\r\n");
  for (const Value& line : lines_of(tia, 2)) EXPECT_NE(text_at(line, "id"), "forged");
  EXPECT_EQ(lines_of(tia, 2).size(), 2U);
}

TEST(Log, TiaRenderSaysItOnItsErrorOutput) {
  const Folder folder;
  std::ofstream(folder.file("flat.json")) << flat_mesh;
  const Finished end = run({"render", folder.file("flat.json"), "-o", folder.file("flat.png")});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, std::string("tia: ") + ignored_triangles + "\n");
}

}  // namespace
}  // namespace tia::test
