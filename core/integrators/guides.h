// What camera rays find, told beside their light: features for the denoiser.
#pragma once

#include <array>
#include <cstddef>

#include "core/film/pixel_planes.h"
#include "core/math/lanes.h"

namespace tia {

/// Guides: of the last camera rays of a packet, lane by lane, what PixelPlanes has beside light:
/// of the first surface albedo, normal, and 1 over the distance; and the share that was seen of the
/// light that it was asked for, 0 where none was. Where nothing is met, all is 0 but albedo, which
/// light is going to be divided by: it is 1 there and on what is black, whose light is its own.
class Guides {
 public:
  static constexpr std::size_t numbers = PixelPlanes::count - PixelPlanes::albedo;
  using Lanes = std::array<float, 16>;
  static_assert(Wide::size <= std::tuple_size_v<Lanes>);

  /// The number of a plane of PixelPlanes but light in a lane.
  float at(std::size_t plane, std::size_t lane) const { return each_[plane][lane]; }

  /// Takes the surfaces that camera rays meet; those are what see() then tells of, until close().
  /// `colored`: whether the rays' light is the surface's albedo times something.
  template <class Surface, class Real>
  void take(const Surface& isect, const Real& t, bool colored = true) {
    const Vec3<Real> white{Real(1), Real(1), Real(1)}, &albedo = isect.albedo;
    const Mask<Real> is_black = !(albedo.x + albedo.y + albedo.z > Real(0));
    const auto put = [&](std::size_t first, const Vec3<Real>& v) {
      store(v.x, each_[first].data());
      store(v.y, each_[first + 1].data());
      store(v.z, each_[first + 2].data());
    };
    put(0, colored ? select(isect.here && !is_black, albedo, white) : white);
    put(normal, select(isect.here, isect.at.n, Vec3<Real>{Real(0), Real(0), Real(0)}));
    store(select(isect.here, Real(1) / t, Real(0)), each_[depth].data());
    each_[visibility].fill(0);
    open_ = true;
  }
  /// What share of light passes to those lanes' surfaces.
  template <class Real>
  void see(const Mask<Real>& asked, const Real& passing) {
    if (!open_) return;
    Lanes seen;
    store(select(asked, passing, Real(0)), seen.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(lanes<Real>); ++i)
      each_[visibility][i] += seen[i];
  }
  void close() { open_ = false; }

 private:
  static constexpr std::size_t normal = PixelPlanes::normal - PixelPlanes::albedo;
  static constexpr std::size_t depth = PixelPlanes::depth - PixelPlanes::albedo;
  static constexpr std::size_t visibility = PixelPlanes::visibility - PixelPlanes::albedo;
  std::array<Lanes, numbers> each_{};
  bool open_ = false;
};

}  // namespace tia
