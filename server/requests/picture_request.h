// The parameters of /render.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/film/display.h"
#include "core/render/render.h"
#include "server/requests/view_request.h"

namespace tia::server {

enum class Format { png, pfm };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Format> {
  static constexpr std::array<std::string_view, 2> names{"png", "pfm"};
};

namespace tia::server {

/// PictureRequest: the parameters of /render.
struct PictureRequest : TraceRequest {
  static constexpr std::string_view schema_name = "picture_request";
  std::optional<std::array<int, 4>> crop;
  std::optional<Transfer> transfer;
  Format format = Format::png;
  std::optional<int> threads;
  std::optional<std::string> v;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using P = PictureRequest;
    TraceRequest::fields(visit);
    visit("crop", &P::crop,
          Spec{.about = "x0,y0,x1,y1: the window x0 <= x < x1, y0 <= y < y1 of the picture",
               .unit = "pixels",
               .min = 0,
               .max = most_px});
    visit("transfer", &P::transfer,
          Spec{.about = "curve from linear light to stored codes; else the scene's"});
    visit("format", &P::format,
          Spec{.about = "png, or pfm for linear light in float; else what Accept prefers"});
    visit("threads", &P::threads,
          Spec{.about = "most threads for this picture; never changes it", .min = 1, .max = 64});
    visit("v", &P::v,
          Spec{.about = "the version whose bytes are wanted, as /version tells it: caches may keep "
                        "the picture for good"});
  }
  /// Also a crop that is empty or leaves the picture, a version that is not this one.
  void check(const Place& at, Faults& faults) const;
  Window window() const;
};

/// "image/png" or the like.
std::string_view media_type_of(Format format);

}  // namespace tia::server
