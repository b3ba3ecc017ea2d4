// SkyMap: the light that comes from infinitely far, by direction, and directions drawn by it.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "core/lights/sky_picture.h"
#include "core/math/lanes.h"

namespace tia {

/// Where the sky stands above a scene: y is up, north is -z, east x. An azimuth is an angle from
/// north towards east, so that from above it goes clockwise.
/// Space/units: a share of a full turn; the cosine is that of the angle from the zenith.
Vec3d sky_direction(double azimuth_turn, double cosine);

/// SkyMap: texels by latitude and longitude, of which the middle column stands in the north, the
/// columns right of it in the east, row 0 around the zenith.
///
/// What is seen is bilinear between the texels' centres. Directions are drawn from cells of k x k
/// texels, k = 1 up to a width of 1024, by the cell's light (the exact mean of what is seen of it),
/// and evenly within a cell: the density is constant in each.
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., 12.5; but for the rows,
/// which are even in the cosine instead of the angle, so that no density grows at the poles.
class SkyMap {
 public:
  using Texels = std::variant<std::shared_ptr<const SkyPicture>, std::vector<Vec3f>>;

  /// Domain: width x height texels, none negative, all finite. Cost: a few passes over them.
  SkyMap(int width, int height, Texels texels);

  /// Linear RGB. Domain of all wi: unit; of all turns: the azimuth of the middle column.
  Vec3f radiance(const Vec3d& wi, double turn) const;
  struct Sample {
    Vec3d wi;
    double pdf = 0;  ///< by solid angle; 0: the map is black
  };
  Sample sample(double u, double v, double turn) const;
  /// The density of sample().
  double pdf(const Vec3d& wi, double turn) const;

  Vec3f texel(int x, int y) const;
  int width() const { return width_; }
  int height() const { return height_; }
  /// Space/units: bytes, its picture's included.
  std::size_t bytes() const;

 private:
  /// Place: in the map's square, x to the right and y down, each 0 .. 1.
  struct Place {
    double x, y;
  };
  static Place place_of(const Vec3d& wi, double turn);
  void weigh();
  double density(std::size_t column, std::size_t row) const;
  double left_edge(std::size_t column) const;
  double upper_edge(std::size_t row) const;

  int width_, height_, block_;
  Texels texels_;
  std::size_t columns_, rows_;    // of cells
  std::vector<double> below_;     // of each row and each of its cells: the share of those before it
  std::vector<double> rows_sum_;  // the same of the rows
  std::vector<double> cosines_;   // at the rows' edges
};

/// SkyForm: a map, turned.
struct SkyForm {
  std::shared_ptr<const SkyMap> map;
  double turn = 0;
};

/// What is seen of it in the lanes of `here`; elsewhere 0.
template <class Real>
Vec3<Real> radiance(const SkyForm& sky, const Vec3<Real>& wi, Mask<Real> here) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<LaneOf<Real>, n> r{}, g{}, b{};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const Vec3f light = sky.map->radiance({lane(wi.x, i), lane(wi.y, i), lane(wi.z, i)}, sky.turn);
    r[at] = light.x, g[at] = light.y, b[at] = light.z;
  }
  return {load<Real>(r.data()), load<Real>(g.data()), load<Real>(b.data())};
}
/// The density of sample_sky() by solid angle in the lanes of `here`; elsewhere 0.
template <class Real>
Real pdf_sky(const SkyForm& sky, const Vec3<Real>& wi, Mask<Real> here) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> each{};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    each[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(
        sky.map->pdf({lane(wi.x, i), lane(wi.y, i), lane(wi.z, i)}, sky.turn));
  }
  return load<Real>(each.data());
}
template <class Real>
struct SkySample {
  Vec3<Real> wi;
  Real pdf;
};
/// Directions for points (u, v) of the unit square, in the lanes of `here`.
template <class Real>
SkySample<Real> sample_sky(const SkyForm& sky, const Real& u, const Real& v, Mask<Real> here) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<LaneOf<Real>, n> x{}, y{}, z{}, pdf{};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const SkyMap::Sample one = sky.map->sample(lane(u, i), lane(v, i), sky.turn);
    x[at] = static_cast<LaneOf<Real>>(one.wi.x);
    y[at] = static_cast<LaneOf<Real>>(one.wi.y);
    z[at] = static_cast<LaneOf<Real>>(one.wi.z);
    pdf[at] = static_cast<LaneOf<Real>>(one.pdf);
  }
  return {{load<Real>(x.data()), load<Real>(y.data()), load<Real>(z.data())},
          load<Real>(pdf.data())};
}

}  // namespace tia
