// Glass that parts colours, in path: where a prism sends each wavelength, by Snell's law.
#include "core/materials/spectrum.h"
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// A wedge of glass whose edge is the z axis, its inside towards -x, and beyond it a screen across
// the y axis that grows brighter along x. Rays come from -y.
struct PrismStage {
  double half, incidence, ior, dispersion;
  static constexpr double screen = 3, span = 0.8;
  double dark_end = 0;  // the screen's x where it is black
  Vec3d entry{};

  explicit PrismStage(Random& random)
      : half(random.in(0.2, 0.35)),
        incidence(random.in(0.2, 0.7)),
        ior(random.in(1.4, 1.7)),
        dispersion(random.in(0.3, 1)) {
    entry = Vec3d{-std::cos(half), -std::sin(half), 0} * random.in(0.5, 2);
    dark_end = seen(587.6).x - span / 2;
  }
  // Both outward normals.
  Vec3d n1() const { return {std::sin(half), -std::cos(half), 0}; }
  Vec3d n2() const { return {std::sin(half), std::cos(half), 0}; }
  Vec3d ray() const {
    return n1() * -std::cos(incidence) +
           Vec3d{std::cos(half), std::sin(half), 0} * std::sin(incidence);
  }

  struct Seen {
    double x, passed;  // where a wavelength meets the screen, and the share of it that does
  };
  Seen seen(double wave) const {
    const double n = index(wave);
    const Bent in = bent(ray(), n1(), n);
    // On to the other face, which goes through the edge.
    const Vec3d exit = entry + in.way * (-dot(entry, n2()) / dot(in.way, n2()));
    const Bent out = bent(in.way, -n2(), 1 / n);
    const double x = exit.x + out.way.x * ((screen - exit.y) / out.way.y);
    return {x, in.passed * out.passed};
  }
  // Cauchy's two terms, by the index at 587.6 nm and Abbe's number 20 / dispersion.
  double index(double wave) const {
    const auto over = [](double w) { return 1 / (w * w); };
    const double slope = (ior - 1) * dispersion / 20 / (over(486.1) - over(656.3));
    return ior + slope * (over(wave) - over(587.6));
  }
  struct Bent {
    Vec3d way;
    double passed;
  };
  // Snell's law and Fresnel's equations in angles; n: outwards, against the ray.
  static Bent bent(const Vec3d& way, const Vec3d& n, double eta) {
    const double a = std::acos(-dot(way, n)), b = std::asin(std::sin(a) / eta);
    const Vec3d along = normalize(way + n * std::cos(a));
    const double s = std::sin(a - b) / std::sin(a + b), p = std::tan(a - b) / std::tan(a + b);
    return {along * std::sin(b) - n * std::cos(b), 1 - (s * s + p * p) / 2};
  }

  Scene scene() const {
    Principled flint;
    flint.roughness = 0, flint.transmission = 1;
    flint.ior = ior, flint.dispersion = dispersion;
    Csg wedge;
    wedge.operation = Operation::intersection;
    wedge.children = {{"", Plane{{0, 0, 0}, n1()}, {}, {}}, {"", Plane{{0, 0, 0}, n2()}, {}, {}}};
    Object prism = object(wedge, {});
    prism.material = MaterialRef(Material{flint});
    Gradient along_x;
    along_x.colors = {Color{0, 0, 0}, Color{1, 1, 1}};
    along_x.scale = span;
    along_x.transform.steps.push_back(Translate{{dark_end, 0, 0}});
    Finish white = matt(1);
    white.texture = Texture{along_x};
    Scene scene;
    scene.objects = {prism, object(Plane{{0, screen, 0}, {0, -1, 0}}, white)};
    // Along the screen, so that the prism is in no light's way; of irradiance pi on it.
    scene.lights = {light_of(DirectionalLight{Vec3d{-0.8, 0.6, 0}})};
    scene.lights[0].intensity = pi / 0.6;
    return scene;
  }
};

// The mean over all wavelengths of what each finds where it meets the screen, by the colours that
// they have. What is mirrored at a face does not come to the screen within three events.
TEST(Prism, SendsEachChannelWhereTheMeanOfItsWavelengthsGoes) {
  Random random(846);
  for (int i = 0; i < rounds(3, 3); ++i) {
    const PrismStage stage(random);
    std::array<double, 3> expected{};
    constexpr int count = 3400;
    for (int k = 0; k < count; ++k) {
      const double wave = shortest_wave + (k + 0.5) / 10;
      const auto [x, passed] = stage.seen(wave);
      ASSERT_TRUE(x > stage.dark_end && x < stage.dark_end + PrismStage::span);
      const Vec3d light = wave_color(wave) * (passed * (x - stage.dark_end) / PrismStage::span);
      expected[0] += light.x / count, expected[1] += light.y / count,
          expected[2] += light.z / count;
    }
    const auto channels = colors_from(stage.scene(), stage.entry - stage.ray() * 2.0, stage.entry,
                                      by_paths(4096, 3), 2);
    for (std::size_t k = 0; k < 3; ++k) expect_mean(channels[k], expected[k], 1e-4);
    EXPECT_GT(channels[0].value - channels[2].value, 20 * channels[2].error) << "blue is bent more";
  }
}

}  // namespace
}  // namespace tia
