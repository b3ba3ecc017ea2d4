// Which way maps bend a mesh's normals, those of its coat, and its grain.
#pragma once

#include <array>
#include <optional>

#include "core/accel/mesh/mesh_point.h"
#include "core/accel/world/trace.h"
#include "core/accel/world/winners.h"

namespace tia {

/// LaneVectors: vectors that are found lane by lane, and in which lanes.
template <class Real>
class LaneVectors {
 public:
  void set(int i, const Vec3d& v) {
    const double numbers[] = {v.x, v.y, v.z};
    for (std::size_t k = 0; k < 3; ++k)
      parts_[k][static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(numbers[k]);
    set_[static_cast<std::size_t>(i)] = 1;
  }
  Mask<Real> here() const { return load<Real>(set_.data()) > Real(0); }
  Vec3<Real> all() const {
    return {load<Real>(parts_[0].data()), load<Real>(parts_[1].data()),
            load<Real>(parts_[2].data())};
  }

 private:
  using Lanes = std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)>;
  std::array<Lanes, 3> parts_{};
  Lanes set_{};
};

/// TangentSpace: of a point in the world; a mirrored mesh' is the mirror image.
struct TangentSpace {
  Vec3d t, b, n;
  Vec3d direction(const Vec3d& m) const { return normalize(t * m.x + b * m.y + n * m.z); }
};

/// Bending: what a mesh's normals, and its coat's, become by normal maps, and which way its grain
/// runs, lane by lane.
template <class Real>
class Bending {
 public:
  Bending(const PrincipledMaps& maps, const SurfacePoint<Real>& surface)
      : maps_(maps), surface_(surface), front_(bits(surface.front)) {}

  bool bends() const { return maps_.normal || maps_.coat_normal || maps_.grain; }
  void bend(int i, TextureReader& reader, const TrianglePoint& at, const Affine& map,
            const PrincipledNumbers& numbers) {
    const bool coats = numbers.clearcoat > 0 && (maps_.normal || maps_.coat_normal);
    const bool grains = numbers.anisotropy > 0 && maps_.grain;
    if (!maps_.normal && !coats && !grains) return;
    const double side = (front_ >> i & 1U) != 0 ? 1 : -1;
    const Vec3<Real>& seen = surface_.n;
    const Vec3d n{lane(seen.x, i), lane(seen.y, i), lane(seen.z, i)};
    const TangentSpace space = space_of(at, map, n * side);
    if (maps_.normal) normals_.set(i, space.direction(mapped_normal(*maps_.normal, reader)) * side);
    if (coats) coat(i, reader, space, n, side);
    if (grains) {
      const auto [along, across] = mapped_grain(*maps_.grain, reader);
      grains_.set(i, space.t * along + space.b * across);
    }
  }
  void store(Mask<Real> here, LaneTextures<Real>& to, SurfacePoint<Real>& at) const {
    if (maps_.normal) at.n = select(here, normals_.all(), at.n);
    const Mask<Real> coated = coats_.here(), grained = grains_.here();
    if (!any(coated || grained)) return;
    if (!to.frames) to.frames.emplace();
    LayerFrames<Real>& frames = *to.frames;
    frames.coat_n = select(coated, coats_.all(), frames.coat_n);
    frames.grain = select(grained, grains_.all(), frames.grain);
    frames.coated = frames.coated || coated, frames.grained = frames.grained || grained;
  }

 private:
  // A coat without a map, or where that is flat, is as smooth as the mesh. Where nothing bends what
  // is under it, it is no other then. Source: KHR_materials_clearcoat.
  void coat(int i, TextureReader& reader, const TangentSpace& space, const Vec3d& n, double side) {
    const Vec3d m = maps_.coat_normal ? mapped_normal(*maps_.coat_normal, reader) : Vec3d{0, 0, 1};
    const bool flat = m.x == 0 && m.y == 0 && m.z > 0;
    if (!flat) coats_.set(i, space.direction(m) * side);
    else if (maps_.normal) coats_.set(i, n);
  }
  TangentSpace space_of(const TrianglePoint& at, const Affine& map, const Vec3d& n) {
    const MeshTangent own = tangent_of(at, tangent_map(maps_), normal_of(at));
    const Vec3d given = inverse_of(map).vector(own.t);
    const Vec3d t = normalize(given - n * dot(given, n));
    return {t, cross(n, t) * (map.determinant() < 0 ? -own.sign : own.sign), n};
  }
  // Most lanes have the same.
  const Affine& inverse_of(const Affine& map) {
    if (!inverse_ || !(map == map_)) map_ = map, inverse_ = map.inverse();
    return *inverse_;
  }

  const PrincipledMaps& maps_;
  const SurfacePoint<Real>& surface_;
  const unsigned front_;
  Affine map_;
  std::optional<Affine> inverse_;
  LaneVectors<Real> normals_, coats_, grains_;
};

}  // namespace tia
