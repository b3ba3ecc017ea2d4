// TextureMap: how a material of a model looks a picture up, as glTF's textures and samplers say.
#pragma once

#include <array>
#include <memory>

#include "core/materials/mip_pyramid.h"
#include "core/materials/wrap.h"
#include "core/shapes/crossing.h"

namespace tia {

/// TexturePoint: a point of a surface as textures see it.
struct TexturePoint {
  Vec3d p;                    ///< in the space of the object that has the texture
  std::array<Vec2d, 2> uv{};  ///< its surface coordinates, v upward: the first set and the second
  double blur = 0;            ///< how far p may be off its surface
  /// How wide what is seen of it is, in units of each set; 0: a point.
  std::array<double, 2> footprint{};
  Rgba color{1, 1, 1, 1};  ///< of the mesh, there
};

/// TextureMap: a picture on a surface. Its texels are numbered downwards, as glTF's v grows.
struct TextureMap {
  std::shared_ptr<const MipPyramid> pyramid;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;    ///< the texel's own colour; else bilinear, of two levels
  std::size_t uv_set = 0;  ///< 0 or 1
  Vec2d offset{};          ///< (u, v) -> offset + u along_u + v along_v, v downward
  Vec2d along_u{1, 0}, along_v{0, 1};
  double strength = 1;  ///< a normal map's scale, an occlusion map's strength

  /// Sets what uv become. Space/units: radians.
  /// Source: KHR_texture_transform, its rotation's sense by KhronosGroup/glTF#1563.
  void transform(const Vec2d& moved, const Vec2d& scale, double rotation);
  bool operator==(const TextureMap&) const = default;
};

/// Where in the picture, v downward, a point is that has these coordinates, v upward.
Vec2d place_in(const TextureMap& map, const Vec2d& uv);

/// TextureLookup: which texels of a map are looked up, and their shares.
struct TextureLookup {
  /// Four: around a place, by their places in the list of their level, row by row.
  struct Four {
    std::array<std::size_t, 4> texels;
    double right, down;  ///< the shares of the second column and row
  };
  int level = 0;
  double next = 0;  ///< the share of the next level; 0: it is not looked up
  std::array<Four, 2> of;
};
/// Whether two maps look the same texels up wherever they are looked up.
bool look_alike(const TextureMap& a, const TextureMap& b);
/// Of what is seen as more than a texel, the mean of about as much: of the two levels next to
/// log2(footprint in texels). Nearest looks at level 0 alone.
/// Source: Akenine-Moeller et al., "Improved shader and texture level of detail using ray cones",
/// JCGT 10(1), 2021; Khronos, glTF 2.0, 3.8.4.
TextureLookup lookup_of(const TextureMap& map, const TexturePoint& at);
/// Domain: a lookup of this map or of one that looks alike.
Rgba rgba_at(const TextureMap& map, const TextureLookup& lookup);

/// TextureReader: what maps have at one point. Those that look alike share their lookups.
class TextureReader {
 public:
  /// Domain: a point that outlives it, as the maps do.
  explicit TextureReader(const TexturePoint& at) : at_(at) {}
  const TexturePoint& at() const { return at_; }
  Rgba rgba_of(const TextureMap& map) {
    if (last_ == nullptr || !look_alike(*last_, map)) lookup_ = lookup_of(map, at_);
    last_ = &map;
    return rgba_at(map, lookup_);
  }

 private:
  const TexturePoint& at_;
  const TextureMap* last_ = nullptr;
  TextureLookup lookup_;
};

/// The picture there.
inline Rgba rgba_at(const TextureMap& map, const TexturePoint& at) {
  return rgba_at(map, lookup_of(map, at));
}

}  // namespace tia
