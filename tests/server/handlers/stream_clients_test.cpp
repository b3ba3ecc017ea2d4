// Streams whose clients leave, are many, or ask for what there is not; and pictures by their tags.
#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <thread>

#include "tests/server/handlers/streams_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// From the request's last byte to the preview's, of a picture that takes seconds.
TEST(StreamsInTime, ShowAPreviewWithin100Ms) {
  double nearest = 1e9;
  for (int i = 0; i < 5 && nearest > 100; ++i) {
    Server server;
    Wire wire(server.port());
    const auto asked = Clock::now();
    const std::string first =
        begun(wire, "/render?scene=cornell-light&width=640&height=480&samples=4096&seed=" +
                        std::to_string(i) + "&stream=events");
    nearest = std::min(nearest, ms_since(asked));
    EXPECT_THAT(first, HasSubstr(R"("preview":true)"));
  }
  EXPECT_LT(nearest, sanitized() ? 2000 : 100);
}

TEST(StreamsInTime, ThatNobodyReadsAnyMoreEndWithin100Ms) {
  double nearest = 1e9;
  for (int i = 0; i < 5 && nearest > 100; ++i) {
    Server server;
    Wire wire(server.port());
    begun(wire, room(20 + i, 65536, "&stream=events"));
    EXPECT_EQ(at_work(server), 1);
    const auto left = Clock::now();
    wire.leave();
    while (at_work(server) > 0 && ms_since(left) < 20'000)
      std::this_thread::sleep_for(milliseconds(1));
    nearest = std::min(nearest, ms_since(left));
  }
  EXPECT_LT(nearest, 100);
}

TEST(Streams, CutAtAnyByteLeaveNothing) {
  Server server;
  std::mt19937 random(1);
  for (int i = 0; i < 24; ++i) {
    Wire wire(server.port());
    wire.get(room(40 + i, 65536, i % 2 == 0 ? "&stream=events" : "&stream=multipart"));
    const std::size_t bytes = random() % 900;
    for (std::size_t got = 0; got < bytes;) got += wire.read(bytes - got).size();
  }
  const Service& service = server.host().service();
  EXPECT_TRUE(eventually([&] {
    return service.admission.at_work() + service.admission.waiting() == 0 &&
           service.memory.held(MemoryAccount::requests) == 0;
  }));
  EXPECT_EQ(ask_on(server.port(), "/healthz").status, 200);
}

// Some are refused in earnest, with a status; health is answered at once all the while.
TEST(StreamsInTime, SixtyFourAtOnceKeepNobodyFromHealth) {
  Server server;
  std::vector<std::unique_ptr<Wire>> all;
  for (int i = 0; i < 64; ++i) {
    all.push_back(std::make_unique<Wire>(server.port()));
    all.back()->get(room(70 + i % 32, 65536, "&stream=multipart"));
  }
  std::vector<double> took;
  for (int i = 0; i < 20; ++i) {
    const auto asked = Clock::now();
    EXPECT_EQ(ask_on(server.port(), "/healthz").status, 200);
    took.push_back(ms_since(asked));
  }
  std::ranges::sort(took);
  EXPECT_LE(took[took.size() / 2], sanitized() ? 100 : 5);
  const Service& service = server.host().service();
  EXPECT_LE(service.pictures.counts().bytes, static_cast<std::size_t>(service.config.cache_bytes));
  std::set<int> statuses;
  for (const auto& each : all)
    if (each->readable()) statuses.insert(status_of(each->until("\r\n\r\n")));
  for (const int status : statuses) EXPECT_TRUE(status == 200 || status == 429) << status;
}

TEST(Streams, BeyondTheDeadlineEndWithAProblem) {
  Server server(HttpOptions{.host = "127.0.0.1", .port = 0, .deadline = milliseconds(600)});
  const Response told = ask_on(server.port(), room(10, 65536, "&stream=events"));
  const std::vector<Event> events = events_in(told.body);
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events.back().name, "problem");
  EXPECT_EQ(text_at(events.back().data, "type"), "/problems/timeout");
  const std::string parts = ask_on(server.port(), room(15, 65536, "&stream=multipart")).body;
  const std::size_t from = parts.rfind("\r\nContent-Type: application/problem+json\r\n");
  ASSERT_NE(from, parts.npos);
  const std::size_t document = parts.find('{', from), end = parts.rfind("\r\n--tia-");
  EXPECT_EQ(text_at(parse_json(parts.substr(document, end - document)), "type"),
            "/problems/timeout");
  EXPECT_TRUE(parts.ends_with("--\r\n"));
}

// What stands in their way before the first part has the status that it has without them.
TEST(Streams, ThatCannotBeginAreRefused) {
  Server server;
  const Response few_rays = ask_on(server.port(), room(11, 64, "&max_rays=1&stream=events"));
  EXPECT_EQ(few_rays.status, 422);
  EXPECT_EQ(only_error(few_rays).pointer, "/max_rays");
  const auto pointer = [&](const Response& refused) {
    EXPECT_EQ(refused.status, 422);
    return only_error(refused).pointer;
  };
  EXPECT_EQ(pointer(host().get("/render?stream=films")), "/stream");
  for (const char* format : {"pfm", "hdr", "tiff", "exr"})
    for (const char* stream : {"events", "multipart"})
      EXPECT_EQ(pointer(host().get(std::string("/render?format=") + format + "&stream=" + stream)),
                "/stream");
  EXPECT_EQ(pointer(host().head("/render?stream=events")), "/stream");
  EXPECT_EQ(pointer(host().post("/render", R"({"stream": 1})")), "/stream");
  EXPECT_EQ(pointer(host().get("/render?stream=events&width=0")), "/width");
}

TEST(Streams, OfHttp10AreTheLastPartAlone) {
  Server server;
  const std::string target = room(12, 16);
  const std::string answer = [&] {
    Wire wire(server.port());
    wire.send("GET " + target + "&stream=multipart HTTP/1.0\r\n\r\n");
    return wire.rest();
  }();
  EXPECT_THAT(answer, HasSubstr(plain_bytes(target)));
  EXPECT_THAT(answer, HasSubstr("Content-Length: "));
}

TEST(Pictures, AreThereByTheirTagsOrNot) {
  const Response drawn = host().get(room(13, 4));
  const std::string tag = *header(drawn, "ETag"), target = "/pictures/" + tag.substr(1, 64);
  const Response again = host().get(target);
  EXPECT_EQ(again.body, drawn.body);
  EXPECT_EQ(header(again, "Tia-Rays"), header(drawn, "Tia-Rays"));
  EXPECT_EQ(header(again, "Cache-Control"), "public, max-age=31536000, immutable");
  EXPECT_EQ(host().get(target, {{"If-None-Match", tag}}).status, 304);
  const std::string unknown(64, '0');
  for (const std::string& name :
       {unknown, target.substr(10, 63), target.substr(10) + "0", std::string("thesis"),
        std::string(63, '0') + "G", unknown.substr(1) + "%22"})
    EXPECT_EQ(problem_of(host().get("/pictures/" + name)).type, "/problems/not-found") << name;
  EXPECT_EQ(only_error(host().get(target + "?stream=films")).pointer, "/stream");
  EXPECT_EQ(only_error(host().get(target + "?format=pfm")).pointer, "/format");
  EXPECT_EQ(only_error(host().head(target + "?stream=events")).pointer, "/stream");
  Server server;
  EXPECT_EQ(ask_on(server.port(), "/pictures/" + unknown + "?stream=events").status, 404);
}

}  // namespace
}  // namespace tia::test
