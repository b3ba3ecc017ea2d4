// A picture as OpenEXR's layers: which are asked for and how they are drawn.
#pragma once

#include "core/render/layer_film.h"
#include "server/requests/parts.h"
#include "server/requests/plan.h"
#include "server/requests/render_context.h"

namespace tia::server {

/// What a picture with layers may not be. Domain: a plan that has its options.
/// Errors: InputError (conflict) below /aov; limit where the layers take too many rays.
void check_layers(const Plan& plan, const Limits& limits);

/// ExrPicture: a film for it.
class ExrPicture {
 public:
  explicit ExrPicture(const Plan& plan)
      : plan_(plan),
        film_(plan.window.width(), plan.window.height(), plan.layers,
              is_transparent(*plan.scene, plan.options.integrator)) {}

  void put(const FilmTile& tile) { film_.put(tile); }
  /// Draws a part's layers that other integrators draw, once it is known how far a budget has
  /// reached: as their pictures of the same request, with as many samples; where noise decides of
  /// these, with no more than a first round has. Returns: their rays. Errors: as render(). `frame`:
  /// the frame's own time, of which those are that cannot be averaged.
  RayCounts draw_features(const std::optional<Reached>& reached, const FilmPart& part,
                          Instants instants, const Instant& frame, Pool& pool,
                          const std::stop_token& stop);
  /// Whether there are such.
  static bool shows_own_time(const Plan& plan) {
    return plan.layers.any(
        [](const LayerRow& row) { return row.feature && !averages(*row.feature); });
  }
  std::string encode(const std::string& recipe, const Workers& workers) const;

 private:
  const Plan& plan_;
  LayerFilm film_;
};

}  // namespace tia::server
