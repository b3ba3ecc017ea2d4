// The parameters of /film.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/film/jpeg.h"
#include "server/operation/memory_costs.h"
#include "server/requests/picture_request.h"

namespace tia::server {

enum class FilmFormat { apng, webp, webm, zip, mjpeg, mp4 };

/// FilmFormatRow: what a format of films is called, in requests and as a file's ending, and over
/// HTTP. How one is made stands in film_encoders.cpp.
struct FilmFormatRow {
  FilmFormat format;
  std::string_view name, media_type;
  bool has_alpha = true;
  bool takes_codes = false;  ///< of pixels, where others take PNG files
  int longest_side = static_cast<int>(PictureRequest::most_px);
  bool is_live = false;              ///< over HTTP its frames come at their times
  const MemoryCost* cost = nullptr;  ///< of an encoder that keeps much from frame to frame
};

/// THE LIST of formats of films. Of those that a client likes equally well the first is given.
inline constexpr std::array film_formats = std::to_array<FilmFormatRow>({
    {FilmFormat::apng, "apng", "image/apng"},
    {FilmFormat::webp, "webp", "image/webp", true, true, 16'383, false, &memory_cost::webp},
    {FilmFormat::webm, "webm", "video/webm", false, true, 16'384, false, &memory_cost::webm},
    {FilmFormat::zip, "zip", "application/zip"},
    {FilmFormat::mjpeg, "mjpeg", "multipart/x-mixed-replace", false, true, longest_jpeg_side, true},
    {FilmFormat::mp4, "mp4", "video/mp4", false, true, 16'384},
});
constexpr const FilmFormatRow& row_of(FilmFormat format) {
  return film_formats[static_cast<std::size_t>(format)];
}
static_assert(
    [] {
      for (const FilmFormatRow& row : film_formats)
        if (&row_of(row.format) != &row) return false;
      return true;
    }(),
    "the rows stand in the order of the formats, one a format");

}  // namespace tia::server

template <>
struct tia::Names<tia::server::FilmFormat> {
  static constexpr auto names = [] {
    std::array<std::string_view, server::film_formats.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = server::film_formats[i].name;
    return all;
  }();
};

namespace tia::server {

/// FilmRequest: the parameters of each frame, which are /render's, and which frames there are.
struct FilmRequest : PictureRequest {
  static constexpr std::string_view schema_name = "film_request";
  static constexpr double slowest_fps = 0.001;  // a frame lasts a quarter of an hour at most
  FilmFormat film_format = FilmFormat::apng;
  std::optional<double> from, to, fps;

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// As a picture's; and a film that ends before it begins.
  void check(const Place& at, Faults& faults) const;
};

/// Whether frames have that parameter of /render, too: a film chooses its moments, its frames are
/// PNGs, and are the same whoever draws them.
bool frames_have(std::string_view parameter);

/// Visitor: hands on the parameters that frames have.
template <class Visitor>
struct FrameFields {
  Visitor& visit;
  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) const {
    if (frames_have(name)) visit(name, member, spec);
  }
};

template <class Visitor>
void FilmRequest::fields(Visitor&& visit) {
  using F = FilmRequest;
  PictureRequest::fields(FrameFields<std::remove_reference_t<Visitor>>{visit});
  constexpr Spec seconds{.unit = "s", .min = 0, .max = 86400};
  Spec from = seconds, to = seconds;
  from.about = "the frames from this time on; else from the beginning";
  to.about = "the frames before this time; else to the end";
  visit("from", &F::from, from);
  visit("to", &F::to, to);
  visit("fps", &F::fps,
        Spec{.about = "frames a second: frame k is at time k / fps; else as the animation says",
             .min = slowest_fps,
             .max = 1000});
  visit(
      "format", &F::film_format,
      Spec{.about = "apng or webp, whose pixels are /render's; webm, a video in VP9; zip, of "
                    "/render's PNGs with a film.json that tells their times and tags; mjpeg, live: "
                    "JPEGs at their times, late ones left out; mp4, a video in H.264, where the "
                    "server has ffmpeg (TIA_FFMPEG); else what Accept prefers"});
}

}  // namespace tia::server
