// BsdfParameters: a material as what a Bsdf needs of it.
#pragma once

#include "core/math/lanes.h"

namespace tia {

/// BsdfParameters: the shares by which a material is matt, metal, mirror and glass, together 1 at
/// most, and what lies over them. Linear RGB; of a compiled material in double, of the surfaces
/// that a packet has hit lane by lane. Named as in glTF where glTF has it.
template <class Real>
struct BsdfParameters {
  using V = Vec3<Real>;
  V base{Real(1), Real(1), Real(1)};  ///< the colour of matt and metal, without a texture's
  V tint{Real(1), Real(1), Real(1)};  ///< of what glass lets pass, without a texture's
  Real matt = Real(0), metal = Real(0), mirror = Real(0), glass = Real(0);
  V f0{Real(0), Real(0), Real(0)};  ///< what the layer over what is matt reflects, straight on
  Real f90 = Real(0);               ///< and grazing
  Real alpha_x = Real(0), alpha_y = Real(0);      ///< of GGX, along and across the grain
  Real grain_cos = Real(1), grain_sin = Real(0);  ///< how far the grain is turned
  Real coat = Real(0), coat_f0 = Real(0), coat_f90 = Real(0), coat_alpha = Real(1);
  V sheen{Real(0), Real(0), Real(0)};
  Real sheen_alpha = Real(1);
  Real ior = Real(1), dispersion = Real(0);  ///< of glass; 20 over Abbe's number
  Mask<Real> fresnel{};  ///< whether Fresnel's equations divide what meets glass; else all passes
  Mask<Real> covers{};   ///< whether the coat takes from what lies below it what it reflects
  Mask<Real> thin{};     ///< whether glass is a pane, without an inside
  Mask<Real> tinted{};   ///< whether a texture colours what glass lets pass

  /// Sets the lanes of `here` to a material's. The first call sets all lanes.
  void take(const BsdfParameters<double>& from, Mask<Real> here, bool first) {
    const auto number = [&](Real& to, double own) {
      to = first ? lift<Real>(own) : select(here, lift<Real>(own), to);
    };
    const auto color = [&](V& to, const Vec3d& own) {
      number(to.x, own.x), number(to.y, own.y), number(to.z, own.z);
    };
    const auto flag = [&](Mask<Real>& to, bool own) {
      if (own) to = to || here;
    };
    color(base, from.base), color(tint, from.tint), color(f0, from.f0), color(sheen, from.sheen);
    number(ior, from.ior), number(dispersion, from.dispersion), number(matt, from.matt),
        number(metal, from.metal), number(mirror, from.mirror);
    number(glass, from.glass), number(f90, from.f90);
    number(alpha_x, from.alpha_x), number(alpha_y, from.alpha_y);
    number(grain_cos, from.grain_cos), number(grain_sin, from.grain_sin);
    number(coat, from.coat), number(coat_f0, from.coat_f0), number(coat_f90, from.coat_f90);
    number(coat_alpha, from.coat_alpha), number(sheen_alpha, from.sheen_alpha);
    flag(fresnel, from.fresnel), flag(covers, from.covers), flag(thin, from.thin);
    flag(tinted, from.tinted);
  }
  /// Sets a lane's numbers to those of a material, but for what is the same at all of its points:
  /// indices, grain's angle and flags, which take() has set.
  void put(const BsdfParameters<double>& from, int i) {
    put_lane(base, i, from.base), put_lane(tint, i, from.tint), put_lane(f0, i, from.f0);
    put_lane(sheen, i, from.sheen), put_lane(sheen_alpha, i, from.sheen_alpha);
    put_lane(matt, i, from.matt), put_lane(metal, i, from.metal), put_lane(glass, i, from.glass);
    put_lane(f90, i, from.f90), put_lane(alpha_x, i, from.alpha_x);
    put_lane(alpha_y, i, from.alpha_y), put_lane(coat, i, from.coat);
    put_lane(coat_alpha, i, from.coat_alpha);
  }
  bool operator==(const BsdfParameters&) const = default;
};

}  // namespace tia
