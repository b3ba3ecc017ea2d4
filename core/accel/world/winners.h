// What the lanes of a packet have hit, primitive by primitive, and its shading parameters there.
#pragma once

#include <array>
#include <bit>
#include <optional>

#include "core/accel/world/world.h"
#include "core/materials/layer_frames.h"
#include "core/math/lanes.h"

namespace tia {

/// Calls f(primitive, mask) once for each primitive that lanes have hit: a packet rarely sees more
/// than two, so what depends on the primitive alone is found once for all lanes.
template <class Real, class F>
void for_each_winner(const Hit<Real>& hit, Mask<Real> active, F f) {
  Mask<Real> left = active && hit.t < Real(infinity);
  while (const unsigned lanes_left = bits(left)) {
    const auto primitive = static_cast<int>(lane(hit.primitive, std::countr_zero(lanes_left)));
    const Mask<Real> here = left && hit.primitive == Real(static_cast<float>(primitive));
    f(primitive, here);
    left = left && !here;
  }
}

/// LaneNumbers: the numbers of the materials that lanes have hit; none where no lane has hit one
/// whose numbers are textured.
template <class Real>
using LaneNumbers =
    std::optional<std::array<PrincipledNumbers, static_cast<std::size_t>(lanes<Real>)>>;

/// Looks up the textures in the lanes of `here`, which have hit the primitive, as points see them.
/// Domain: a primitive whose numbers are textured.
template <class Real>
void take_numbers(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                  Mask<Real> here, LaneNumbers<Real>& numbers);

template <class Real>
struct SurfacePoint;  // trace.h
/// LaneTextures: what textures say of the surfaces that lanes have hit.
template <class Real>
struct LaneTextures {
  LaneNumbers<Real> numbers{};
  std::optional<LayerFrames<Real>> frames{};  ///< none where no coat and no grain is told apart
};
/// The same as rays of some width see them, and bends the shading normals `at` those points as a
/// normal map says. Space/units: `width`: of the rays' cones there, in scene units; 0: of rays.
template <class Real>
void take_textures(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                   Mask<Real> here, const Real& width, LaneTextures<Real>& textures,
                   SurfacePoint<Real>& at);

/// Calls f(shading, primitive, mask) for each primitive that lanes have hit, and where its numbers
/// are textured then own(form, numbers, lane) for each lane: to set what is other there.
/// Domain: take_numbers has been called for those.
template <class Real, class F, class Own>
void for_each_shading(const World& world, const Hit<Real>& hit, const LaneNumbers<Real>& numbers,
                      Mask<Real> active, F f, Own own) {
  for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
    const ShadingParameters& shading = world.shading_of(primitive);
    f(shading, primitive, here);
    if (shading.form < 0) return;
    const PrincipledForm& form =
        world.geometry_of(primitive).forms[static_cast<std::size_t>(shading.form)];
    for_each_lane(here, [&](int i) { own(form, (*numbers)[static_cast<std::size_t>(i)], i); });
  });
}

}  // namespace tia
