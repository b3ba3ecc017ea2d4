// A picture as it is asked for, and as it is made: the pipeline
//   PictureRequest -> Plan -> World -> film -> bytes
// that /render and `tia render` share.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "core/core.h"
#include "server/view_request.h"

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

/// Where a picture's time went, in ms.
struct Timing {
  double queue = 0, wait = 0, parse = 0, build = 0, trace = 0, encode = 0;  ///< wait: for memory
};

/// Picture: the bytes of an image file and what they cost.
struct Picture {
  std::string bytes;
  std::string_view media_type;
  RayCounts rays;
  Timing timing;
  std::size_t degenerate = 0;  ///< triangles without area, which were left out
  double trace_seconds = 0;    ///< of all threads that traced it
};

/// "image/png" or the like.
std::string_view media_type_of(Format format);

/// Plan: a request whose picture can be drawn: all that may be wrong with it has been checked.
struct Plan {
  KnownScene scene;
  View view;
  Window window;
  RenderOptions options;
  DisplayRule display;
  Format format = Format::png;
  std::string recipe = {};  ///< what POST /render would draw the same picture from (recipe.h)

  /// The fewest rays that the eye sends out.
  double rays() const;
};

/// Errors: InputError; as scene_of. The plan may refer to the request.
Plan plan_of(const PictureRequest& asked, const Studio& studio, const Asker& asker);

/// Makes the picture, which carries its recipe if it is a PNG. Before each step it reserves the
/// memory that it may take. Errors: InputError; Stopped; as MemoryClaim::reserve.
Picture draw(const Plan& plan, const Studio& studio, const std::stop_token& stop);

}  // namespace tia::server
