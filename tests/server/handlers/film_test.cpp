// /film: its frames are those of /render, to the byte, at their times.
#include "core/models/zip.h"
#include "tests/core/film/files.h"
#include "tests/server/handlers/film_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// ---- apng ---------------------------------------------------------------------------------------

/// ApngFrame: one of an animated PNG, as a picture of its own.
struct ApngFrame {
  std::string png;
  int ms = 0;
};

std::uint32_t number_in(const std::string& data, std::size_t at, std::size_t bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    number = number << 8U | static_cast<unsigned char>(data.at(at + i));
  return number;
}

// Takes the file apart as strictly as the standard allows for what this server writes.
// Source: W3C PNG (third edition), 11.3.4.
std::vector<ApngFrame> apng_frames(const std::string& file) {
  std::vector<ApngFrame> frames;
  std::string header;
  std::uint32_t next = 0, told = 0;
  for (std::size_t at = 8, size = 0; at < file.size(); at += 12 + size) {
    size = number_in(file, at, 4);
    const std::string type = file.substr(at + 4, 4), data = file.substr(at + 8, size);
    EXPECT_EQ(png_chunk(type, data), file.substr(at, 12 + size)) << "its checksum";
    if (type == "IHDR") header = data;
    if (type == "acTL") told = number_in(data, 0, 4);
    if (type == "fcTL" || type == "fdAT") EXPECT_EQ(number_in(data, 0, 4), next++);
    if (type == "fcTL") {
      EXPECT_EQ(data.substr(4, 8), header.substr(0, 8));
      EXPECT_EQ(data.substr(12, 8), std::string(8, '\0'));
      EXPECT_EQ(number_in(data, 22, 2), 1000U);
      EXPECT_EQ(data.substr(24), std::string(2, '\0'));
      frames.push_back({"\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header),
                        static_cast<int>(number_in(data, 20, 2))});
    }
    if (type == "IDAT") frames.back().png += png_chunk("IDAT", data);
    if (type == "fdAT") frames.back().png += png_chunk("IDAT", data.substr(4));
  }
  for (ApngFrame& each : frames) each.png += png_chunk("IEND", "");
  EXPECT_EQ(told, frames.size());
  return frames;
}

TEST(Film, OfApngHasThePixelsOfRenderAtTheirTimes) {
  const Response answer = film("");
  EXPECT_EQ(answer.content_type, "image/apng");
  EXPECT_EQ(header(answer, "Tia-Frames"), "drawn=5, shared=3");
  const auto frames = apng_frames(answer.body);
  ASSERT_EQ(frames.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const ApngFrame& each = frames[static_cast<std::size_t>(k)];
    EXPECT_EQ(each.ms, k < 4 ? 125 : 500);
    EXPECT_EQ(read_png(each.png).rgb, read_png(frame_of(k).body).rgb) << k;
  }
  EXPECT_NE(frames[0].png, frames[1].png);
}

// 1/24 s is 41 2/3 ms.
TEST(Film, OfApngLastsAsLongAsItsFramesHoweverTheyAreRounded) {
  int ms = 0;
  for (const ApngFrame& each : apng_frames(film(R"("fps":24,"to":0.5,)").body)) {
    EXPECT_TRUE(each.ms == 41 || each.ms == 42) << each.ms;
    ms += each.ms;
  }
  EXPECT_EQ(ms, 500);
}

TEST(Film, OfApngThatStaysForMinutesHasSeveralFramesOfOnePicture) {
  const auto frames = apng_frames(film(R"("fps":0.01,)").body);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].ms + frames[1].ms, 100'000);
  EXPECT_EQ(read_png(frames[0].png).rgb, read_png(frames[1].png).rgb);
}

TEST(Film, OfApngHasAlphaWhereThePicturesHave) {
  std::string scene = moving_lamp;
  scene.insert(1, R"("backdrop":"transparent",)");
  const auto frames = apng_frames(film("", scene).body);
  ASSERT_EQ(frames.size(), 5U);
  EXPECT_FALSE(read_png(frames[3].png).rgba.empty());
}

// ---- zip ----------------------------------------------------------------------------------------

TEST(Film, OfZipHasTheBytesOfRenderAndTellsTheirTags) {
  const Response answer = film(R"("format":"zip",)");
  EXPECT_EQ(answer.content_type, "application/zip");
  Faults faults;
  const auto files = unpack_zip(
      {reinterpret_cast<const std::uint8_t*>(answer.body.data()), answer.body.size()}, {}, faults);
  faults.raise();
  ASSERT_EQ(files.size(), 9U);
  const auto text = [](const UnpackedFile& file) {
    return std::string(file.bytes.begin(), file.bytes.end());
  };
  const Value told = parse_json(text(files[0]));
  EXPECT_EQ(number_at(told, "fps"), 8);
  const auto& frames = *at(told, "frames").as<Value::Array>();
  ASSERT_EQ(frames.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    const Response frame = frame_of(static_cast<int>(k));
    EXPECT_TRUE(text(files[k + 1]) == frame.body) << k;
    EXPECT_EQ(text_at(frames[k], "file"), files[k + 1].path);
    EXPECT_EQ(text_at(frames[k], "etag"), header(frame, "ETag"));
    EXPECT_EQ(number_at(frames[k], "time"), static_cast<double>(k) / 8);
  }
}

// ---- which frames -------------------------------------------------------------------------------

TEST(Film, HasTheFramesFromOneTimeUntilBeforeAnother) {
  const auto all = apng_frames(film("").body);
  const auto some = apng_frames(film(R"("from":0.2,"to":0.5,)").body);
  ASSERT_EQ(some.size(), 2U);  // at 2/8 s and 3/8 s
  EXPECT_EQ(some[0].png, all[2].png);
  EXPECT_EQ(some[1].png, all[3].png);
}

TEST(Film, OfASceneThatDoesNotMoveIsOneFrameAndSaysSo) {
  const Response answer =
      ask_on(shared_server().port(), "/film?scene=thesis&width=24&height=18&fps=10");
  EXPECT_EQ(header(answer, "Tia-Frames"), "drawn=1, shared=0, still");
  const auto frames = apng_frames(answer.body);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].ms, 100);
  EXPECT_EQ(read_png(frames[0].png).rgb,
            read_png(host().get("/render?width=24&height=18").body).rgb);
}

// ---- tags, caches, Accept -----------------------------------------------------------------------

const std::string lamp_film = "/film?scene=lamp-round&width=24&height=18&to=0.125";

TEST(Film, IsTheSameBytesFromEveryServerByEveryMethod) {
  Server other;
  const std::string body =
      R"({"scene":"lamp-round","width":24,"height":18,"to":0.125,"threads":1,)";
  for (const char* format : {"apng", "webp", "webm", "zip"}) {
    const Response got = ask_on(shared_server().port(), lamp_film + "&format=" + format);
    const Response posted = post_film(other.port(), body + R"("format":")" + format + R"("})");
    EXPECT_TRUE(got.body == posted.body) << format;
    EXPECT_EQ(header(got, "ETag"), header(posted, "ETag"));
  }
}

TEST(Film, ThatAClientHasIsNotSentAgain) {
  const std::string tag = *header(host().head(lamp_film), "ETag");
  const Response again = host().get(lamp_film, {{"If-None-Match", tag}});
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(header(again, "ETag"), tag);
  EXPECT_NE(tag, *header(host().head(lamp_film + "&format=zip"), "ETag"));
  EXPECT_NE(tag, *header(host().head(lamp_film + "&fps=12"), "ETag"));
}

TEST(Film, IsOfTheFormatThatAcceptPrefers) {
  const Response zip = host().ask("HEAD", lamp_film, "", {{"Accept", "application/zip"}});
  EXPECT_EQ(zip.content_type, "application/zip");
  EXPECT_EQ(header(zip, "Vary"), "Accept");
  EXPECT_EQ(host().ask("HEAD", lamp_film, "", {{"Accept", "*/*"}}).content_type, "image/apng");
  EXPECT_EQ(host().ask("HEAD", lamp_film, "", {{"Accept", "text/plain"}}).status, 406);
}

}  // namespace
}  // namespace tia::test
