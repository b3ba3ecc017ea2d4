// What may be asked of a picture over HTTP alone: how it comes.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "server/requests/picture_request.h"

namespace tia::server {

/// Stream: how a picture comes that is shown while it is drawn.
enum class Stream { multipart, events };
/// RenderStream: the same of /render, whose scene may also be changed while it is looked at.
enum class RenderStream { multipart, events, mjpeg };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Stream> {
  static constexpr std::array<std::string_view, 2> names{"multipart", "events"};
};
template <>
struct tia::Names<tia::server::RenderStream> {
  static constexpr std::array<std::string_view, 3> names{"multipart", "events", "mjpeg"};
};

namespace tia::server {

/// RenderRequest: the parameters of /render.
struct RenderRequest : PictureRequest {
  std::optional<RenderStream> stream;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    PictureRequest::fields(visit);
    visit(
        "stream", &RenderRequest::stream,
        Spec{.about = "the picture while it is drawn, a PNG: multipart, one whole picture after "
                      "the other, as browsers show them; or events, server-sent, which tell where "
                      "each is. The last is the picture. Or mjpeg, JPEGs of the scene as POST "
                      "/streams/{id} changes it"});
  }
};

/// KeptPictureRequest: the parameters of /pictures/{etag}.
struct KeptPictureRequest {
  static constexpr std::string_view schema_name = "kept_picture_request";
  std::optional<Stream> stream;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("stream", &KeptPictureRequest::stream,
          Spec{.about = "as of /render; also of a picture that is being drawn"});
  }
};

}  // namespace tia::server
