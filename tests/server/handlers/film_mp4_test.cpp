// Films as mp4, by the program ffmpeg: what it writes, and what becomes of it.
#include <signal.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "tests/server/handlers/film_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

constexpr const char* program = "/usr/bin/ffmpeg";

std::string said_by(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string all;
  std::array<char, 1 << 16> piece{};
  while (const std::size_t got = fread(piece.data(), 1, piece.size(), pipe.get()))
    all.append(piece.data(), got);
  return all;
}

/// The children of a process, those that nobody has waited for among them. Source: proc(5), stat.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string stat;
    if (!std::getline(file, stat)) continue;
    std::istringstream after(stat.substr(stat.rfind(')') + 1));
    std::string state;
    pid_t of = 0;
    if (after >> state >> of && of == parent)
      children.push_back(std::stoi(entry.path().filename().string()));
  }
  return children;
}

class FilmOfMp4 : public testing::Test {
 protected:
  static Tia& tia() {
    static Tia one({"--port", "0", "--ffmpeg", program});
    return one;
  }
  std::string saved(const std::string& more) {
    const Response answer = post_film(tia().port(), film_body(R"("format":"mp4",)" + more));
    EXPECT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(answer.content_type, "video/mp4");
    std::ofstream(folder_.file("a.mp4"), std::ios::binary) << answer.body;
    return folder_.file("a.mp4");
  }
  // A film under way, and its encoder.
  static pid_t begin(Wire& wire) {
    wire.get("/film?scene=lamp-round&width=160&height=120&samples=16&format=mp4");
    EXPECT_TRUE(eventually([] { return children_of(tia().pid()).size() == 1; }));
    wire.until("moof");
    return children_of(tia().pid()).at(0);
  }
  static void expect_nothing_left(std::size_t descriptors) {
    EXPECT_TRUE(eventually(
        [&] { return children_of(tia().pid()).empty() && entries(tia(), "fd") <= descriptors; }));
    EXPECT_EQ(tia().get("/healthz").status, 200);
  }
  Folder folder_;
};

TEST_F(FilmOfMp4, LastsAsLongHasAsManyFramesAndTellsItsColors) {
  const std::string told = said_by(
      "ffprobe -v error -count_frames -show_entries stream=codec_name,width,height,"
      "pix_fmt,color_range,color_space,color_transfer,color_primaries,nb_read_frames:"
      "format=duration:frame=pts_time -of default=noprint_wrappers=1 " +
      saved(""));
  for (const char* line : {"codec_name=h264", "width=24", "height=18", "pix_fmt=yuv420p",
                           "color_range=tv", "color_space=bt709", "color_transfer=iec61966-2-1",
                           "color_primaries=bt709", "nb_read_frames=8", "duration=1.000000",
                           "pts_time=0.000000", "pts_time=0.125000", "pts_time=0.875000"})
    EXPECT_THAT(told, HasSubstr(std::string(line) + '\n'));
}

TEST_F(FilmOfMp4, IsWithinAMeanOf2Of255) {
  const std::string size = R"("width":96,"height":72,)";
  const std::string raw =
      said_by("ffmpeg -v error -i " + saved(size) +
              " -vf scale=flags=accurate_rnd+full_chroma_int -f rawvideo -pix_fmt rgb24 -");
  constexpr std::size_t bytes = 96 * 72 * 3;
  ASSERT_EQ(raw.size(), 8 * bytes);
  for (std::size_t k = 0; k < 8; ++k) {
    const std::string rgb = read_png(frame_of(static_cast<int>(k), size).body).rgb;
    double sum = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      sum += std::abs(static_cast<unsigned char>(rgb[i]) -
                      static_cast<unsigned char>(raw[k * bytes + i]));
    EXPECT_LT(sum / bytes, 2) << k;
  }
}

TEST_F(FilmOfMp4, IsRefusedWhereItCannotBe) {
  const Response odd =
      post_film(tia().port(), R"({"format":"mp4","width":23,"height":18,"scene":"lamp-round"})");
  EXPECT_EQ(odd.status, 422);
  EXPECT_EQ(only_error(odd).pointer, "/format");
  EXPECT_THAT(only_error(odd).allowed, HasSubstr("even sides"));
  Tia none({"--port", "0", "--ffmpeg", "/bin/false"});
  EXPECT_EQ(post_film(none.port(), film_body(R"("format":"mp4",)")).status, 500);
}

TEST_F(FilmOfMp4, WhoseEncoderIsKilledIsNeverDone) {
  saved("");
  const std::size_t descriptors = entries(tia(), "fd");
  Wire wire(tia().port());
  kill(begin(wire), SIGKILL);
  EXPECT_FALSE(wire.rest().ends_with("\r\n0\r\n\r\n"));
  wire.leave();
  expect_nothing_left(descriptors);
}

TEST_F(FilmOfMp4, WhoseClientLeavesEndsItsEncoder) {
  saved("");
  const std::size_t descriptors = entries(tia(), "fd");
  Wire wire(tia().port());
  begin(wire);
  wire.leave();
  expect_nothing_left(descriptors);
}

}  // namespace
}  // namespace tia::test
