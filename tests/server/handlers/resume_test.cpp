// Streams whose client leaves, and who asks for the picture afterwards.
#include "server/handlers/dispatch.h"

#include "tests/server/handlers/streams_support.h"

namespace tia::test {
namespace {

std::string left_room(int samples, const std::string& more) {
  return "/render?scene=cornell-light&width=16&height=12&samples=" + std::to_string(samples) + more;
}

// Of a stream's event, which is all that a part is.
Event event_of(std::string_view part) { return events_in(std::string(part)).at(0); }
int most_samples(const Event& event) {
  return static_cast<int>(number_at(at(event.data, "samples"), "max"));
}

// Leaves once each pixel has had 16 samples. Returns: how many it had.
int leave(Host& host, const std::string& target) {
  std::stop_source leaves;
  Request request{"GET", target + "&stream=events", {}, "", "left"};
  request.stop = leaves.get_token();
  int samples = 0;
  const SendPart send{[](std::string_view) {},
                      [&](std::string_view part) {
                        const Event event = event_of(part);
                        if (leaves.stop_requested() || most_samples(event) < 16) return;
                        samples = most_samples(event);
                        leaves.request_stop();
                      }};
  EXPECT_THROW(answer(request, host.service()).parts(send), Stopped);
  return samples;
}

TEST(Resume, GoesOnWithWhatAClientHasLeftToTheSameBytes) {
  for (const char* of : {"&seed=301&threads=1", "&seed=302&threads=7", "&noise=0.001"}) {
    Host host;
    const int samples = leave(host, left_room(65536, of));
    ASSERT_GE(samples, 16);
    const auto metric = [&](const char* name) {
      return series_of(host.get("/metrics").body).at(name);
    };
    EXPECT_EQ(metric("tia_cache_rounds"), 1);
    EXPECT_GE(metric("tia_cache_bytes"), 16 * 12 * 100);
    const std::string target = left_room(2 * samples, of);
    const Response drawn = host.get(target);
    EXPECT_EQ(header(drawn, "Cache-Status"), "Tia; fwd=partial; stored");
    EXPECT_EQ(drawn.body, plain_bytes(target)) << target;
    EXPECT_EQ(metric("tia_resumed_pictures_total"), 1);
    // What is drawn otherwise has nothing of it.
    for (const char* changed : {"width=15", "width=16&seed=1", "width=16&max_depth=3",
                                "width=16&exposure=1", "width=16&crop=0,0,9,9"}) {
      const std::string other =
          "/render?scene=cornell-light&height=12&samples=16&noise=0.001&" + std::string(changed);
      EXPECT_EQ(header(host.get(other), "Cache-Status"), "Tia; fwd=miss; stored") << other;
    }
  }
}

// What it sees first is what there was.
TEST(Resume, ShowsWhatThereIsFirst) {
  Host host;
  const std::string of = "&seed=310";
  const int samples = leave(host, left_room(65536, of));
  Request request{"GET", left_room(2 * samples, of) + "&stream=events", {}, "", "seen"};
  std::vector<Event> events;
  const SendPart send{[](std::string_view) {},
                      [&](std::string_view part) { events.push_back(event_of(part)); }};
  answer(request, host.service()).parts(send);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(most_samples(events[0]), samples);
  EXPECT_EQ(at(events[0].data, "preview"), Value(false));
  EXPECT_EQ(most_samples(events[1]), 2 * samples);
  EXPECT_EQ(host.get(text_at(events[1].data, "href")).body,
            plain_bytes(left_room(2 * samples, of)));
}

// Each part that has come of rounds that were kept says so.
TEST(Resume, SaysInAllPartsThatTheyGoOn) {
  Host host;
  const std::string of = "&seed=330";
  const int samples = leave(host, left_room(65536, of));
  Request request{"GET", left_room(2 * samples, of) + "&stream=multipart", {}, "", "seen"};
  std::vector<std::string> parts;
  const SendPart send{[](std::string_view) {},
                      [&](std::string_view part) { parts.emplace_back(part); }};
  answer(request, host.service()).parts(send);
  ASSERT_EQ(parts.size(), 2U);
  for (const std::string& part : parts)
    EXPECT_THAT(part.substr(0, part.find("\r\n\r\n")),
                testing::HasSubstr("Cache-Status: Tia; fwd=partial"));
}

TEST(Resume, KeepsNothingWhereThereIsNoCache) {
  Config config;
  config.cache_bytes = 0;
  Host host(config);
  leave(host, left_room(65536, "&seed=320"));
  EXPECT_EQ(host.service().pictures.counts().rounds, 0U);
}

}  // namespace
}  // namespace tia::test
