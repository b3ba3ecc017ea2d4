// Films as others read them: webp by libwebp's own decoder, webm by ffmpeg.
#include <webp/demux.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "tests/server/handlers/film_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// ---- webp ---------------------------------------------------------------------------------------

/// ShownFrame: until when it is shown, and its pixels.
struct ShownFrame {
  int end_ms = 0;
  std::string rgba;
};

std::vector<ShownFrame> webp_frames(const std::string& file) {
  const WebPData data{reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
  const std::unique_ptr<WebPAnimDecoder, void (*)(WebPAnimDecoder*)> decoder(
      WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete);
  std::vector<ShownFrame> frames;
  WebPAnimInfo info;
  if (!decoder || WebPAnimDecoderGetInfo(decoder.get(), &info) == 0) return frames;
  EXPECT_EQ(info.loop_count, 0U) << "over and over";
  while (WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
    std::uint8_t* pixels = nullptr;
    ShownFrame frame;
    if (WebPAnimDecoderGetNext(decoder.get(), &pixels, &frame.end_ms) == 0) break;
    frame.rgba.assign(reinterpret_cast<const char*>(pixels),
                      std::size_t{4} * info.canvas_width * info.canvas_height);
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::string with_alpha(const std::string& rgb) {
  std::string rgba;
  for (std::size_t i = 0; i < rgb.size(); i += 3) rgba += rgb.substr(i, 3) + '\xFF';
  return rgba;
}

TEST(FilmOfWebp, HasThePixelsOfRenderAtTheirTimes) {
  const Response answer = film(R"("format":"webp",)");
  EXPECT_EQ(answer.content_type, "image/webp");
  const auto frames = webp_frames(answer.body);
  ASSERT_EQ(frames.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const ShownFrame& each = frames[static_cast<std::size_t>(k)];
    EXPECT_EQ(each.end_ms, k < 4 ? 125 * (k + 1) : 1000);
    EXPECT_TRUE(each.rgba == with_alpha(read_png(frame_of(k).body).rgb)) << k;
  }
}

TEST(FilmOfWebp, HasTheAlphaOfThePictures) {
  std::string scene = moving_lamp;
  scene.insert(1, R"("backdrop":"transparent",)");
  const auto frames = webp_frames(film(R"("format":"webp",)", scene).body);
  ASSERT_EQ(frames.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const Response png =
        host().post("/render", film_body(R"("frame":)" + std::to_string(k) + ",", scene));
    EXPECT_TRUE(frames[static_cast<std::size_t>(k)].rgba == read_png(png.body).rgba) << k;
  }
}

// ---- webm ---------------------------------------------------------------------------------------

// What a program writes to its standard output.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string all;
  std::array<char, 1 << 16> piece{};
  while (const std::size_t got = fread(piece.data(), 1, piece.size(), pipe.get()))
    all.append(piece.data(), got);
  return all;
}

double mean_difference(const std::string& a, const std::string& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i]));
  return sum / static_cast<double>(a.size());
}

class FilmOfWebm : public testing::Test {
 protected:
  std::string saved(const std::string& more) {
    const Response answer = film(R"("format":"webm",)" + more);
    EXPECT_EQ(answer.content_type, "video/webm");
    std::ofstream(folder_.file("a.webm"), std::ios::binary) << answer.body;
    return folder_.file("a.webm");
  }
  Folder folder_;
};

TEST_F(FilmOfWebm, LastsAsLongHasAsManyFramesAndTellsItsColors) {
  const std::string told = output_of(
      "ffprobe -v error -count_frames -show_entries stream=codec_name,profile,width,height,"
      "pix_fmt,color_range,color_space,color_transfer,color_primaries,nb_read_frames:"
      "format=duration:frame=pts_time -of default=noprint_wrappers=1 " +
      saved(""));
  for (const char* line :
       {"codec_name=vp9", "profile=Profile 0", "width=24", "height=18", "pix_fmt=yuv420p",
        "color_range=tv", "color_space=bt709", "color_transfer=iec61966-2-1",
        "color_primaries=bt709", "nb_read_frames=8", "duration=1.000000"})
    EXPECT_THAT(told, HasSubstr(std::string(line) + '\n'));
  for (const char* time : {"0.000000", "0.125000", "0.500000", "0.875000"})
    EXPECT_THAT(told, HasSubstr(std::string("pts_time=") + time + '\n'));
}

// The decoder's own conversion rounds, too.
TEST_F(FilmOfWebm, IsWithinAMeanOf1Point5Of255) {
  const std::string size = R"("width":96,"height":72,)";
  const std::string raw =
      output_of("ffmpeg -v error -i " + saved(size) +
                " -vf scale=flags=accurate_rnd+full_chroma_int -f rawvideo -pix_fmt rgb24 -");
  constexpr std::size_t bytes = 96 * 72 * 3;
  ASSERT_EQ(raw.size(), 8 * bytes);
  for (int k = 0; k < 8; ++k) {
    const std::string rgb = read_png(frame_of(k, size).body).rgb;
    EXPECT_LT(mean_difference(rgb, raw.substr(static_cast<std::size_t>(k) * bytes, bytes)), 1.5)
        << k;
  }
}

}  // namespace
}  // namespace tia::test
