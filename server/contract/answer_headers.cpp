#include "server/contract/answer_headers.h"

namespace tia::server {

const std::vector<HeaderRow>& header_rows() {
  static const std::vector<HeaderRow> rows{
      {"Accept-Encoding", "the content codings that a body may have (RFC 9110, 12.5.3)",
       "^identity$", false},
      {"Allow", "the methods that the path takes", "^[A-Z]+(, [A-Z]+)*$"},
      {"Cache-Control", "whether and how long the answer may be kept (RFC 9111, 5.2.2)",
       "^[a-z-]+(=[0-9]+)?(, [a-z-]+(=[0-9]+)?)*$"},
      {"Cache-Status", "whether the picture was drawn for this request (RFC 9211)",
       "^Tia(; (hit|fwd=miss|fwd=partial|collapsed|stored|detail=not-modified))+$"},
      {"Content-Disposition",
       "of a quilt: the file name by which its viewers know how many views it has; of an archive: "
       "its name",
       "^(inline|attachment); filename=\"[A-Za-z0-9_.-]+\"$", false},
      {"Content-Encoding", "how the body is compressed, where Accept-Encoding takes that", "^gzip$",
       false},
      {"Content-Location",
       "of a picture with a budget or frame_ms: the address that gives the same bytes without; of "
       "a still "
       "whose model was sent: that of the same still by the model's id",
       "^/(render|still)\\?", false},
      {"ETag", "the tag of the body's bytes, for If-None-Match; of a picture its recipe's SHA-256",
       "^\"[^\"]+\"$"},
      {"Location", "where what this is about is", "^/"},
      {"Preference-Applied", "which of the request's Prefer has been done (RFC 7240)",
       "^(respond-async|wait=[0-9]+)$", false},
      {"RateLimit",
       "of a key with quotas: how many requests (at once) and rays (today) it has left, r, and the "
       "seconds until it has all of them again, t (draft-ietf-httpapi-ratelimit-headers-10)",
       "^\"(requests|rays)\";r=[0-9]+;t=[0-9]+(, \"rays\";r=[0-9]+;t=[0-9]+)?$", false},
      {"RateLimit-Policy", "the quotas themselves, q, and the seconds that they are for, w",
       "^\"(requests|rays)\";q=[0-9]+;w=[0-9]+(, \"rays\";q=[0-9]+;w=[0-9]+)?$", false},
      {"Retry-After", "the seconds after which to ask again", "^[1-9][0-9]*$"},
      {"Server-Timing", "where the time went, in ms (W3C Server Timing)",
       "^[a-z]+(;desc=[a-z]+)?;dur=[0-9.]+(, [a-z]+(;desc=[a-z]+)?;dur=[0-9.]+)*$"},
      {"Tia-Biased", "what made the picture another than the true one: options.clamp of its scene",
       "^clamp$", false},
      {"Tia-Frames",
       "how many pictures a film needs, and how many of its frames show the one before; still: the "
       "scene does not move",
       "^drawn=[0-9]+, shared=[0-9]+(, still)?$", false},
      {"Tia-Gaze",
       "of a picture for a gaze: the slope of its acuity, the pixels of the fovea, the rays of the "
       "rings around it, and the pixels of the picture",
       "^slope=[0-9.e-]+, fovea=[0-9]+, periphery=[0-9]+, full=[0-9]+$", false},
      {"Tia-Ignored",
       "what the integrator leaves out of the scene: JSON Pointers, of which /explain tells why",
       "^/[a-z_/]+(, /[a-z_/]+)*$", false},
      {"Tia-Rays",
       "how many rays of each kind were traced, exactly; of path's, cut ended by max_depth",
       "^primary=[0-9]+, shadow=[0-9]+, reflection=[0-9]+, refraction=[0-9]+(, cut=[0-9]+)?$"},
      {"Tia-Noise",
       "the largest standard error of a pixel as it is shown, where noise or a budget is given",
       "^[01]\\.[0-9]{6}$", false},
      {"Tia-Samples", "the samples of a pixel, where noise or a budget is given",
       "^min=[0-9]+, mean=[0-9.]+, max=[0-9]+$", false},
      {"Tia-Delete-Key",
       "with this DELETE forgets the scene again; none where 64 have kept it before",
       "^[0-9a-f]{32}$", false},
      {"Vary", "the request's fields on which the answer depends", "^[A-Za-z-]+(, [A-Za-z-]+)*$",
       false},
      {"WWW-Authenticate", "how to say who asks (RFC 6750)",
       "^Bearer realm=\"tia\"(, error=\"invalid_token\")?$"},
      {"X-Accel-Buffering", "of streams: that no proxy is to hold parts back", "^no$", false},
      {"X-Request-Id",
       "the request's id: the client's own, where it is fit for a log, or a new one",
       "^[A-Za-z0-9._-]{1,64}$"},
      {"traceparent",
       "where the request has a valid one: its trace, and the id of what this answer took part in "
       "it (W3C Trace Context)",
       "^00-[0-9a-f]{32}-[0-9a-f]{16}-0[0-3]$", false},
  };
  return rows;
}

}  // namespace tia::server
