// /render as mjpeg: pictures of a scene that POST /streams/{id} changes while they are looked at.
#include <memory>
#include <set>
#include <thread>

#include "tests/server/handlers/live_support.h"
#include "tests/server/handlers/streams_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string small_picture = "/render?width=24&height=18";

Response change_on(int port, const std::string& id, const std::string& body,
                   const std::string& fields = "") {
  return test::exchange(port, "POST /streams/" + id + " HTTP/1.1\r\nHost: x\r\n" + fields +
                                  "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
                                  body);
}

/// LiveStream: one that is looked at, on a server of its own: each client has one.
class LiveStream : public testing::Test {
 protected:
  LivePart begin(const std::string& target) {
    wire_.get(target + "&stream=mjpeg");
    const LivePart first = *wire_.next();
    id_ = first.field("Tia-Stream");
    EXPECT_EQ(first.number("Tia-Change"), 0);
    return first;
  }
  int change(const std::string& body) {
    const Response answer = change_on(server_.port(), id_, body);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return static_cast<int>(number_at(parse_json(answer.body), "change"));
  }
  /// The first picture that shows the change.
  std::string shown(int number) {
    for (;;) {
      const auto part = wire_.next();
      if (!part) return "none";
      if (part->number("Tia-Change") >= number) return part->body;
    }
  }
  Server server_;
  LiveWire wire_{server_.port(), 4096};
  std::string id_;
};

TEST_F(LiveStream, ShowsThePictureThatRenderHasAfterEachChange) {
  const auto render = [](const std::string& body) {
    return jpeg_of(host().post("/render", R"({"width":24,"height":18,)" + body + "}").body);
  };
  const LivePart first = begin(small_picture + "&scene=lamp-round&time=1");
  EXPECT_THAT(first.head, HasSubstr("Content-Type: image/jpeg\r\n"));
  EXPECT_TRUE(first.body == render(R"("scene":"lamp-round","time":1)"));
  EXPECT_TRUE(shown(change(R"({"time":2.5})")) == render(R"("scene":"lamp-round","time":2.5)"));
  const std::string camera = R"("camera":{"location":[0,3,6]})";
  EXPECT_TRUE(shown(change("{" + camera + "}")) ==
              render(R"("scene":"lamp-round","time":2.5,)" + camera));
  EXPECT_TRUE(shown(change(R"({"frame":7,"camera":{}})")) ==
              render(R"("scene":"lamp-round","frame":7)"));
}

TEST_F(LiveStream, PutsLightsAndKeysInEachOthersPlace) {
  begin(small_picture);
  const auto plain = [](const std::string& more) {
    return jpeg_of(host().get(small_picture + more).body);
  };
  EXPECT_TRUE(shown(change(R"({"light":[5,12,-8]})")) == plain("&light=5,12,-8"));
  EXPECT_TRUE(shown(change(R"({"key":"a"})")) == plain("&key=a"));
  EXPECT_TRUE(shown(change(R"({"light":[5,12,-8]})")) == plain("&light=5,12,-8"));
}

TEST_F(LiveStream, MergesPatchesOfItsScene) {
  begin(small_picture);
  change(R"({"scene":{"background":[0.25,0.5,0.75]}})");
  const int last = change(R"({"scene":{"name":null,"camera":{"location":[0,1,2]}}})");
  Value scene = parse_json(host().get("/scenes/thesis").body);
  scene = merge_patch(std::move(scene), parse_json(R"({"background":[0.25,0.5,0.75],
      "name":null,"camera":{"location":[0,1,2]}})"));
  const Response png =
      host().post("/render", R"({"width":24,"height":18,"scene":)" + to_json(scene) + "}");
  EXPECT_TRUE(shown(last) == jpeg_of(png.body));
}

TEST_F(LiveStream, ShowsTheNewestAndLeavesOutWhatIsLate) {
  begin("/render?width=320&height=240&integrator=path&samples=1&scene=shapes");
  constexpr int count = 60;
  for (int i = 1; i <= count; ++i)
    EXPECT_EQ(change(R"({"light":[)" + std::to_string(i) + ",12,-8]}"), i);
  std::set<int> seen;
  std::string last;
  while (!seen.contains(count)) {
    const auto part = wire_.next();
    ASSERT_TRUE(part);
    EXPECT_TRUE(seen.insert(part->number("Tia-Change")).second);
    EXPECT_EQ(*seen.rbegin(), part->number("Tia-Change")) << "in order";
    last = part->body;
  }
  EXPECT_LT(seen.size(), 30U) << "who does not read holds what is on its way and one more";
  EXPECT_TRUE(last == jpeg_of(host()
                                  .get("/render?width=320&height=240&integrator=path&samples=1"
                                       "&scene=shapes&light=60,12,-8")
                                  .body));
}

TEST_F(LiveStream, TellsWhatIsWrongWithAChangeAndStaysAsItWas) {
  begin(small_picture);
  const auto pointer = [&](const std::string& body) {
    const Response refused = change_on(server_.port(), id_, body);
    EXPECT_EQ(refused.status, 422) << body;
    return only_error(refused).pointer;
  };
  EXPECT_EQ(pointer(R"({"lihgt":[1,2,3]})"), "/lihgt");
  EXPECT_EQ(pointer(R"({"width":5})"), "/width");
  EXPECT_EQ(pointer(R"({"key":"a","light":[1,2,3]})"), "/light");
  EXPECT_EQ(pointer(R"({"time":1})"), "/time");
  EXPECT_EQ(pointer(R"({"scene":[]})"), "/scene");
  EXPECT_EQ(pointer(R"({"scene":{"background":[1,2]}})"), "/scene/background");
  EXPECT_EQ(pointer(R"({"scene":{"backdrop":"transparent"}})"), "/stream");
  EXPECT_EQ(change("{}"), 1);
  EXPECT_TRUE(shown(1) == jpeg_of(host().get(small_picture).body));
}

TEST_F(LiveStream, IsThereUntilItsClientLeaves) {
  EXPECT_EQ(change_on(server_.port(), std::string(32, '0'), "{}").status, 404);
  begin(small_picture);
  change("{}");
  wire_.leave();
  EXPECT_TRUE(eventually([&] { return server_.host().service().live.open() == 0; }));
  EXPECT_TRUE(eventually([&] { return change_on(server_.port(), id_, "{}").status == 404; }));
  EXPECT_EQ(server_.host().service().memory.held(MemoryAccount::requests), 0);
}

TEST_F(LiveStream, GivesWayToTheNextOneOfItsClient) {
  begin(small_picture);
  LiveWire next(server_.port());
  next.get(small_picture + "&stream=mjpeg");
  EXPECT_TRUE(next.next());
  LivePart last;
  while (const auto part = wire_.next()) last = *part;
  EXPECT_EQ(text_at(parse_json(last.body), "type"), "/problems/busy");
  EXPECT_EQ(change_on(server_.port(), id_, "{}").status, 404);
}

TEST(LiveStreamsAtOnce, AreBoundedAndLeaveNothingWhereverTheyAreCut) {
  Tia tia({"--port", "0", "--streams", "32", "--trusted-proxies", "127.0.0.1"});
  const auto begun = [&](int client) {
    auto wire = std::make_unique<Wire>(tia.port());
    wire->send("GET " + small_picture +
               "&stream=mjpeg HTTP/1.1\r\nHost: x\r\nX-Forwarded-For: 10.0.0." +
               std::to_string(client) + "\r\n\r\n");
    return wire;
  };
  std::vector<std::unique_ptr<Wire>> all;
  for (int i = 0; i < 64; ++i) {
    all.push_back(begun(i));
    const std::string head = all.back()->until("\r\n\r\n");
    EXPECT_EQ(status_of(head), i < 32 ? 200 : 429) << i;
    const std::size_t bytes = i < 32 ? 23U * static_cast<std::size_t>(i) : 0;
    for (std::size_t got = 0; got < bytes;) got += all.back()->read(bytes - got).size();
  }
  EXPECT_EQ(tia.get("/healthz").status, 200);
  all.clear();
  EXPECT_TRUE(eventually([&] { return status_of(begun(100)->until("\r\n\r\n")) == 200; }));
}

TEST(LiveStreams, ThatCannotBeginAreRefused) {
  const auto pointer = [](const Response& refused) {
    EXPECT_EQ(refused.status, 422);
    return only_error(refused).pointer;
  };
  EXPECT_EQ(pointer(host().head("/render?stream=mjpeg")), "/stream");
  EXPECT_EQ(pointer(host().get("/render?stream=mjpeg&format=exr")), "/stream");
  EXPECT_EQ(pointer(host().get("/render?stream=mjpeg&width=0")), "/width");
  EXPECT_EQ(
      pointer(host().post("/render",
                          R"({"stream":"mjpeg","scene":{"backdrop":"transparent","objects":[]}})")),
      "/stream");
  EXPECT_EQ(pointer(host().get("/pictures/" + std::string(64, '0') + "?stream=mjpeg")), "/stream");
}

}  // namespace
}  // namespace tia::test
