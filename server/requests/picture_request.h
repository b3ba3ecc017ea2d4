// The parameters of /render.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/film/display.h"
#include "core/render/layers.h"
#include "core/render/render.h"
#include "server/requests/view_request.h"

namespace tia::server {

enum class Format { png, pfm, hdr, tiff, exr, zip };

/// FormatRow: what a format is called, in requests and as a file's ending, and over HTTP.
struct FormatRow {
  Format format;
  std::string_view name, media_type;
  bool has_alpha = false;
  bool holds_codes = false;  ///< keeps what is shown, not light
};

/// THE LIST of formats. Of those that a client likes equally well the first is given.
inline constexpr std::array formats = std::to_array<FormatRow>({
    {Format::png, "png", "image/png", true, true},
    {Format::pfm, "pfm", "image/x-portable-floatmap"},
    {Format::hdr, "hdr", "image/vnd.radiance"},
    {Format::tiff, "tiff", "image/tiff"},
    {Format::exr, "exr", "image/x-exr", true},
    {Format::zip, "zip", "application/zip", true, true},
});
static_assert(
    [] {
      for (std::size_t i = 0; i < formats.size(); ++i)
        if (static_cast<std::size_t>(formats[i].format) != i) return false;
      return true;
    }(),
    "the rows stand in the order of the formats, one a format");

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Format> {
  static constexpr auto names = [] {
    std::array<std::string_view, server::formats.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = server::formats[i].name;
    return all;
  }();
};

namespace tia::server {

/// PictureRequest: the parameters of /render.
struct PictureRequest : TraceRequest {
  static constexpr std::string_view schema_name = "picture_request";
  std::optional<std::array<int, 4>> crop;
  std::optional<Transfer> transfer;
  std::optional<double> exposure, white_balance_kelvin;
  std::optional<double> noise;
  bool denoise = false;
  std::optional<int> budget_ms;
  std::optional<std::int64_t> max_rays;
  std::optional<int> frame_ms;
  Format format = Format::png;
  std::optional<std::array<double, 2>> depth_range;
  std::optional<std::vector<Layer>> aov;
  std::optional<int> depth;
  std::optional<int> threads;
  std::optional<std::string> v;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using P = PictureRequest;
    TraceRequest::fields(visit);
    visit("crop", &P::crop,
          Spec{.about = "x0,y0,x1,y1: the window x0 <= x < x1, y0 <= y < y1 of the whole picture",
               .unit = "pixels",
               .min = 0,
               .max = most_px});
    visit("transfer", &P::transfer,
          Spec{.about = "curve from linear light to stored codes; aces and agx show light of any "
                        "brightness; else the scene's"});
    visit("exposure", &P::exposure,
          Spec{.about = "light is shown 2^exposure times as bright; else as the scene says",
               .unit = "stops",
               .min = -SceneOptions::most_stops,
               .max = SceneOptions::most_stops});
    visit(
        "white_balance_kelvin", &P::white_balance_kelvin,
        Spec{.about = "the white that is shown neutral: a black body's, from 5000 K on daylight's; "
                      "else as the scene says",
             .unit = "K",
             .min = SceneOptions::coldest_white,
             .max = SceneOptions::hottest_white});
    visit(
        "noise", &P::noise,
        Spec{.about = "where rays are chance: a pixel has samples until the standard error of what "
                      "is shown, in 0 to 1, is below this, and at most as many as samples says, "
                      "else 4096; 0 is off; else as the scene says",
             .min = 0,
             .max = 1});
    visit("denoise", &P::denoise,
          Spec{.about = "whether noise is taken off the picture, which is then no longer the mean "
                        "of its samples: of light, with more than one sample a pixel"});
    visit(
        "budget_ms", &P::budget_ms,
        Spec{.about = "where rays are chance: how long the picture may be traced; it is what the "
                      "rounds of 16, 32, 64 ... samples within that come to, and Content-Location "
                      "names it",
             .unit = "ms",
             .min = 1,
             .max = 3'600'000});
    visit("max_rays", &P::max_rays,
          Spec{.about = "the same in rays of all kinds", .min = 1, .max = 9007199254740991});
    visit("frame_ms", &P::frame_ms,
          Spec{.about = "of a gaze: how long the picture may be traced; gaze_rays is what this "
                        "scene's rays have taken lately allows, and Content-Location names it",
               .unit = "ms",
               .min = 1,
               .max = 3'600'000});
    visit(
        "format", &P::format,
        Spec{.about =
                 "png; for linear light pfm or tiff in float, hdr in Radiance's RGBE, or exr "
                 "in OpenEXR's layers; zip: a PNG of each view, and views.json, which tells where "
                 "their eyes and windows are; else what Accept prefers"});
    visit("depth_range", &P::depth_range,
          Spec{.about = "near,far: in numbers of depth and planar_depth what is nearer is 0, and "
                        "what is farther infinite",
               .min = 0,
               .max = 1e9});
    visit("aov", &P::aov,
          Spec{.about = "the layers of an exr, each once; else rgba. normal, albedo, Z and object "
                        "are the pictures that such integrators draw (Z: depth); direct, indirect "
                        "and emission part path's light by how it came; variance is that of the "
                        "pixel's mean, samples how many it has",
               .min_items = 1});
    visit("depth", &P::depth,
          Spec{.about = "16 or 32: an exr's rgba in half or in float; else 16",
               .unit = "bits",
               .min = 16,
               .max = 32});
    visit("threads", &P::threads,
          Spec{.about = "most threads for this picture; never changes it", .min = 1, .max = 64});
    visit("v", &P::v,
          Spec{.about = "the version whose bytes are wanted, as /version tells it: caches may keep "
                        "the picture for good"});
  }
  /// Whether it may end before all samples are there.
  bool has_budget() const { return budget_ms || max_rays; }
  /// Also a crop that is empty, a version that is not this one, a range of
  /// depths the wrong way round, what is an exr's alone.
  void check(const Place& at, Faults& faults) const;
  Window window() const;
  /// Those of an exr.
  LayerSet layers_in_effect() const;

 private:
  void check_exr(const Place& at, Faults& faults) const;
};

/// "png or exr": those that have alpha.
std::string alpha_formats();
constexpr bool has_alpha(Format format) {
  return formats[static_cast<std::size_t>(format)].has_alpha;
}
constexpr bool holds_codes(Format format) {
  return formats[static_cast<std::size_t>(format)].holds_codes;
}
/// "image/png" or the like.
constexpr std::string_view media_type_of(Format format) {
  return formats[static_cast<std::size_t>(format)].media_type;
}

}  // namespace tia::server
