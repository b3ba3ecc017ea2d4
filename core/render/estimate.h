// The sums over a pixel's samples, and when they tell its light well enough.
#pragma once

#include <array>
#include <vector>

#include "core/film/tone.h"
#include "core/integrators/guides.h"
#include "core/math/vec3.h"

namespace tia {

/// Estimate: the sums over a pixel's samples so far, in double and in the samples' order, so that
/// rounds change nothing. Deviations are those from the first sample, so that their squares do not
/// vanish in the rounding of the sums.
struct Estimate {
  Vec3d light{}, deviations{}, squares{};
  Vec3f first{};
  int count = 0;
  int met = 0;      ///< how many of the samples met an object; only before a backdrop
  Vec3d ground{};   ///< of those on a shadow ground: light with objects, without, how many
  float error = 1;  ///< what Convergence makes of them where noise is to be small enough

  Vec3f mean() const {
    return {static_cast<float>(light.x / count), static_cast<float>(light.y / count),
            static_cast<float>(light.z / count)};
  }
  /// The variance of that, by the samples' own. Domain: count > 1; deviations that are watched.
  Vec3f variance() const;
  /// With the shadow on the ground: 1 - E / E0 of the samples there, at least 0.
  float alpha() const {
    const auto& [with, without, on_ground] = ground;
    const double dark = with < without ? 1 - with / without : 0;
    return static_cast<float>((met + dark * on_ground) / count);
  }
};

/// PartSums: of a pixel's samples, by how their light came; only where they are asked for.
struct PartSums {
  Vec3d direct{}, indirect{}, emission{};
};

/// GuidedSums: of a pixel that is going to be denoised: of all samples what their camera rays find
/// (Guides), and of half of them the same, their light, and how many there are: those before a
/// round that doubles them, or half of each. Of Sobol's points such are as even as the whole.
struct GuidedSums {
  std::array<double, Guides::numbers> found{}, half_found{};
  Vec3d half_light{};
  int half_count = 0;
};

/// Convergence: how far a pixel may yet be from what it will be, and when that is near enough.
///
/// By `threshold` a pixel is settled when the standard error of its mean light, each sample clamped
/// to [0,1], is at most that.
///
/// By `noise` it is settled when it has at least 32 samples, one at least of each time, and its
/// error is below that, as a display shows it: after exposure, white balance and transfer, in
/// [0,1]. The curve bends, so the error is not its slope's: each channel's mean is moved by its
/// standard error, up and down, and the larger change of what is shown counts. Of curves that mix
/// channels the changes by the three are added: no correlation of the channels makes more of them
/// (the triangle inequality). The standard error is that of independent samples; Sobol's points are
/// at least as good. Source: D. Kirk, J. Arvo, "Unbiased sampling techniques for image synthesis"
/// (1991), for what stopping by the samples themselves costs: a mean that is off by less than its
/// error.
class Convergence {
 public:
  static constexpr int least_samples = 32;

  /// Rule: what settles a pixel, and whether errors are to be told where nothing does.
  struct Rule {
    double threshold = 0, noise = 0;  ///< 0: none
    bool tells_errors = false;
    Tone tone = {};
    int blur_steps = 1;  ///< strata of the open time, of each of which a pixel has a sample
  };
  explicit Convergence(const Rule& rule)
      : rule_(rule), tone_(rule.tone), shows_(rule.noise > 0 || rule.tells_errors) {}

  /// Whether it needs deviations, and from which light.
  bool watches() const { return rule_.threshold > 0 || shows_; }
  bool clamps() const { return rule_.threshold > 0; }
  /// Whether errors are as a display shows them.
  bool shows() const { return shows_; }

  /// Tells the estimate its error, where noise settles it. Returns: whether it needs no more
  /// samples.
  bool settle(Estimate& estimate) const;
  /// The largest error of these, as a display shows it. Domain: errors are shown; estimates that
  /// settle() has seen.
  float largest_error(const std::vector<Estimate>& estimates) const;

 private:
  double shown_error(const Estimate& estimate) const;
  double most_error(const Estimate& estimate) const;

  Rule rule_;
  ToneMap tone_;
  bool shows_;
};

}  // namespace tia
