#include "core/render/gaze_rings.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

constexpr double golden_ratio = 0.61803398874989485;

GazeRing ring_at(double eccentricity, const Acuity& acuity, int number) {
  const double e = std::min(eccentricity, pi), width = acuity.width(e);
  const double count = std::ceil(2 * pi * sin_of(e) / width);
  const double start = number * golden_ratio;
  return {e, width, number, std::max(1, static_cast<int>(count)), start - std::floor(start)};
}

// The rays of a ring on the inner side of a plane, or no farther from it than `reach`: they are one
// run. Returns: how many, and the first of them.
struct Run {
  int begin, count;
};
Run run_before(const GazeRing& ring, const Vec3d& plane, double reach) {
  const auto [sine, cosine] = sincos_of(ring.eccentricity);
  const double swing = sine * std::sqrt(plane.x * plane.x + plane.y * plane.y);
  const double needed = -reach - cosine * plane.z;  // of swing times a cosine
  if (needed <= -swing) return {0, ring.count};
  if (needed > swing) return {0, 0};
  const double middle = atan2_of(plane.y, plane.x) / (2 * pi) - ring.start;
  const double half = acos_of(needed / swing) / (2 * pi);
  const double begin = std::ceil((middle - half) * ring.count);
  const double end = std::floor((middle + half) * ring.count) + 1;
  if (end - begin >= ring.count) return {0, ring.count};
  return {static_cast<int>(begin), std::max(0, static_cast<int>(end - begin))};
}

// Adds begin .. end - 1 around the ring as what lies in 0 .. count - 1.
void add_around(int begin, int length, int count, std::vector<Arc>& to) {
  const int first = ((begin % count) + count) % count, end = first + length;
  to.push_back({first, std::min(end, count)});
  if (end > count) to.push_back({0, end - count});
}

// What is in none of the arcs that are left out.
std::vector<Arc> rest_of(std::vector<Arc> left_out, int count) {
  std::ranges::sort(left_out, {}, &Arc::begin);
  std::vector<Arc> rest;
  int free = 0;
  for (const Arc& each : left_out) {
    if (each.begin > free) rest.push_back({free, each.begin});
    free = std::max(free, each.end);
  }
  if (free < count) rest.push_back({free, count});
  return rest;
}

std::vector<Arc> arcs_in(const GazeRing& ring, const std::array<Vec3d, 4>& planes, double reach) {
  std::vector<Arc> left_out;
  for (const Vec3d& plane : planes) {
    const Run run = run_before(ring, plane, reach);
    if (run.count == 0) return {};
    if (run.count < ring.count)
      add_around(run.begin + run.count, ring.count - run.count, ring.count, left_out);
  }
  return rest_of(std::move(left_out), ring.count);
}

// The sine of how far from a pixel's centre a ray may be that it is filled from: a gap outwards, or
// inwards, and one between rays along the ring, on which ring k's lie farther apart at k + 1. By
// haversines chord^2 <= gap^2 + sin e sin e' turn^2.
double reach_of(const GazeRing& ring, double next) {
  const double here = sin_of(ring.eccentricity), there = std::max(here, sin_of(next));
  if (here * 64 < there) return 2;
  const double chord = ring.width * std::sqrt(1 + there / here) * 1.001;
  return chord * chord >= 2 ? 2 : chord * std::sqrt(1 - chord * chord / 4);
}

/// Marks: of some rings' rays, which are wanted.
class Marks {
 public:
  explicit Marks(const std::vector<GazeRing>& rings) {
    for (const GazeRing& ring : rings) {
      if (ring.number >= 0) break;
      marks_.emplace_back(static_cast<std::size_t>(ring.count));
    }
  }
  void add(std::size_t ring, int ray) {
    if (ring < marks_.size()) marks_[ring][static_cast<std::size_t>(ray)] = true;
  }
  void put_arcs(std::vector<GazeRing>& rings) const {
    for (std::size_t k = 0; k < marks_.size(); ++k) {
      std::vector<Arc>& arcs = rings[k].arcs;
      for (int i = 0; i < rings[k].count; ++i) {
        if (!marks_[k][static_cast<std::size_t>(i)]) continue;
        if (!arcs.empty() && arcs.back().end == i) ++arcs.back().end;
        else arcs.push_back({i, i + 1});
      }
    }
  }

 private:
  std::vector<std::vector<bool>> marks_;
};

// The arc of a ray: that which begins last before it, else the first. Domain: there is one.
const Arc& arc_of(const GazeRing& ring, int ray) {
  auto arc = std::ranges::upper_bound(ring.arcs, ray, {}, &Arc::begin);
  return arc != ring.arcs.begin() ? *(arc - 1) : *arc;
}
// The slot of a ray: of the nearest one of its arc.
std::int64_t slot_in(const Arc& arc, int ray) {
  return arc.slot + std::clamp(ray, arc.begin, arc.end - 1) - arc.begin;
}

}  // namespace

GazeRings::GazeRings(const GazeFrame& frame, const Acuity& acuity, const GazeFovea& fovea,
                     const Window& window) {
  make_rings(frame, acuity, most_eccentricity(frame, window));
  prepare_search();
  keep_in_window(frame, window);
  keep_for_pixels(fovea, acuity.slope);
  number_slots();
}

void GazeRings::make_rings(const GazeFrame& frame, const Acuity& acuity, double most) {
  const double first = first_ring(frame, acuity);
  double e = first;
  for (int k = 0; e > 0;) {
    e = std::max(0.0, (e - acuity.w0()) / (1 + acuity.slope));
    if (e < pi) rings_.push_back(ring_at(e, acuity, --k));
    else --k;
  }
  std::ranges::reverse(rings_);
  e = first;
  for (int k = 0; rings_.size() < 2 || rings_.back().eccentricity < most; ++k) {
    rings_.push_back(ring_at(e, acuity, k));
    if (rings_.back().eccentricity >= pi) break;
    e += acuity.width(e);
  }
}

void GazeRings::prepare_search() {
  constexpr double most_steps = 1 << 14;
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const GazeRing& ring = rings_[k];
    const double gap = k + 1 < rings_.size() ? rings_[k + 1].eccentricity - ring.eccentricity : 1;
    numbers_.push_back({static_cast<float>(ring.eccentricity), static_cast<float>(1 / gap),
                        static_cast<float>(ring.count), static_cast<float>(ring.start),
                        ring.count});
  }
  const double from = rings_.front().eccentricity, all = rings_.back().eccentricity - from;
  const double steps = std::min(std::ceil(all / rings_.front().width), most_steps);
  first_ = static_cast<float>(from);
  per_step_ = static_cast<float>(steps / all);
  std::uint32_t ring = 0;
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    while (ring + 2 < rings_.size() && rings_[ring + 1].eccentricity <= from + i * all / steps)
      ++ring;
    lookup_.push_back(ring);
  }
}

void GazeRings::keep_in_window(const GazeFrame& frame, const Window& window) {
  const std::array<Vec3d, 4> planes = planes_around(frame, window);
  for (GazeRing& ring : rings_) {
    if (ring.number < 0) continue;
    const double next = std::min(ring.eccentricity + ring.width, pi);
    ring.arcs = arcs_in(ring, planes, reach_of(ring, next));
  }
}

void GazeRings::keep_for_pixels(const GazeFovea& fovea, double slope) {
  Marks marks(rings_);
  for (const GazePixel& pixel : fovea.pixels()) {
    if (GazeFovea::is_of_fovea(pixel, slope)) continue;
    const std::size_t k = ring_below(pixel.polar.eccentricity);
    if (rings_[k].number >= 0) continue;
    for (const std::size_t ring : {k, k + 1}) {
      const int ray = step(numbers_[ring], pixel.polar.turn).ray;
      marks.add(ring, ray);
      marks.add(ring, after(ring, ray));
    }
  }
  marks.put_arcs(rings_);
}

void GazeRings::number_slots() {
  for (GazeRing& ring : rings_)
    for (Arc& arc : ring.arcs) {
      arc.slot = rays_;
      rays_ += arc.end - arc.begin;
    }
}

std::size_t GazeRings::ring_below(float eccentricity) const {
  const float at = (eccentricity - first_) * per_step_;
  const auto last = static_cast<float>(lookup_.size() - 1);
  std::size_t k = lookup_[static_cast<std::size_t>(at > 0 ? std::min(at, last) : 0)];
  while (k > 0 && eccentricity < numbers_[k].eccentricity) --k;
  while (k + 2 < numbers_.size() && eccentricity >= numbers_[k + 1].eccentricity) ++k;
  return k;
}

std::pair<std::int64_t, std::int64_t> GazeRings::slots(std::size_t ring, int ray) const {
  const GazeRing& of = rings_[ring];
  if (of.arcs.empty()) return {0, 0};
  const int next = after(ring, ray);
  const Arc& arc = arc_of(of, ray);
  const std::int64_t slot = slot_in(arc, ray);
  if (ray >= arc.begin && next > ray && next < arc.end) return {slot, slot + 1};
  return {slot, slot_in(arc_of(of, next), next)};
}

GazeCount count_of(const GazeFovea& fovea, const GazeRings& rings, double slope) {
  return {fovea.count(slope), rings.rays()};
}

}  // namespace tia
