// A picture as it is asked for, and as it is made: the pipeline
//   PictureRequest -> Scene -> World -> film -> bytes
// that /render and `tia render` share.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "core/core.h"
#include "server/gallery.h"

namespace tia::server {

enum class Format { png, pfm };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Format> {
  static constexpr std::array<std::string_view, 2> names{"png", "pfm"};
};

namespace tia::server {

/// PictureRequest: the parameters of /render, in one table for query, JSON body and command line.
struct PictureRequest {
  static constexpr double most_px = 16'777'216;
  std::variant<std::string, Scene> scene = "thesis";
  std::optional<std::string> key;
  std::optional<Vec3d> light;
  int width = 640, height = 480;
  std::optional<std::array<int, 4>> crop;
  std::optional<IntegratorName> integrator;
  std::optional<Transfer> transfer;
  Format format = Format::png;
  std::optional<std::int64_t> seed;
  std::optional<int> threads;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using P = PictureRequest;
    visit("scene", &P::scene, Spec{.about = "a scene's name, or a whole scene"});
    visit("key", &P::key, Spec{.about = "the key that is pressed: it moves the scene's light"});
    visit("light", &P::light,
          Spec{.about = "where to put the scene's key light", .min = -1e9, .max = 1e9});
    visit("width", &P::width,
          Spec{.about = "the picture's width", .unit = "pixels", .min = 1, .max = most_px});
    visit("height", &P::height,
          Spec{.about = "the picture's height", .unit = "pixels", .min = 1, .max = most_px});
    visit("crop", &P::crop,
          Spec{.about = "x0,y0,x1,y1: the window x0 <= x < x1, y0 <= y < y1 of the picture",
               .unit = "pixels",
               .min = 0,
               .max = most_px});
    visit("integrator", &P::integrator, Spec{.about = "how light is gathered"});
    visit("transfer", &P::transfer, Spec{.about = "curve from linear light to stored codes"});
    visit("format", &P::format, Spec{.about = "png, or pfm for linear light in float"});
    visit("seed", &P::seed,
          Spec{.about = "the random stream", .min = 0, .max = SceneOptions::last_seed});
    visit("threads", &P::threads,
          Spec{.about = "most threads for this picture; never changes it", .min = 1, .max = 64});
  }
  /// key with light; a crop that is empty or leaves the picture.
  void check(const Place& at, Faults& faults) const;
  Window window() const;
};

/// Where a picture's time went, in ms.
struct Timing {
  double queue = 0, parse = 0, build = 0, trace = 0, encode = 0;
};

/// Picture: the bytes of an image file and what they cost.
struct Picture {
  std::string bytes;
  std::string_view media_type;
  RayCounts rays;
  Timing timing;
};

/// "image/png" or the like.
std::string_view media_type_of(Format format);

/// What every picture needs of its host.
struct Studio {
  const Gallery& gallery;
  Pool& pool;
  Limits limits;
};

/// The scene that is asked for, its key pressed or its light moved. Errors: InputError.
Scene scene_of(const PictureRequest& asked, const Gallery& gallery);

/// Makes the picture. Errors: InputError; Stopped.
Picture draw(const PictureRequest& asked, const Studio& studio, const std::stop_token& stop);

}  // namespace tia::server
