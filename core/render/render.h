// World -> picture: tiles over threads. A pixel depends on nothing but the world, the view and
// itself: not on threads, tile size, window or lanes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/accel/world/world.h"
#include "core/film/image.h"
#include "core/parallel/pool.h"
#include "core/render/budget.h"
#include "core/render/gaze.h"
#include "core/render/instant.h"
#include "core/render/reached.h"
#include "core/render/trace_tile.h"
#include "core/render/window.h"
#include "core/scene/limits.h"

namespace tia {

/// Takes finished tiles, in window coordinates, from several threads at once, each pixel in exactly
/// one tile.
using Develop = std::function<void(const FilmTile&)>;

/// Glimpse: what there is of a picture that is not done yet.
struct Glimpse {
  /// One ray for each block of pixels, one sample a pixel, or what is not denoised as it will be.
  bool is_preview = false;
  RayCounts rays = {};    ///< without those of the preview by blocks
  RayCounts before = {};  ///< those of them that RenderOptions::from had taken
  /// Hands over all tiles; of the preview by blocks, layers beside its light are 0.
  /// Returns: how far they have come. Errors: as render().
  std::function<Reached(const Develop&)> show;
};

class KeptRounds;
using SharedRounds = std::shared_ptr<const KeptRounds>;
/// Given the rounds of a render that is stopped, where any of its tiles has had one: those of the
/// tiles that were under way are lost.
using Leave = std::function<void(SharedRounds)>;

/// Told between rounds, by the thread that renders, of what there is by then: at first of a coarse
/// preview, which is traced once it is shown.
using Watch = std::function<void(const Glimpse&)>;

struct RenderOptions {
  IntegratorName integrator = IntegratorName::thesis;
  int max_depth = row_of(IntegratorName::whitted).max_depth;
  double ao_radius = Rules{}.ao_radius;  ///< of ambient_occlusion, in scene units
  double clamp = Rules{}.clamp;          ///< the most of a channel of a sample of path
  int threads = 1;
  int tile = FilmTile::size;  ///< pixels a side, at most FilmTile::size
  Scalar scalar = Scalar::wide;
  int samples = 1;       ///< rays a pixel, 1 .. 65536; 1 goes through the centre of pixel and lens
  double threshold = 0;  ///< what the standard error of a pixel may be, 0 .. 1; 0: any
  double noise = 0;      ///< the same of what is shown by `tone`, 0 .. 1 (Convergence)
  Tone tone = {};        ///< how the picture is going to be shown
  std::int64_t seed = 0;
  int blur_steps = 1;                         ///< strata of the open time, 1 .. samples
  std::int64_t max_rays = Limits{}.max_rays;  ///< of all kinds, of the whole window
  std::int64_t max_work = Limits{}.max_work;  ///< of the whole window
  /// Whether noise is taken off it (core/film/denoise.h), for which denoise_margin more pixels are
  /// traced on every side where the picture goes on. Domain: an integrator that gathers light, and
  /// more than one sample
  bool denoise = false;
  LayerSet layers = {};  ///< what else tiles are to tell, by FilmTile::more (planes_of)
  /// For an eye that looks there: the fovea alone is traced pixel by pixel (GazePicture). Nobody
  /// watches then. Domain: a perspective view of one time, a pinhole; without denoiser, budget and
  /// layers.
  std::optional<Gaze> gaze = {};
  std::optional<Budget> budget = {};  ///< ends it after a whole round. Domain: of chance
  Spent spent = {};
  Watch watch = {};  ///< changes no pixel of the picture, only the order of work; none: nobody
  /// What a render of the same picture was left with, of which only samples, the budget, who
  /// watches and threads may differ: it goes on from there, to the same bytes and rays, unless the
  /// other had more samples or took more rays than it may. Domain, of both: of chance, without
  /// threshold and denoiser; else they are passed over.
  SharedRounds from = {};
  Leave leave = {};      ///< told where rounds go over the whole picture; none: nothing is kept
  Flow* flow = nullptr;  ///< the request that it is drawn for; null: one of its own
};

/// What the integrator follows of that.
inline Rules rules_of(const RenderOptions& options) {
  return rules_of(
      options.integrator,
      {.max_depth = options.max_depth, .ao_radius = options.ao_radius, .clamp = options.clamp});
}

struct Rendered {
  RayCounts rays;                       ///< of whole rounds
  std::optional<Reached> reached = {};  ///< where noise or a budget is given, or somebody watches
  RayCounts before = {};                ///< those of `rays` that RenderOptions::from had taken
};

/// Traces the window and hands each finished tile to `develop`. `instants`: as many as
/// options.blur_steps; the views are the scene's.
/// Errors: Stopped when `stop` is requested; InputError of one `limit` fault, at /samples when more
/// than max_rays are traced, at /scene when more than max_work is done. They come between tiles, or
/// within one that takes long. BudgetSpent. What options.spent throws.
Rendered render(Instants instants, const Window& window, const RenderOptions& options, Pool& pool,
                const std::stop_token& stop, const Develop& develop);
/// The same of one time.
inline Rendered render(const World& world, const View& view, const Window& window,
                       const RenderOptions& options, Pool& pool, const std::stop_token& stop,
                       const Develop& develop) {
  const Instant at{world, view};
  return render({&at, 1}, window, options, pool, stop, develop);
}

}  // namespace tia
