// Light that both a light's and a surface's samples find: each estimator alone, and both weighted,
// put together here from the parts that path is made of, give the same; and path's variance keeps
// the bound of multiple importance sampling.
#include "core/integrators/light_sampling.h"
#include "core/integrators/scatterers.h"
#include "core/math/sobol.h"
#include "core/math/unit_lanes.h"
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// A floor of rough metal, with and without matt ground, below lights of one size: a ball about
// where the floor mirrors the eye, and a luminous triangle aside.
struct Plates {
  Scene scene;
  Vec3d eye;

  Plates(Random& random, double roughness, double size) {
    Principled metal;
    metal.roughness = roughness;
    metal.metallic = random.chance(0.5) ? 1 : 0.5;
    metal.base_color = Color{0.7, 0.7, 0.7};
    Object floor = object(Plane{{0, 0, 0}, {0, 0, 1}}, {});
    floor.material = MaterialRef(Material{metal});
    const double slant = random.in(0.2, 1), bright = 1 / (size * size);
    eye = {-std::sin(slant), 0, std::cos(slant)};
    const Vec3d mirrored{-eye.x, 0, eye.z};
    const double far = random.in(1.5, 3);
    const Vec3d near = (mirrored + random.direction() * (0.5 * roughness)) * far;
    scene.lights = {sphere_light(near, size)};
    scene.lights[0].intensity = bright;  // the floor gets about the same of any size
    Finish glow = dark();
    glow.emission = {bright, bright, bright};
    const Vec3d a{-1, 1.5, 1}, along{0, size, 0}, up{0, 0, size};
    scene.objects = {floor, object(Triangle{a, a + along, a + up}, glow)};
  }
};

// What the two ways to sample find at the floor's origin.
class TwoWays {
 public:
  TwoWays(const World& world, const Vec3d& eye)
      : view_{world, {}},
        lights_(world),
        ray_{lift<Wide>(eye), lift<Wide>(-eye)},
        hit_(view_.closest(ray_, everywhere)),
        isect_(surfaces(view_, ray_, hit_, everywhere)),
        materials_(scatterers(world, hit_, isect_)),
        bsdf_(materials_.bsdf, -ray_.direction, isect_.at.n, isect_.at.ng, Wide(1), everywhere) {}

  // f L cos, and the densities of both ways.
  struct Found {
    Wide light = Wide(0), by_light = Wide(0), by_surface = Wide(0);
  };
  Found ask(const Wide& choice, const Wide& u, const Wide& v) {
    Found found;
    lights_.draw(isect_.at.p, isect_.at.ng, choice, u, v, everywhere,
                 [&](const LightDraw<Wide>& draw, Mask<Wide> those) {
                   const BsdfValue<Wide> value = bsdf_.value(draw.wi);
                   const Wide near = draw.distance * Wide(1 - 1e-4F);
                   const Mask<Wide> dark = occluded(view_.world, Ray<Wide>{start(), draw.wi}, near,
                                                    draw.own, those, view_.work);
                   const Wide light = select(dark, Wide(0), value.f_cos.x * draw.light.x);
                   found.light = select(those, light, found.light);
                   found.by_light = select(those, draw.pdf, found.by_light);
                   found.by_surface = select(those, value.pdf, found.by_surface);
                 });
    return found;
  }
  Found look(const Wide& lobe, const Wide& u, const Wide& v) {
    const BsdfSample<Wide> sample = bsdf_.sample(lobe, u, v);
    const Ray<Wide> ray{start(), sample.wi};
    const Hit<Wide> hit = view_.closest(ray, sample.here);
    const auto beyond = surfaces(view_, ray, hit, sample.here);
    const Mask<Wide> lit = beyond.here && beyond.emission.x > Wide(0);
    Found found;
    if (!any(lit)) return found;
    const Wide pdf = lights_.pdf(isect_.at.p, hit, beyond.at.p, lit, [&](int light, int i) {
      return lights_.chance(light, lane_of(isect_.at.p, i), lane_of(isect_.at.ng, i));
    });
    found.light = select(lit, sample.weight.x * sample.pdf * beyond.emission.x, Wide(0));
    found.by_surface = select(lit, sample.pdf, Wide(0));
    found.by_light = select(lit, pdf, Wide(0));
    return found;
  }

 private:
  Vec3<Wide> start() const { return isect_.at.p + isect_.at.ng * isect_.offset; }

  inline static const Mask<Wide> everywhere = Wide(0) == Wide(0);
  WorldView view_;
  LightSampling<Wide> lights_;
  Ray<Wide> ray_;
  Hit<Wide> hit_;
  decltype(surfaces(view_, ray_, hit_, everywhere)) isect_;
  Scatterers<Wide> materials_;
  Bsdf<Wide> bsdf_;
};

// Of an estimator: its mean by lanes, which have Sobol's points each, and its variance by samples.
struct Estimator {
  std::array<double, static_cast<std::size_t>(lanes<Wide>)> sums{};
  double sum = 0, squares = 0, fourths = 0;
  int count = 0;
  void add(int lane, double one) {
    sums[static_cast<std::size_t>(lane)] += one;
    sum += one, squares += one * one, fourths += one * one * one * one, ++count;
  }
  Mean mean() const {
    Estimates by_lanes;
    for (const double each : sums) by_lanes.add(each * static_cast<double>(sums.size()) / count);
    return by_lanes;
  }
  double relative_variance() const { return squares * count / (sum * sum) - 1; }
  // The standard error of the second moment, over the mean's square.
  double relative_error() const {
    return std::sqrt((fourths / count - squares / count * squares / count) / count) * count *
           count / (sum * sum);
  }
};
double quotient(double a, double b) { return b > 0 ? a / b : 0; }

// All four: of one sample each way at most.
struct Estimators {
  Estimator lights, surfaces, balance, power;

  Estimators(const World& world, const Vec3d& eye, int samples) {
    TwoWays ways(world, eye);
    std::array<std::uint32_t, static_cast<std::size_t>(lanes<Wide>)> x{}, y{};
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<std::uint32_t>(i);
    for (int i = 0; i < samples; ++i) {
      const auto words = [&](std::uint32_t block) {
        return sobol_words(x, y, static_cast<std::uint32_t>(i), block, RandomKey(11));
      };
      const auto first = words(0), second = words(1);
      const auto unit = [](const auto& each) { return unit_lanes<Wide>(each); };
      const TwoWays::Found asked = ways.ask(unit(first.c), unit(first.a), unit(first.b));
      const TwoWays::Found seen = ways.look(unit(first.d), unit(second.a), unit(second.b));
      for (int k = 0; k < lanes<Wide>; ++k) add(asked, seen, k);
    }
  }
  void add(const TwoWays::Found& asked, const TwoWays::Found& seen, int k) {
    const auto at = [&](const Wide& each) { return static_cast<double>(lane(each, k)); };
    const double f = at(asked.light), p = at(asked.by_light), q = at(asked.by_surface);
    const double g = at(seen.light), r = at(seen.by_light), s = at(seen.by_surface);
    lights.add(k, quotient(f, p));
    surfaces.add(k, quotient(g, s));
    balance.add(k, quotient(f, p + q) + quotient(g, r + s));
    power.add(k, quotient(f * p, p * p + q * q) + quotient(g * s, r * r + s * s));
  }
};

// Of one sample each way, w the weights: the second moment, the integral of f^2 (w1^2 / p1 +
// w2^2 / p2), is least by the balance heuristic, f^2 / (p1 + p2), and no more than 9/8 of that by
// the power heuristic: its quotient by t = p1 / p2 is (t^3 + 1) (t + 1) / (t^2 + 1)^2, greatest at
// t = 2 - sqrt(3). The squares of both ways' means are then taken off, mu^2 / 2 at least. With
// V + mu^2 as either way's own second moment, V(balance) <= V + mu^2 / 2, Veach's bound, and
// V(power) <= 9/8 V + 5/8 mu^2. Source: Veach, "Robust Monte Carlo methods for light transport
// simulation" (1997), theorem 9.2.
void expect_bounds(const Estimators& by, const Estimator& path) {
  const double least = std::min(by.lights.relative_variance(), by.surfaces.relative_variance());
  EXPECT_LE(by.balance.relative_variance(), least + 0.5 + 4 * by.balance.relative_error());
  for (const Estimator& power : {by.power, path})
    EXPECT_LE(power.relative_variance(), 9 * least / 8 + 0.625 + 4 * power.relative_error());
  EXPECT_NEAR(path.relative_variance(), by.power.relative_variance(),
              4 * std::hypot(path.relative_error(), by.power.relative_error()) + 1e-4);
}
// As many samples as make the standard error of 32 means small enough.
int samples_for(double relative_variance) {
  int samples = 64;
  while (samples < 5000 * relative_variance && samples < 1 << 14) samples *= 2;
  return samples;
}
// Path's own samples, each a pixel's.
Estimator single_samples(const Plates& plates, const World& world) {
  constexpr int side = 128;
  Camera camera;
  camera.location = plates.eye;
  camera.direction = -plates.eye;
  camera.up = {0, 1, 0};
  camera.fov_degrees = 1e-3;
  const Image image =
      picture(world, view_of(camera, side, side), {0, 0, side, side}, by_paths(1, 1)).image;
  Estimator path;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) path.add(0, double{image.rgb[i]});
  return path;
}

TEST(Estimators, OfLightsOfSurfacesAndOfBothAgreeAndBothKeepVeachsBound) {
  Random random(845);
  double of_lights = 0, of_surfaces = 0;  // the most that a single way's variance is of both ways'
  for (const double roughness : {0.2, 0.4, 0.8})
    for (const double size : {0.04, 0.2, 0.8}) {
      const Plates plates(random, roughness, size);
      const World world = compile(plates.scene);
      const Estimators by(world, plates.eye, rounds(4096, 16));
      const double variance = by.power.relative_variance();
      const Mean path = light_from(plates.scene, plates.eye, {0, 0, 0}, samples_for(variance), 1);
      expect_equal(path, by.power.mean(), 1e-4);
      for (const Estimator& other : {by.lights, by.surfaces, by.balance}) {
        const Mean mean = other.mean();
        EXPECT_NEAR(mean.value, path.value,
                    4 * std::hypot(mean.error, path.error) + 1e-4 * path.value)
            << roughness << ' ' << size;
      }
      expect_bounds(by, single_samples(plates, world));
      of_lights = std::max(of_lights, by.lights.relative_variance() / variance);
      of_surfaces = std::max(of_surfaces, by.surfaces.relative_variance() / variance);
    }
  // Where neither way alone would do.
  EXPECT_GT(of_lights, 100);
  EXPECT_GT(of_surfaces, 100);
}

}  // namespace
}  // namespace tia
