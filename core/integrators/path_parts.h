// Which light of a path has come how: the layers direct, indirect and emission.
#pragma once

#include <array>

#include "core/math/lanes.h"
#include "core/math/vec3.h"

namespace tia {

/// LightParts: those of a packet's paths, whatever its scalar, lane by lane.
struct LightParts {
  using Lanes = std::array<float, static_cast<std::size_t>(lanes<Wide>)>;
  struct Part {
    Lanes r{}, g{}, b{};
  };
  Part direct{}, indirect{}, emission{};

  /// Makes those lanes nothing but this colour, sent out.
  void replace(unsigned those, const Vec3d& color) {
    for (std::size_t i = 0; i < direct.r.size(); ++i) {
      if ((those >> i & 1U) == 0) continue;
      for (Part* part : {&direct, &indirect}) part->r[i] = part->g[i] = part->b[i] = 0;
      emission.r[i] = static_cast<float>(color.x);
      emission.g[i] = static_cast<float>(color.y);
      emission.b[i] = static_cast<float>(color.z);
    }
  }
};

/// PathParts: the same while the paths are traced. `direct` is light that has reached the first
/// vertex that is no mirror and no clear glass straight from a light; `emission` what the camera,
/// or a mirror or glass that it sees, sees shine; `indirect` all else.
template <class Real>
class PathParts {
  using V = Vec3<Real>;

 public:
  /// What the path's own ray meets; what a light gives the vertex that it has come to.
  void add_met(const V& light) {
    emission_ = emission_ + only(seen_, light);
    direct_ = direct_ + only(straight_, light);
    indirect_ = indirect_ + only(!(seen_ || straight_), light);
  }
  void add_asked(const V& light) {
    direct_ = direct_ + only(seen_, light);
    indirect_ = indirect_ + only(!seen_, light);
  }
  /// The paths go on in a direction of that density; 0: of mirrors and of glass.
  void go_on(const Real& pdf) {
    const Mask<Real> scattered = pdf > Real(0);
    straight_ = seen_ && scattered;
    seen_ = seen_ && !scattered;
  }
  void dim(const Real& share) {
    for (V* part : {&direct_, &indirect_, &emission_}) *part = *part * share;
  }
  void store_to(LightParts& to) const {
    store_part(direct_, to.direct);
    store_part(indirect_, to.indirect);
    store_part(emission_, to.emission);
  }

 private:
  static V only(Mask<Real> those, const V& light) {
    return select(those, light, {Real(0), Real(0), Real(0)});
  }
  static void store_part(const V& part, LightParts::Part& to) {
    store(part.x, to.r.data());
    store(part.y, to.g.data());
    store(part.z, to.b.data());
  }

  V direct_{Real(0), Real(0), Real(0)}, indirect_ = direct_, emission_ = direct_;
  Mask<Real> seen_ = Real(0) < Real(1);      // nothing has scattered them yet
  Mask<Real> straight_ = Real(1) < Real(0);  // their last vertex is the first that has
};

}  // namespace tia
