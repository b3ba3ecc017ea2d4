#include "core/materials/albedo_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/lanes.h"

namespace tia {
namespace {

#include "core/materials/albedo_tables.inc"

using namespace albedo_tables;

// Between which two of n nodes x in [0,1] lies, and how far on.
template <class Scalar>
struct Between {
  std::size_t node;
  Scalar on;
  Between(Scalar x, int n) {
    const Scalar at = std::clamp(x, Scalar(0), Scalar(1)) * static_cast<Scalar>(n - 1);
    node = static_cast<std::size_t>(std::min(static_cast<int>(at), n - 2));
    on = at - static_cast<Scalar>(node);
  }
  Scalar mix(Scalar a, Scalar b) const { return a + (b - a) * on; }
};
template <class Scalar>
Scalar value(const float* table, const Between<Scalar>& x) {
  return x.mix(Scalar(table[x.node]), Scalar(table[x.node + 1]));
}
template <class Scalar>
Scalar value(const float* table, std::size_t width, const Between<Scalar>& x,
             const Between<Scalar>& y) {
  const float* row = table + y.node * width;
  return y.mix(value(row, x), value(row + width, x));
}
template <class Scalar>
Scalar value(const float* table, std::size_t width, std::size_t height, const Between<Scalar>& x,
             const Between<Scalar>& y, const Between<Scalar>& z) {
  const float* layer = table + z.node * width * height;
  return z.mix(value(layer, width, x, y), value(layer + width * height, width, x, y));
}

// Calls of(i) for each lane, which gives its number.
template <class Real, class F>
Real each_lane(F of) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> each;
  for (std::size_t i = 0; i < each.size(); ++i) each[i] = of(static_cast<int>(i));
  return load<Real>(each.data());
}

template <class Scalar>
Between<Scalar> index_between(Scalar eta) {
  const Scalar index = (eta - 1) / (eta + 1);
  return {(index / static_cast<Scalar>(last_index) + 1) / 2, glass_indices};
}

}  // namespace

template <class Real>
SchlickAlbedo<Real> schlick_albedo(const Real& mu, const Real& rough) {
  using Scalar = LaneOf<Real>;
  using std::sqrt;
  const Real root = sqrt(max_of(mu, Real(0)));
  const auto of = [&](const float* table) {
    return each_lane<Real>([&](int i) {
      return value(table, metal_nodes, Between<Scalar>(lane(root, i), metal_nodes),
                   Between<Scalar>(lane(rough, i), metal_nodes));
    });
  };
  return {of(reflected_a), of(reflected_b)};
}

template <class Real>
SchlickAlbedo<Real> mean_schlick_albedo(const Real& rough) {
  using Scalar = LaneOf<Real>;
  const auto of = [&](const float* table) {
    return each_lane<Real>(
        [&](int i) { return value(table, Between<Scalar>(lane(rough, i), metal_nodes)); });
  };
  return {of(mean_a), of(mean_b)};
}

template <class Real>
Real glass_albedo(const Real& mu, const Real& rough, const Real& eta) {
  using Scalar = LaneOf<Real>;
  using std::sqrt;
  const Real root = sqrt(max_of(mu, Real(0)));
  return each_lane<Real>([&](int i) {
    return value(glass, glass_nodes, glass_nodes, Between<Scalar>(lane(root, i), glass_nodes),
                 Between<Scalar>(lane(rough, i), glass_nodes), index_between(lane(eta, i)));
  });
}

template <class Real>
Real mean_glass_albedo(const Real& rough, const Real& eta) {
  using Scalar = LaneOf<Real>;
  return each_lane<Real>([&](int i) {
    return value(mean_glass, glass_nodes, Between<Scalar>(lane(rough, i), glass_nodes),
                 index_between(lane(eta, i)));
  });
}

template <class Real>
SchlickAlbedo<Real> mean_grain_albedo(const Real& rough_x, const Real& rough_y) {
  using Scalar = LaneOf<Real>;
  const auto of = [&](const float* table) {
    return each_lane<Real>([&](int i) {
      return value(table, grain_nodes, Between<Scalar>(lane(rough_x, i), grain_nodes),
                   Between<Scalar>(lane(rough_y, i), grain_nodes));
    });
  };
  return {of(mean_grain_a), of(mean_grain_b)};
}

template <class Real>
Real mean_grain_glass_albedo(const Real& rough_x, const Real& rough_y, const Real& eta) {
  using Scalar = LaneOf<Real>;
  return each_lane<Real>([&](int i) {
    return value(mean_grain_glass, grain_glass_nodes, grain_glass_nodes,
                 Between<Scalar>(lane(rough_x, i), grain_glass_nodes),
                 Between<Scalar>(lane(rough_y, i), grain_glass_nodes), index_between(lane(eta, i)));
  });
}

template <class Real>
Real sheen_albedo(const Real& mu, const Real& rough) {
  using Scalar = LaneOf<Real>;
  using std::sqrt;
  const Real root = sqrt(max_of(mu, Real(0)));
  return each_lane<Real>([&](int i) {
    return value(velvet, sheen_nodes, Between<Scalar>(lane(root, i), sheen_nodes),
                 Between<Scalar>(lane(rough, i), sheen_nodes));
  });
}

#define TIA_ALBEDO(Real)                                                        \
  template SchlickAlbedo<Real> schlick_albedo(const Real&, const Real&);        \
  template SchlickAlbedo<Real> mean_schlick_albedo(const Real&);                \
  template Real glass_albedo(const Real&, const Real&, const Real&);            \
  template Real mean_glass_albedo(const Real&, const Real&);                    \
  template SchlickAlbedo<Real> mean_grain_albedo(const Real&, const Real&);     \
  template Real mean_grain_glass_albedo(const Real&, const Real&, const Real&); \
  template Real sheen_albedo(const Real&, const Real&);
TIA_ALBEDO(Wide)
TIA_ALBEDO(float)
TIA_ALBEDO(double)

}  // namespace tia
