// Pictures that are shown while they are drawn, over real sockets: what they show.
#include "tests/server/handlers/streams_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Streams, EndWithThePlainPictureForAnyThreads) {
  Server server;
  const int samples = rounds(64, 4);
  int seed = 100;
  for (const char* threads : cases({"&threads=1", "&threads=7"}))
    for (const char* of : {"", "&noise=0.05", "&integrator=whitted", "&max_rays=2000000",
                           "&denoise=true", "&denoise=true&noise=0.05"}) {
      const std::string target = room(++seed, samples, of) + threads;
      const std::string plain = plain_bytes(target);
      const Response parts = ask_on(server.port(), target + "&stream=multipart");
      EXPECT_THAT(parts.content_type, StartsWith("multipart/x-mixed-replace; boundary="));
      EXPECT_EQ(header(parts, "X-Accel-Buffering"), "no");
      EXPECT_EQ(header(parts, "Cache-Control"), "no-store");
      EXPECT_EQ(header(parts, "Cross-Origin-Resource-Policy"), "cross-origin");
      EXPECT_EQ(pictures_in(parts).back(), plain) << target;

      const std::string other = room(++seed, samples, of) + threads;
      const Response told = ask_on(server.port(), other + "&stream=events");
      EXPECT_EQ(told.content_type, "text/event-stream");
      const std::vector<Event> events = events_in(told.body);
      ASSERT_FALSE(events.empty());
      EXPECT_EQ(events.back().name, "done");
      const Response last = ask_on(server.port(), text_at(events.back().data, "href"));
      EXPECT_EQ(last.body, plain_bytes(other)) << other;
      EXPECT_EQ(ask_on(server.port(), other).body, last.body);
    }
}

// Of POST, too. Each round is the picture of as many samples, where it is no preview.
TEST(Streams, EachHrefGivesThePictureOfItsSamples) {
  Server server;
  const int all = rounds(1024, 16);
  const std::string body =
      R"({"scene": "cornell-light", "width": 32, "height": 24, "seed": 7, "stream": "events",)"
      R"( "samples": )" +
      std::to_string(all) + "}";
  const Response told = posted_to(server.port(), body);
  const std::vector<Event> events = events_in(told.body);
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(at(events[0].data, "preview"), Value(true));
  double before = 0, rays = 0;
  for (const Event& each : events) {
    const double mean = number_at(at(each.data, "samples"), "mean");
    EXPECT_GT(mean, before);
    EXPECT_GT(number_at(each.data, "rays"), rays);
    EXPECT_EQ(each.name, &each == &events.back() ? "done" : "round");
    before = mean, rays = number_at(each.data, "rays");
    const std::string href = text_at(each.data, "href");
    const Response shown = ask_on(server.port(), href);
    EXPECT_EQ(header(shown, "ETag"), '"' + href.substr(10) + '"');
    if (at(each.data, "preview") == Value(true)) continue;
    const int samples = static_cast<int>(mean);
    EXPECT_EQ(shown.body, plain_bytes(room(7, samples))) << samples;
    EXPECT_GT(number_at(each.data, "noise"), 0);
  }
  EXPECT_EQ(before, all);
}

// All samples are told, to the last; what is shown before is filtered quickly.
TEST(Streams, OfWhatIsDenoisedClearUp) {
  Server server;
  const std::string target = room(31, rounds(48, 6), "&denoise=true");
  const std::vector<Event> events =
      events_in(ask_on(server.port(), target + "&stream=events").body);
  ASSERT_GE(events.size(), 2U);
  double before = 0;
  for (const Event& each : events) {
    const double mean = number_at(at(each.data, "samples"), "mean");
    EXPECT_GT(mean, before);
    EXPECT_EQ(at(each.data, "preview"), Value(&each != &events.back()));
    before = mean;
    const Response shown = ask_on(server.port(), text_at(each.data, "href"));
    EXPECT_EQ(shown.body == plain_bytes(target), &each == &events.back());
  }
  EXPECT_EQ(before, rounds(48, 6));
}

// With the fields that the plain answer has; a preview is told from the others.
TEST(Streams, PartsTellWhatAnswersTell) {
  Server server;
  const auto body = [](const std::string& more) {
    return R"({"width": 32, "height": 24, "samples": 64, "noise": 0.01, "integrator": "path",)"
           R"( "scene": {"options": {"clamp": 2}, "background": [0.5, 0.25, 1],)"
           R"( "objects": [{"type": "sphere", "center": [0, 0, -9], "radius": 1.5}]})" +
           more + "}";
  };
  const Response plain = host().post("/render", body(""));
  ASSERT_EQ(plain.status, 200) << plain.body;
  const Response parts = posted_to(server.port(), body(R"(, "stream": "multipart")"));
  EXPECT_EQ(header(parts, "Tia-Biased"), "clamp");
  const std::vector<std::string> heads = heads_in(parts);
  ASSERT_GE(heads.size(), 2U);
  EXPECT_THAT(heads.front(), HasSubstr("\r\nTia-Preview: true"));
  EXPECT_THAT(heads.back(), testing::Not(HasSubstr("Tia-Preview")));
  for (const char* name : {"ETag", "Tia-Rays", "Tia-Samples", "Tia-Noise"})
    EXPECT_THAT(heads.back(), HasSubstr(name + (": " + *header(plain, name)))) << name;
  EXPECT_THAT(heads.back(), HasSubstr("Server-Timing: queue;dur="));
  EXPECT_THAT(heads.back(), HasSubstr("Cache-Status: Tia; fwd=miss; stored"));
}

TEST(Streams, OfAKeptPictureAreThatAlone) {
  Server server;
  const std::string target = room(8, 16);
  const Response plain = ask_on(server.port(), target);
  const std::string href = "/pictures/" + header(plain, "ETag")->substr(1, 64);
  for (const std::string& asked : {target + "&stream=", href + "?stream="}) {
    EXPECT_EQ(pictures_in(ask_on(server.port(), asked + "multipart")), std::vector{plain.body});
    const std::vector<Event> events = events_in(ask_on(server.port(), asked + "events").body);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].name, "done");
    EXPECT_EQ(text_at(events[0].data, "href"), href);
  }
}

// Its drawing has not counted: each pixel has all samples, but where a threshold ends them.
TEST(Streams, OfPicturesThatWereDrawnPlainlyTellTheirSamples) {
  Server server;
  const auto told = [&](const std::string& target) {
    EXPECT_EQ(ask_on(server.port(), target).status, 200);
    return events_in(ask_on(server.port(), target + "&stream=events").body).at(0).data;
  };
  const std::string thesis = "/render?scene=thesis&width=32&height=24";
  const std::vector<std::pair<std::string, double>> all{
      {thesis, 1}, {thesis + "&samples=5", 5}, {room(9, 16), 16}};
  for (const auto& [target, samples] : all) {
    const Value data = told(target);
    for (const char* name : {"min", "mean", "max"})
      EXPECT_EQ(number_at(at(data, "samples"), name), samples) << target;
    EXPECT_EQ(at(data, "noise"), Value());
  }
  EXPECT_EQ(at(told(thesis + "&threshold=0.02"), "samples"), Value());
}

// A view is drawn after the other; what is shown meanwhile is no picture of its own.
TEST(Streams, OfASheetShowItsViewsOneAfterAnother) {
  Server server;
  const int samples = rounds(256, 8);
  const auto body = [samples](const char* more, int seed) {
    std::string scene = host().get("/scenes/cornell-light").body;
    scene.insert(
        scene.find('{') + 1,
        R"("sheet": {"columns": 2, "views": [)"
        R"({"camera": {"location": [278, 273, -800], "look_at": [278, 273, 0]}, "lights": []},)"
        R"({"camera": {"location": [100, 273, -800], "look_at": [278, 273, 0]}, "lights": []},)"
        R"({"camera": {"location": [400, 273, -800], "look_at": [278, 273, 0]}, "lights": []}]},)");
    return R"({"width": 24, "height": 20, "samples": )" + std::to_string(samples) +
           R"(, "seed": )" + std::to_string(seed) + R"(, "scene": )" + scene + more + "}";
  };
  const Response plain = host().post("/render", body("", 1));
  ASSERT_EQ(plain.status, 200) << plain.body;
  const Response parts = posted_to(server.port(), body(R"(, "stream": "multipart")", 1));
  EXPECT_EQ(pictures_in(parts).back(), plain.body);
  const std::vector<Event> events =
      events_in(posted_to(server.port(), body(R"(, "stream": "events")", 2)).body);
  ASSERT_GE(events.size(), 2U);
  const std::string all = host().post("/render", body("", 2)).body;
  double before = 0;
  for (const Event& each : events) {
    const bool is_last = &each == &events.back();
    EXPECT_EQ(at(each.data, "preview"), Value(!is_last));
    const double mean = number_at(at(each.data, "samples"), "mean");
    EXPECT_GT(mean, before);
    before = mean;
    const std::string picture = ask_on(server.port(), text_at(each.data, "href")).body;
    EXPECT_EQ(read_png(picture).width, 48);
    EXPECT_EQ(picture == all, is_last);
  }
  EXPECT_EQ(before, samples);
}

TEST(Streams, OfStillsEndWithThem) {
  Server server;
  const std::string target = "/still?model=part&width=32&height=24&samples=64&seed=";
  const Response parts = ask_on(server.port(), target + "1&stream=multipart");
  EXPECT_EQ(pictures_in(parts).back(), plain_bytes(target + "1"));
  const std::vector<Event> events =
      events_in(ask_on(server.port(), target + "2&stream=events").body);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(ask_on(server.port(), text_at(events.back().data, "href")).body,
            plain_bytes(target + "2"));
  const Response scene = ask_on(server.port(), target + "3&as=scene&stream=events");
  EXPECT_EQ(only_error(scene).pointer, "/stream");
}

// Who comes late sees at once what there is, and ends with the same picture.
TEST(Streams, MayBeJoinedLate) {
  Server server;
  const std::string target = room(9, sanitized() ? 256 : 4096);
  const std::string tag = *header(server.host().head(target), "ETag");
  Wire first(server.port()), late(server.port());
  begun(first, target + "&stream=events");
  const std::string seen = begun(late, "/pictures/" + tag.substr(1, 64) + "?stream=events");
  EXPECT_THAT(seen, HasSubstr("event: round"));
  EXPECT_EQ(server.host().service().pictures.counts().drawn, 1);
  const auto last_of = [](Wire& wire) {
    std::string rest = wire.until("0\r\n\r\n");
    return rest.substr(rest.rfind("/pictures/"), 74);
  };
  const std::string of_first = last_of(first);
  EXPECT_EQ(of_first, "/pictures/" + tag.substr(1, 64));
  EXPECT_EQ(last_of(late), of_first);
  EXPECT_EQ(ask_on(server.port(), of_first).body, ask_on(server.port(), target).body);
}

}  // namespace
}  // namespace tia::test
