// /film as mjpeg: each picture at its time, what would be late left out, for as many as look on.
#include <algorithm>

#include "core/film/jpeg.h"
#include "tests/server/handlers/film_support.h"
#include "tests/server/handlers/live_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

/// LiveFilm: what came of one, and when.
struct LiveFilm {
  std::vector<LivePart> parts;
  std::vector<double> ms;  ///< since the first one
  int last() const { return parts.back().number("Tia-Frame"); }
};

LiveFilm watched(const std::string& target) {
  LiveFilm film;
  LiveWire wire(shared_server().port());
  wire.get(target);
  Clock::time_point first;
  while (const auto part = wire.next()) {
    if (film.parts.empty()) first = Clock::now();
    film.ms.push_back(ms_since(first));
    film.parts.push_back(*part);
  }
  EXPECT_TRUE(wire.is_whole());
  return film;
}

const std::string live_lamp = "/film?scene=lamp-round&width=24&height=18&format=mjpeg";

TEST(LiveFilm, ShowsThePicturesOfRenderNoSoonerThanTheirTimes) {
  const LiveFilm film = watched(live_lamp + "&fps=8&from=0.5&to=1");
  ASSERT_FALSE(film.parts.empty());
  EXPECT_EQ(film.parts.front().number("Tia-Frame"), 4);
  EXPECT_EQ(film.last(), 7) << "whatever is late";
  for (std::size_t i = 0; i < film.parts.size(); ++i) {
    const int frame = film.parts[i].number("Tia-Frame");
    if (i > 0) EXPECT_GT(frame, film.parts[i - 1].number("Tia-Frame"));
    // What came first may have come late: by the time that a loaded machine takes to read it.
    EXPECT_GE(film.ms[i], (frame - 4) * 125 - 60);
    const Response png = host().get("/render?scene=lamp-round&width=24&height=18&time=" +
                                    to_json(Value(frame / 8.0)));
    EXPECT_TRUE(film.parts[i].body == jpeg_of(png.body)) << frame;
  }
}

TEST(LiveFilm, LeavesOutWhatWouldComeLate) {
  const LiveFilm film = watched(live_lamp + "&samples=256&fps=1000&to=0.5");
  EXPECT_EQ(film.parts.front().number("Tia-Frame"), 0);
  EXPECT_EQ(film.last(), 499);
  EXPECT_LT(film.parts.size(), 400U);
}

TEST(LiveFilm, OfASceneThatDoesNotMoveIsOnePicture) {
  const LiveFilm film = watched("/film?scene=thesis&width=24&height=18&format=mjpeg");
  ASSERT_EQ(film.parts.size(), 1U);
  EXPECT_EQ(film.parts[0].body, jpeg_of(host().get("/render?width=24&height=18").body));
}

TEST(LiveFilm, SaysBeforehandWhatItIs) {
  const Response head = host().head(live_lamp + "&fps=8&to=1");
  EXPECT_THAT(head.content_type, HasSubstr("multipart/x-mixed-replace; boundary="));
  EXPECT_EQ(header(head, "Tia-Frames"), "drawn=8, shared=0");
  EXPECT_EQ(header(head, "Cache-Control"), "no-store");
  EXPECT_EQ(header(head, "ETag"), std::nullopt) << "it is another one each time";
  EXPECT_EQ(only_error(host().head(live_lamp + "&from=9")).pointer, "/from");
}

TEST(LiveFilm, EndsWithItsClientWhereverThatLeaves) {
  Server server;
  for (int i = 0; i < 12; ++i) {
    Wire wire(server.port());
    wire.get(live_lamp + "&fps=100&seed=" + std::to_string(i));
    for (int got = 0; got < 211 * i;) got += static_cast<int>(wire.read(211).size());
  }
  const Service& service = server.host().service();
  EXPECT_TRUE(eventually([&] {
    return service.live.open() == 0 && service.admission.at_work() == 0 &&
           service.memory.held(MemoryAccount::requests) == 0;
  }));
}

TEST(FilmCommand, WritesMjpegAsJpegsOneAfterTheOther) {
  const Folder folder;
  const std::string file = folder.file("a.mjpeg");
  EXPECT_EQ(run({"film", "lamp-round", "-o", file, "--width", "24", "--height", "18", "--fps", "8",
                 "--to", "0.25"})
                .status,
            0);
  const std::string at = "/render?scene=lamp-round&width=24&height=18&time=";
  EXPECT_TRUE(file_bytes(file) ==
              jpeg_of(host().get(at + "0").body) + jpeg_of(host().get(at + "0.125").body));
}

}  // namespace
}  // namespace tia::test
