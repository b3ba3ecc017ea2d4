// What a path has met, vertex by vertex, and every light that it was given, for /explain. The path
// tracer itself writes it; pictures are traced with NoPathRecorder.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/fields.h"
#include "core/integrators/world_view.h"
#include "core/materials/bsdf.h"

namespace tia {

/// PathEvent: how a vertex sends light on: `transmitted` through the surface, `specular` as a
/// mirror, else `diffuse` where the matt ground gives most of it and `glossy` where facets do;
/// `volume` in fog. It depends on the two directions alone, not on how they were found.
enum class PathEvent { diffuse, glossy, specular, transmitted, volume };
template <>
struct Names<PathEvent> {
  static constexpr std::array<std::string_view, 5> names{"diffuse", "glossy", "specular",
                                                         "transmitted", "volume"};
};
/// Of light from wi, in one lane; `below`: from behind the surface.
inline PathEvent event_of(const Bsdf<float>& bsdf, const Vec3f& wi, bool below) {
  if (below) return PathEvent::transmitted;
  return bsdf.is_matt(wi) ? PathEvent::diffuse : PathEvent::glossy;
}
/// Of what a surface has drawn.
inline PathEvent event_of(const Bsdf<float>& bsdf, const BsdfSample<float>& drawn) {
  const bool is_mirrored = !drawn.transmitted && !(drawn.pdf > 0);
  return is_mirrored ? PathEvent::specular : event_of(bsdf, drawn.wi, drawn.transmitted);
}
/// The letter that stands for it in a light path expression: D, G, S, T or V.
constexpr char letter_of(PathEvent event) { return "DGSTV"[static_cast<std::size_t>(event)]; }

/// PathEnd: why a path does not go on: it meets nothing, the surface sends nothing on, Russian
/// roulette, max_depth.
enum class PathEnd { left, absorbed, roulette, cut };
template <>
struct Names<PathEnd> {
  static constexpr std::array<std::string_view, 4> names{"left", "absorbed", "roulette", "cut"};
};

/// GatheredLight: light that one vertex adds to a path: which the path's own ray has met there, or
/// for which one light was asked.
struct GatheredLight {
  /// Lights that are none of PathLights and no sky; those count from 0 on.
  static constexpr int background = -2, own_surface = -1;

  int light = background;
  bool asked = false;
  Vec3f value{};     ///< what it adds to the sample, before that is clamped
  float weight = 1;  ///< that of multiple importance sampling
  // Of what was asked for:
  PathEvent event = PathEvent::diffuse;  ///< how the vertex sends it on
  Vec3f from{}, direction{};             ///< where it was asked for, and towards what
  float distance = 0;
  float chance = 0;   ///< of choosing this light; in fog 0: it is part of the density
  float pdf = 0;      ///< by solid angle, in fog also by distance; of a point of light the chance
  Vec3f bsdf{};       ///< f |n.wi|, or the phase function
  float visible = 0;  ///< the share that nothing takes on the way
};

/// PathVertex: a ray of a path, what it meets, and how the path goes on from there.
struct PathVertex {
  Ray<float> ray{};
  Hit<float> hit{};  ///< of the surface; t infinite: none
  Vec3f point{}, normal{};
  Vec3f throughput{};  ///< what light counts that comes from there
  std::vector<GatheredLight> lights{};
  std::optional<PathEvent> event{};  ///< of the direction that is drawn next; none: none is
  Vec3f weight{};                    ///< f |n.wi| / pdf
  float pdf = 0;                     ///< by solid angle; 0: of a single direction
  float survival = 1;                ///< the chance that Russian roulette left it
};

/// PathRecord. The sum of all values, in their order, times `clamp` is `color`, bit for bit.
struct PathRecord {
  std::vector<PathVertex> vertices{};
  PathEnd end = PathEnd::left;
  float wave = 0;  ///< in nanometres; 0: white
  float clamp = 1;
  Vec3f color{};
};

/// NoPathRecorder: records nothing, for pictures.
struct NoPathRecorder {
  static constexpr bool records = false;
};

/// PathRecorder: records one path at a time.
class PathRecorder {
 public:
  static constexpr bool records = true;

  void begin(const Ray<float>& ray, const Hit<float>& hit, const Vec3f& p, const Vec3f& n,
             const Vec3f& throughput) {
    PathVertex& vertex = path_.vertices.emplace_back();
    vertex.ray = ray, vertex.hit = hit, vertex.throughput = throughput;
    if (hit.t < infinity) vertex.point = p, vertex.normal = n;
  }
  void met(int light, const Vec3f& value, float weight) {
    if (value == Vec3f{0, 0, 0}) return;
    GatheredLight& got = last().lights.emplace_back();
    got.light = light, got.value = value, got.weight = weight;
  }
  /// What is asked for; given() tells what it adds, if it is any.
  void asked(const GatheredLight& light) { last().lights.push_back(light); }
  void given(const Vec3f& value, float weight, float visible) {
    GatheredLight& got = last().lights.back();
    got.value = value, got.weight = weight, got.visible = visible;
  }
  void roulette(float survival) { last().survival = survival; }
  /// The direction that is drawn, whether the path then goes on there or not.
  void drawn(PathEvent event, const Vec3f& p, const Vec3f& weight, float pdf) {
    PathVertex& vertex = last();
    vertex.event = event, vertex.point = p, vertex.weight = weight, vertex.pdf = pdf;
  }
  /// `shines`: whether anything is left of what light counts.
  void goes_on(bool does, bool shines) {
    if (does) return;
    path_.end = shines ? PathEnd::roulette : PathEnd::absorbed;
  }
  void cut(bool is_cut) { path_.end = is_cut ? PathEnd::cut : PathEnd::absorbed; }
  void clamped(float share) { path_.clamp = share; }
  void finish(const Vec3f& color, float wave) { path_.color = color, path_.wave = wave; }
  /// The path, and makes ready for the next.
  PathRecord take() { return std::exchange(path_, {}); }

 private:
  PathVertex& last() { return path_.vertices.back(); }
  PathRecord path_{};
};

/// The light of a camera ray's path as path traces it, bit for bit, and what it consists of.
PathRecord explain_path(WorldView& world_view, const Ray<float>& ray,
                        const SamplerState<float>& sampler_state);

}  // namespace tia
