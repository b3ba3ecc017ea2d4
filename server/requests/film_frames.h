// The frames of a film one after the other: what consecutive ones share.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/scene/moments.h"
#include "server/requests/draw.h"
#include "server/requests/film_request.h"
#include "server/stores/objects_parts.h"

namespace tia::server {

/// FilmFrames. Where few of many objects move, and nothing blurs, what does not move is neither
/// copied nor digested again, and what the frame before compiled to is changed. The pictures are
/// those of each moment by itself, bit for bit.
class FilmFrames {
 public:
  /// The film's scene, in motion or still. Both outlive it.
  FilmFrames(FilmRequest& asked, const KnownScene& scene);
  FilmFrames(const FilmFrames&) = delete;
  FilmFrames& operator=(const FilmFrames&) = delete;

  /// The plan of the frame at that time. It refers to the request, which is set to the time, and is
  /// over before that of another frame is drawn. Errors: as plan_of.
  Plan plan_at(double seconds, const RenderContext& context, const Requester& requester);
  /// The picture of such a plan. Errors: as draw().
  Picture draw(const Plan& plan, const RenderContext& context, const std::stop_token& stop);

 private:
  KnownScene scene_at(double seconds, const RenderContext& context, const Requester& requester);
  World world_of(const Plan& plan, const RenderContext& context, const Workers& workers);
  bool fit_to(const KnownScene& scene, const Workers& workers);

  FilmRequest& asked_;
  const KnownScene& moving_;
  std::optional<Moments> moments_;  // none: it stands still, or much of it moves
  ObjectsParts parts_;
  SharedGeometry first_;           // of the first frame that was drawn
  std::shared_ptr<Geometry> own_;  // of the one drawn last, after that
};

}  // namespace tia::server
