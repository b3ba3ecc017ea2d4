// What a request for a gaze comes to: where the eye looks, and with which acuity.
#pragma once

#include "server/operation/cost_memory.h"
#include "server/requests/plan.h"
#include "server/requests/render_context.h"

namespace tia::server {

/// GazeInEffect: the gaze with the slope that keeps to gaze_rays, and its points of the window.
struct GazeInEffect {
  Gaze gaze;
  GazeCount count;
};

/// The gaze that is asked for. `samples`: the most rays that a point has.
/// Errors: InputError: conflict at /gaze for a view that is no plain perspective one, at the others
/// where there is no gaze, at /gaze_rays for samples of an unknown number; limit there below what
/// the greatest slope takes. As RenderContext::go_through.
std::optional<GazeInEffect> gaze_of(const TraceRequest& asked, const View& view,
                                    const Window& window, int samples, const RenderContext& context,
                                    const Requester& requester);

/// The most rays that a point has; 0: nobody knows beforehand.
int most_samples(const RenderOptions& options);

/// Puts it into a plan. Errors: the same; conflict at what is asked for beside it and is of whole
/// pictures alone.
void plan_gaze(const RenderContext& context, const Requester& requester, Plan& plan);

/// How many rays its threads trace in that time, by what this scene's have taken, and at least as
/// many as gaze_rays may be. Domain: a plan for a gaze, of no such number.
std::int64_t rays_in_time(int ms, const Plan& plan, CostMemory& costs);
/// Errors: InputError (conflict) at /frame_ms without a gaze.
void check_frame_ms(const PictureRequest& asked);

/// "slope=0.022, fovea=5821, periphery=10230, full=307200". Domain: a plan for a gaze.
std::string gaze_told(const Plan& plan);

/// Errors: InputError (conflict) at /gaze where a pixel has no ray of its own.
void check_fovea(const Gaze& gaze, const View& view, int x, int y);

}  // namespace tia::server
