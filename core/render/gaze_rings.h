// The rings of rays that the periphery is filled from.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "core/render/gaze.h"
#include "core/render/gaze_fovea.h"
#include "core/render/gaze_frame.h"

namespace tia {

/// Arc: rays begin .. end - 1 of a ring, which are traced, and what the first one is kept as.
struct Arc {
  int begin, end;
  std::int64_t slot = 0;
};

/// GazeRing: rays at one eccentricity, evenly around the gaze.
struct GazeRing {
  double eccentricity, width;  ///< radians: the ring's, and the smallest angle that is seen there
  int number;                  ///< of the first ring 0, negative within
  int count;                   ///< of rays, all around
  double start;                ///< the turn of the first one
  std::vector<Arc> arcs = {};  ///< in order
};

/// GazeCell: the two rings around a place, the two rays around it on each, and how far on between
/// them it is.
struct GazeCell {
  struct Between {
    std::int64_t from, to;  ///< slots
    float share;
  };
  float share;  ///< 0 at the inner ring, 1 at the outer one
  Between inner, outer;
};

/// GazeRings: all rings that a window is filled from, from the gaze outwards. Ring k + 1 is beyond
/// ring k by the smallest angle w that is seen at k; it has as many rays as are w apart, at least
/// one, and the first is at k golden ratios of a turn. Ring 0 is where the smallest angle that is
/// seen becomes a pixel in the picture's centre. Where pixels are smaller than that, there is a
/// periphery within ring 0, too, for which rings go on inwards by the same rule, to a single ray
/// along the gaze. Of those without it is traced what falls into the window or is at most a ring
/// beside it, of those within what a pixel is filled from.
class GazeRings {
 public:
  /// Domain: a fovea of the same frame and window, for this slope or a smaller one.
  GazeRings(const GazeFrame& frame, const Acuity& acuity, const GazeFovea& fovea,
            const Window& window);

  const std::vector<GazeRing>& rings() const { return rings_; }
  std::int64_t rays() const { return rays_; }
  class Search;

 private:
  /// Numbers: a ring's for the search, in float.
  struct Numbers {
    float eccentricity, per_gap, count, start;
    int rays;
  };
  /// Step: a ray of a ring, and how far on it is from there to the next one.
  struct Step {
    int ray;
    float share;
  };
  void make_rings(const GazeFrame& frame, const Acuity& acuity, double most);
  void prepare_search();
  void keep_in_window(const GazeFrame& frame, const Window& window);
  void keep_for_pixels(const GazeFovea& fovea, double slope);
  void number_slots();
  std::size_t ring_below(float eccentricity) const;
  static Step step(const Numbers& of, float turn);
  int after(std::size_t ring, int ray) const { return ray + 1 < rings_[ring].count ? ray + 1 : 0; }
  /// Of a ray, and of the next one.
  std::pair<std::int64_t, std::int64_t> slots(std::size_t ring, int ray) const;

  std::vector<GazeRing> rings_;
  std::vector<Numbers> numbers_;
  std::vector<std::uint32_t> lookup_;  // the ring below each of even steps of the eccentricity
  float first_ = 0, per_step_ = 0;
  std::int64_t rays_ = 0;
};

/// Search: finds what places are filled from, soonest those that are near to each other.
class GazeRings::Search {
 public:
  explicit Search(const GazeRings& rings) : rings_(rings) {}
  /// Domain: a pixel's place, of the window's periphery.
  const GazeCell& operator()(const Polar<float>& place);

 private:
  const GazeRings& rings_;
  GazeCell cell_{};
  std::size_t ring_ = 0;
  const Numbers *inside_ = nullptr, *outside_ = nullptr;  // of that, and of the next one
  float from_ = 1, to_ = 0;                               // their eccentricities
  int inner_ = -1, outer_ = -1;                           // the rays that its slots are of
};

inline GazeRings::Step GazeRings::step(const Numbers& of, float turn) {
  const float from_first = turn - of.start;
  const float at = (from_first < 0 ? from_first + 1 : from_first) * of.count;
  const int ray = std::min(static_cast<int>(at), of.rays - 1);
  return {ray, std::min(at - static_cast<float>(ray), 1.0F)};
}

inline const GazeCell& GazeRings::Search::operator()(const Polar<float>& place) {
  const auto& [e, turn] = place;
  if (!(e >= from_ && e < to_)) {
    ring_ = rings_.ring_below(e);
    inside_ = &rings_.numbers_[ring_], outside_ = inside_ + 1;
    from_ = inside_->eccentricity, to_ = outside_->eccentricity;
    inner_ = outer_ = -1;
  }
  const Step inner = step(*inside_, turn), outer = step(*outside_, turn);
  if (inner.ray != inner_)
    std::tie(cell_.inner.from, cell_.inner.to) = rings_.slots(ring_, inner_ = inner.ray);
  if (outer.ray != outer_)
    std::tie(cell_.outer.from, cell_.outer.to) = rings_.slots(ring_ + 1, outer_ = outer.ray);
  cell_.inner.share = inner.share;
  cell_.outer.share = outer.share;
  cell_.share = std::clamp((e - from_) * inside_->per_gap, 0.0F, 1.0F);
  return cell_;
}

/// How many pixels and rays there are of a window.
GazeCount count_of(const GazeFovea& fovea, const GazeRings& rings, double slope);

}  // namespace tia
