// Pixels that take samples together, and their sums, one in each lane.
#pragma once

#include <array>

#include "core/integrators/path_parts.h"
#include "core/math/lanes.h"
#include "core/render/estimate.h"
#include "core/render/ground_shadow.h"
#include "core/render/sampler.h"
#include "core/render/target.h"

namespace tia {

/// Pixels: several of a tile, one in each lane; the first one again in the lanes left over.
template <class Real>
struct Pixels {
  static constexpr auto size = static_cast<std::size_t>(lanes<Real>);
  std::size_t count = 0;
  std::array<Estimate*, size> estimates{};
  std::array<PartSums*, size> parts{};        ///< where they are asked for
  std::array<GuidedSums*, size> guided{};     ///< the same
  std::array<const Target*, size> targets{};  ///< where they are none of the view's
  typename Aims<Real>::Pixels x{}, y{};

  Mask<Real> active() const { return iota<Real>() < Real(static_cast<float>(count)); }
  Vec3<Real> first_light() const {
    return {lanes_of([&](std::size_t i) { return estimates[i]->first.x; }),
            lanes_of([&](std::size_t i) { return estimates[i]->first.y; }),
            lanes_of([&](std::size_t i) { return estimates[i]->first.z; })};
  }
  // Tells each pixel its first sample and how many more it has.
  void tell(const Vec3<Real>& first, int more) const {
    std::array<LaneOf<Real>, size> r, g, b;
    store(first.x, r.data());
    store(first.y, g.data());
    store(first.z, b.data());
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = [i](const auto& lanes_of_it) {
        return static_cast<float>(lanes_of_it[i]);
      };
      estimates[i]->first = {number(r), number(g), number(b)};
      estimates[i]->count += more;
    }
  }
  Real column() const {
    return lanes_of([&](std::size_t i) { return static_cast<float>(x[i]); });
  }
  Real row() const {
    return lanes_of([&](std::size_t i) { return static_cast<float>(y[i]); });
  }
  Vec3<Real> center(const View& view) const { return view.column(column()) + view.row(row()); }
  Vec3<Real> each(Vec3d Target::*of) const {
    const auto lanes_of_axis = [&](double Vec3d::*axis) {
      return lanes_of(
          [&](std::size_t i) { return static_cast<LaneOf<Real>>(targets[i]->*of.*axis); });
    };
    return {lanes_of_axis(&Vec3d::x), lanes_of_axis(&Vec3d::y), lanes_of_axis(&Vec3d::z)};
  }
  // Not inlined into what traces without.
  [[gnu::noinline]] void add(const Guides& guides, bool first_half) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < Guides::numbers; ++k) {
        const auto found = static_cast<double>(guides.at(k, i));
        guided[i]->found[k] += found;
        if (first_half) guided[i]->half_found[k] += found;
      }
  }
  // What the sums of light have grown by since the round's begin, after so many samples.
  [[gnu::noinline]] void end_half(const Vec3<Precise<Real>>& sums, int samples) const {
    std::array<double, size> r, g, b;
    store(sums.x, r.data());
    store(sums.y, g.data());
    store(sums.z, b.data());
    for (std::size_t i = 0; i < count; ++i) {
      Vec3d& light = guided[i]->half_light;
      light = light + (Vec3d{r[i], g[i], b[i]} - estimates[i]->light);
      guided[i]->half_count += samples;
    }
  }
  // A sample's. Not inlined into what draws without.
  [[gnu::noinline]] void add(const LightParts& sample) const {
    const auto of = [](const LightParts::Part& part, std::size_t i) {
      return Vec3d{part.r[i], part.g[i], part.b[i]};
    };
    for (std::size_t i = 0; i < count; ++i) {
      parts[i]->direct = parts[i]->direct + of(sample.direct, i);
      parts[i]->indirect = parts[i]->indirect + of(sample.indirect, i);
      parts[i]->emission = parts[i]->emission + of(sample.emission, i);
    }
  }
  // One of each pixel's sums, in lanes, and back.
  Vec3<Precise<Real>> gather(Vec3d Estimate::*sum) const {
    const auto lanes_of_sum = [&](double Vec3d::*axis) {
      std::array<double, size> each;
      for (std::size_t i = 0; i < size; ++i) each[i] = estimates[i]->*sum.*axis;
      return load<Precise<Real>>(each.data());
    };
    return {lanes_of_sum(&Vec3d::x), lanes_of_sum(&Vec3d::y), lanes_of_sum(&Vec3d::z)};
  }
  void scatter(const Vec3<Precise<Real>>& from, Vec3d Estimate::*sum) const {
    std::array<double, size> vx, vy, vz;
    store(from.x, vx.data());
    store(from.y, vy.data());
    store(from.z, vz.data());
    for (std::size_t i = 0; i < count; ++i) estimates[i]->*sum = {vx[i], vy[i], vz[i]};
  }

 private:
  template <class F>
  static Real lanes_of(F value) {
    std::array<LaneOf<Real>, size> each;
    for (std::size_t i = 0; i < size; ++i) each[i] = value(i);
    return load<Real>(each.data());
  }
};

/// TargetLanes: where rays go that are of no pixel.
template <class Real>
struct TargetLanes {
  Vec3<Real> origin, center, right, down;

  TargetLanes(const Pixels<Real>& pixels, const View& view)
      : origin(lift<Real>(view.origin)),
        center(pixels.each(&Target::direction)),
        right(pixels.each(&Target::right)),
        down(pixels.each(&Target::down)) {}
  Ray<Real> ray(const Aim<Real>& aim) const {
    return {origin, normalize(center + (right * aim.dx + down * aim.dy))};
  }
};

/// Sums: those of some pixels' samples, in lanes.
template <class Real>
struct Sums {
  using P = Precise<Real>;
  Vec3<P> light, deviations, squares;
  std::array<int, Pixels<Real>::size> met{};  ///< of these samples alone
  bool has_ground = false;
  Vec3<P> ground{P(0), P(0), P(0)};  ///< where there is one

  explicit Sums(const Pixels<Real>& pixels)
      : light(pixels.gather(&Estimate::light)),
        deviations(pixels.gather(&Estimate::deviations)),
        squares(pixels.gather(&Estimate::squares)) {}
  void scatter_to(const Pixels<Real>& pixels) const {
    pixels.scatter(light, &Estimate::light);
    pixels.scatter(deviations, &Estimate::deviations);
    pixels.scatter(squares, &Estimate::squares);
    if (has_ground) pixels.scatter(ground, &Estimate::ground);
    for (std::size_t i = 0; i < pixels.count; ++i) pixels.estimates[i]->met += met[i];
  }
  void begin_ground(const Pixels<Real>& pixels) {
    has_ground = true;
    ground = pixels.gather(&Estimate::ground);
  }
  void add_ground(const GroundLight<Real>& light) {
    const Real one = select(light.here, Real(1), Real(0));
    ground = ground + widen(Vec3<Real>{light.with, light.without, one});
  }
  // The lanes, as bits, of samples that met an object.
  void add_met(unsigned lanes_of_it) {
    for (std::size_t i = 0; i < met.size(); ++i) met[i] += static_cast<int>(lanes_of_it >> i & 1U);
  }

  void add(const Vec3<Real>& sample) { light = light + widen(sample); }
  void add_deviation(const Vec3<Real>& watched, const Vec3<Real>& first) {
    const Vec3<P> deviation = widen(watched - first);
    deviations = deviations + deviation;
    squares = squares + deviation * deviation;
  }
};

}  // namespace tia
