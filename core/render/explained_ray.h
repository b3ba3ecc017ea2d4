// What explanations by trees and by paths share: the rays that they tell of, and what is told
// beside.
#pragma once

#include "core/render/explanation.h"
#include "core/render/explanation_size.h"
#include "core/render/meter.h"
#include "core/render/render.h"
#include "core/render/sampler.h"

namespace tia {

/// PixelRays: the rays of a pixel's samples, as the picture traces them. Of one instant all are
/// its. Domain: instants whose views are the scene's; they outlive it.
class PixelRays {
 public:
  PixelRays(Instants instants, int x, int y, const RenderOptions& options);

  /// Errors: InputError (out_of_range) where one of the samples first .. end - 1 has no ray.
  void check(int first, int end) const;
  /// Domain: samples that have a ray.
  Ray<float> traced(int sample) const;
  /// The same in double, and in the scene.
  Ray<double> exact(int sample) const;
  ExplainedPixel pixel(int sample) const;
  SamplerState<float> state(int sample) const;

 private:
  Aim<float> aim(int sample) const;

  const Instant& at(int sample) const {
    return instants_[static_cast<std::size_t>(sample) % instants_.size()];
  }

  Instants instants_;
  int x_, y_;
  Sampler sampler_;
};

/// A ray of the scene in the world, as it is traced.
Ray<float> traced_in(const World& world, const Ray<double>& ray);
/// The view that traces one ray after the other; `view` may be null. Domain: all outlive it.
WorldView world_view_of(const World& world, const View* view, const RenderOptions& options,
                        RayMeter& meter);
/// Tells what all.ray meets, in double.
void tell_hits(Explanation& all, ExplanationSize& size);
/// Tells what is noted, of which objects all that was told is, and how long it is.
void tell_rest(Explanation& all, const Scene& scene, IntegratorName integrator,
               ExplanationSize& size);

/// JSON of a vector; and of which copy of a primitive something is, where groups around it are
/// repeated.
Value triple_value(const Vec3f& v);
void add_copy(const World& world, Value::Object& to, const char* name, int primitive,
              std::int64_t copy);

}  // namespace tia
