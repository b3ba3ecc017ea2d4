#include "server/requests/film_encoders.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "core/film/jpeg.h"
#include "core/input/json.h"
#include "core/video/apng.h"
#include "core/video/stored_zip.h"
#include "core/video/vp9.h"
#include "core/video/webm.h"
#include "core/video/webp_animation.h"
#include "core/video/ycbcr.h"
#include "server/operation/child_filter.h"

namespace tia::server {
namespace {

// Of a picture that is codes.
Image8 image_of(const Picture& picture, int width, int height) {
  Image8 image(width, height);
  image.rgb.assign(picture.bytes.begin(), picture.bytes.end());
  return image;
}

/// ApngEncoder: a shot is a frame of the file, or several where it is shown for longer than one
/// can be.
class ApngEncoder : public FilmEncoder {
 public:
  explicit ApngEncoder(const FilmPlan& film) : film_(film), writer_(frames_of(film)) {}
  std::string add(const Picture& picture, const Shot& shot) override {
    std::string piece;
    for (std::int64_t left = ms_of(film_, shot), first = true; left > 0 || first; first = false) {
      const std::int64_t ms = std::min(left, ApngWriter::longest_ms);
      piece += writer_.frame(picture.bytes, ms);
      left -= ms;
    }
    return piece;
  }
  std::string end() override { return ApngWriter::end(); }

 private:
  static std::int64_t ms_of(const FilmPlan& film, const Shot& shot) {
    return film.ms_until(shot.first + shot.frames) - film.ms_until(shot.first);
  }
  static int frames_of(const FilmPlan& film) {
    std::int64_t frames = 0;
    for (const Shot& shot : film.shots)
      frames += std::max<std::int64_t>(
          1, (ms_of(film, shot) + ApngWriter::longest_ms - 1) / ApngWriter::longest_ms);
    return static_cast<int>(frames);
  }
  const FilmPlan& film_;
  ApngWriter writer_;
};

/// ZipEncoder: each frame a file, and film.json before them.
class ZipEncoder : public FilmEncoder {
 public:
  explicit ZipEncoder(const FilmPlan& film) : film_(film) {}
  std::string begin() override {
    Value::Array frames;
    for (const Shot& shot : film_.shots)
      for (int k = shot.first; k < shot.first + shot.frames; ++k)
        frames.push_back(Value::Object{
            {"time", film_.seconds_of(k)}, {"etag", shot.etag}, {"file", file_name(k)}});
    return zip_.file("film.json",
                     to_json(Value::Object{{"fps", film_.fps}, {"frames", std::move(frames)}}));
  }
  std::string add(const Picture& picture, const Shot& shot) override {
    std::string piece;
    for (int k = shot.first; k < shot.first + shot.frames; ++k)
      piece += zip_.file(file_name(k), picture.bytes);
    return piece;
  }
  std::string end() override { return zip_.end(); }

 private:
  static std::string file_name(int frame) {
    char name[24];
    std::snprintf(name, sizeof name, "%05d.png", frame);
    return name;
  }
  const FilmPlan& film_;
  StoredZip zip_;
};

/// WebmEncoder: every frame a frame of the video, so that it has as many; one that shows the
/// picture before takes a few bytes.
class WebmEncoder : public FilmEncoder {
 public:
  explicit WebmEncoder(const FilmPlan& film)
      : film_(film),
        codec_(film.width, film.height),
        writer_(film.width, film.height, film.ms_until(film.frames)) {}
  std::string begin() override { return writer_.head(); }
  std::string add(const Picture& picture, const Shot& shot) override {
    const Image8 image = image_of(picture, film_.width, film_.height);
    std::string piece;
    for (int k = shot.first; k < shot.first + shot.frames; ++k)
      piece += writer_.frame(codec_.encode(image), film_.ms_until(k));
    return piece;
  }
  std::string end() override { return {}; }

 private:
  const FilmPlan& film_;
  Vp9Encoder codec_;
  WebmWriter writer_;
};

/// WebpEncoder: a shot is a frame of the file.
class WebpEncoder : public FilmEncoder {
 public:
  explicit WebpEncoder(const FilmPlan& film) : film_(film), animation_(film.width, film.height) {}
  std::string add(const Picture& picture, const Shot& shot) override {
    const auto* codes = reinterpret_cast<const std::uint8_t*>(picture.bytes.data());
    animation_.add(codes, film_.is_transparent, film_.ms_until(shot.first));
    return {};
  }
  std::string end() override { return animation_.finish(film_.ms_until(film_.frames)); }

 private:
  const FilmPlan& film_;
  WebpAnimation animation_;
};

/// Mp4Encoder: H.264 by ffmpeg, which gets the planes that webm gets, in fragments of half a second
/// that can be sent as they come.
class Mp4Encoder : public FilmEncoder {
 public:
  Mp4Encoder(const FilmPlan& film, const FilmTools& tools)
      : film_(film),
        stop_(tools.stop),
        child_(tools.ffmpeg.program, words_for(film), {.cpu_s = tools.ffmpeg.cpu_s}) {}
  std::string add(const Picture& picture, const Shot& shot) override {
    const YCbCr420 codes = ycbcr_of(image_of(picture, film_.width, film_.height));
    std::string piece;
    for (int k = 0; k < shot.frames; ++k)
      for (const auto* plane : {&codes.y, &codes.cb, &codes.cr})
        piece += child_.pass({reinterpret_cast<const char*>(plane->data()), plane->size()}, stop_);
    return piece;
  }
  std::string end() override { return child_.finish(stop_); }
  bool waits() const override { return true; }

 private:
  static std::vector<std::string> words_for(const FilmPlan& film) {
    const std::string size = std::to_string(film.width) + 'x' + std::to_string(film.height);
    std::istringstream words(
        "-v quiet -nostdin -f rawvideo -pix_fmt yuv420p -s " + size + " -framerate " +
        to_json(Value(film.fps)) +
        " -i pipe:0 -c:v libx264 -preset veryfast -crf 18 -bf 0 -threads 1 -colorspace bt709"
        " -color_primaries bt709 -color_trc iec61966-2-1 -color_range tv"
        " -movflags frag_keyframe+empty_moov+default_base_moof -frag_duration 500000"
        " -f mp4 pipe:1");
    return {std::istream_iterator<std::string>(words), {}};
  }
  const FilmPlan& film_;
  const std::stop_token stop_;
  ChildFilter child_;
};

/// MjpegEncoder: JPEG files one after the other, one a frame.
class MjpegEncoder : public FilmEncoder {
 public:
  explicit MjpegEncoder(const FilmPlan& film) : film_(film) {}
  std::string add(const Picture& picture, const Shot& shot) override {
    const std::string file = encode_jpeg(image_of(picture, film_.width, film_.height));
    std::string piece;
    for (int k = 0; k < shot.frames; ++k) piece += file;
    return piece;
  }
  std::string end() override { return {}; }

 private:
  const FilmPlan& film_;
};

template <class Encoder>
std::unique_ptr<FilmEncoder> make(const FilmPlan& film) {
  return std::make_unique<Encoder>(film);
}

}  // namespace

std::unique_ptr<FilmEncoder> encoder_of(FilmFormat format, const FilmPlan& film,
                                        const FilmTools& tools) {
  switch (format) {
    case FilmFormat::apng: return make<ApngEncoder>(film);
    case FilmFormat::webp: return make<WebpEncoder>(film);
    case FilmFormat::webm: return make<WebmEncoder>(film);
    case FilmFormat::zip: return make<ZipEncoder>(film);
    case FilmFormat::mjpeg: return make<MjpegEncoder>(film);
    case FilmFormat::mp4: return std::make_unique<Mp4Encoder>(film, tools);
  }
  return nullptr;
}

}  // namespace tia::server
