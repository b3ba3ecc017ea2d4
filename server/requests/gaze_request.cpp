#include "server/requests/gaze_request.h"

#include <algorithm>
#include <cstdio>

#include "core/input/codec.h"
#include "core/render/gaze_slope.h"

namespace tia::server {
namespace {

template <class T>
void refuse_beside_gaze(const char* name, const T& got, const char* allowed) {
  throw InputError({FaultKind::conflict, std::string("/") + name, write_value(got), allowed});
}

void check_gaze_is_asked(const TraceRequest& asked) {
  if (asked.gaze) return;
  constexpr const char* allowed = "a picture for a gaze, which says where the eye looks";
  if (asked.gaze_rays) refuse_beside_gaze("gaze_rays", *asked.gaze_rays, allowed);
  if (asked.acuity) refuse_beside_gaze("acuity", *asked.acuity, allowed);
}

void check_view_for_gaze(const TraceRequest& asked, const View& view) {
  if (view.projection != Projection::perspective)
    refuse_beside_gaze("gaze", *asked.gaze, "a perspective camera, whose pixels are angles");
  if (view.has_lens())
    refuse_beside_gaze("gaze", *asked.gaze, "a camera without aperture, all of whose rays meet");
}

// Errors: InputError (conflict) for what needs all pixels of a picture, or ends by itself.
void check_beside_gaze(const PictureRequest& asked, const Plan& plan) {
  if (asked.denoise)
    refuse_beside_gaze("denoise", true, "no gaze: the denoiser needs all pixels' samples");
  if (asked.budget_ms)
    refuse_beside_gaze("budget_ms", *asked.budget_ms, "frame_ms for a gaze, or no gaze");
  if (asked.max_rays)
    refuse_beside_gaze("max_rays", *asked.max_rays, "gaze_rays for a gaze, or no gaze");
  if (plan.layers != LayerSet{} && plan.layers != LayerSet{Layer::rgba})
    refuse_beside_gaze("aov", asked.aov, "the layer rgba for a gaze, or no gaze");
  if (plan.exposure.blurs())
    refuse_beside_gaze("gaze", *asked.gaze,
                       "a picture of one moment; this one's scene has a shutter (blur_steps=1 "
                       "closes it)");
}

// What looking at the pixels near the gaze goes through.
std::size_t bytes_near(const Gaze& gaze, const View& view, const Window& window) {
  const Window near = around_gaze(GazeFrame(view, gaze.x, gaze.y), gaze.acuity, window);
  return 3 * static_cast<std::size_t>(near.width()) * static_cast<std::size_t>(near.height());
}

Gaze asked_gaze(const TraceRequest& asked) {
  return {(*asked.gaze)[0], (*asked.gaze)[1], asked.acuity.value_or(Acuity{})};
}
Window whole(const View& view) { return {0, 0, view.width, view.height}; }

constexpr const char* known_rays =
    "threshold=0&noise=0, for nobody knows beforehand how many samples they take";

double slope_within(const GazeLimit& limit, std::int64_t rays, int samples) {
  if (samples == 0) refuse_beside_gaze("gaze_rays", rays, known_rays);
  if (const auto slope = limit.slope_within(rays / samples)) return *slope;
  const std::int64_t least = limit.count(Acuity::most_slope).all() * samples;
  throw InputError({FaultKind::limit, "/gaze_rays", write_value(rays),
                    "at least " + std::to_string(least) + ", for even at the greatest slope, " +
                        std::to_string(static_cast<int>(Acuity::most_slope)) +
                        ", the picture has as many"});
}

}  // namespace

int most_samples(const RenderOptions& options) {
  return options.threshold > 0 || options.noise > 0 ? 0 : options.samples;
}

std::optional<GazeInEffect> gaze_of(const TraceRequest& asked, const View& view,
                                    const Window& window, int samples, const RenderContext& context,
                                    const Requester& requester) {
  check_gaze_is_asked(asked);
  if (!asked.gaze) return std::nullopt;
  check_view_for_gaze(asked, view);
  GazeInEffect found{asked_gaze(asked), {}};
  context.go_through(bytes_near(found.gaze, view, whole(view)), requester, [&] {
    if (asked.gaze_rays)
      found.gaze.acuity.slope =
          slope_within(GazeLimit(view, found.gaze, whole(view)), *asked.gaze_rays, samples);
    found.count = GazeLimit(view, found.gaze, window).count(found.gaze.acuity.slope);
    return 0;
  });
  return found;
}

void plan_gaze(const RenderContext& context, const Requester& requester, Plan& plan) {
  const PictureRequest& asked = *plan.asked;
  if (asked.frame_ms) {
    check_frame_ms(asked);
    refuse_beside_gaze("frame_ms", *asked.frame_ms,
                       "gaze_rays, or a picture of /render, whose server knows how fast it traces");
  }
  const auto found =
      gaze_of(asked, plan.view, plan.window, most_samples(plan.options), context, requester);
  if (!found) return;
  check_beside_gaze(asked, plan);
  plan.options.gaze = found->gaze;
  plan.gaze = found->count;
}

std::int64_t rays_in_time(int ms, const Plan& plan, CostMemory& costs) {
  constexpr double some = 1e6;
  const Cost cost = costs.of(plan.cost_key, some);
  const double seconds_each = cost.is_known ? cost.seconds / some : Cost::usual_ray;
  const double rays = ms * 1e-3 * plan.options.threads / seconds_each;
  const GazeLimit limit(plan.view, *plan.options.gaze, whole(plan.view));
  const int samples = most_samples(plan.options);
  if (samples == 0) refuse_beside_gaze("frame_ms", ms, known_rays);
  const std::int64_t least = limit.count(Acuity::most_slope).all() * samples;
  const std::int64_t most = limit.count(plan.options.gaze->acuity.slope).all() * samples;
  return std::clamp(static_cast<std::int64_t>(std::min(rays, 1e15)), least, std::max(least, most));
}

void check_frame_ms(const PictureRequest& asked) {
  if (!asked.gaze)
    refuse_beside_gaze("frame_ms", *asked.frame_ms,
                       "a picture for a gaze, which says where the eye looks");
}

std::string gaze_told(const Plan& plan) {
  char text[128];
  const Window& window = plan.window;
  std::snprintf(text, sizeof text, "slope=%.6g, fovea=%lld, periphery=%lld, full=%lld",
                plan.options.gaze->acuity.slope, static_cast<long long>(plan.gaze->fovea),
                static_cast<long long>(plan.gaze->periphery),
                static_cast<long long>(window.width()) * window.height());
  return text;
}

void check_fovea(const Gaze& gaze, const View& view, int x, int y) {
  const GazeFrame frame(view, gaze.x, gaze.y);
  if (gaze.acuity.slope <= last_slope_of(frame, gaze.acuity.w0(), x, y)) return;
  refuse_beside_gaze("gaze", std::array{gaze.x, gaze.y},
                     "a pixel of the fovea, which has rays of its own; this one is filled from the "
                     "four rays of the rings around it");
}

}  // namespace tia::server
