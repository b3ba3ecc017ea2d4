// Ambient occlusion, by closed forms of the share of the cosine-weighted hemisphere that is hidden.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// The picture's value where rays from `eye` meet the scene.
Mean free_sky(const Scene& scene, const Vec3d& eye, const Vec3d& to, double radius = 0,
              Scalar scalar = Scalar::wide) {
  RenderOptions options;
  options.integrator = IntegratorName::ambient_occlusion;
  options.samples = rounds(1024, 16);
  options.scalar = scalar;
  if (radius > 0) options.ao_radius = radius;
  const auto [r, g, b] = colors_from(scene, eye, to, options, 2);
  EXPECT_EQ(r.value, g.value);
  EXPECT_EQ(r.value, b.value);
  return r;
}
// The area of the unit disc beyond a chord at the distance c, as a share: what a wall hides beyond
// the slope c (Malley's projection of the sky onto the disc).
double segment(double c) { return (std::acos(c) - c * std::sqrt(1 - c * c)) / pi; }
// At a point with a frame.
struct Ground {
  Onb frame;
  Vec3d p;
  Scene scene;
  explicit Ground(Random& random) : frame(onb_around(random.direction())), p(random.point(5)) {
    scene.objects = {object(Plane{p, frame.n}, Finish{})};
  }
  Vec3d at(double x, double y, double z) const {
    return p + frame.u * x + frame.v * y + frame.n * z;
  }
  // Upright across the u axis, from the ground up, and so long that it has no ends.
  void add_wall(double x, double high) {
    add(mesh_of({at(x, -1e3, 0), at(x, 1e3, 0), at(x, 1e3, high), at(x, -1e3, high)},
                {0, 1, 2, 0, 2, 3}));
  }
  void add(const Shape& shape) { scene.objects.push_back(object(shape, Finish{})); }
};

TEST(AmbientOcclusion, IsOneUnderTheOpenSkyAndWhereNothingIsHit) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{})};
  EXPECT_EQ(free_sky(scene, {1, 2, 3}, {0, 0, 0}).value, 1);
  EXPECT_EQ(free_sky(scene, {1, 2, 3}, {1, 9, 3.5}).value, 1);
}

TEST(AmbientOcclusion, IsZeroInAClosedBall) {
  const Scene scene = [] {
    Scene closed;
    closed.objects = {ball({0, 0, 0}, 2)};
    return closed;
  }();
  EXPECT_EQ(free_sky(scene, {0.5, 0.2, 0.1}, {2, 1, 0}).value, 0);
}

// Over the point at the height h a disc of radius R hides R^2 / (R^2 + h^2).
// Source: the form factor from a small patch to a coaxial parallel disc (Howell, "A catalog of
// radiation heat transfer configuration factors", B-12).
TEST(AmbientOcclusion, BelowADiscIsItsFormFactorsComplement) {
  Random random(810);
  for (int i = 0; i < rounds(12, 4); ++i) {
    Ground ground(random);
    const double h = random.in(0.5, 2), r = random.in(0.3, 1.5);
    ground.add(Disc{ground.at(0, 0, h), ground.frame.n, r});
    const Vec3d eye = ground.at(0.7 * h, 0, 0.5 * h);  // from aside, below the disc
    expect_mean(free_sky(ground.scene, eye, ground.p, 0, i % 3 == 0 ? Scalar::exact : Scalar::wide),
                h * h / (h * h + r * r));
  }
}

// A wall at the distance d hides half of the sky; within a radius it hides the directions of the
// unit disc beyond d / radius; one of height H those up to it, (1 - d / sqrt(d^2 + H^2)) / 2.
TEST(AmbientOcclusion, BesideAWallIsWhatItLeaves) {
  Random random(811);
  for (int i = 0; i < rounds(8, 4); ++i) {
    Ground ground(random);
    const double d = random.in(0.2, 2), c = random.in(0.1, 0.9), high = random.in(0.2, 3);
    const Vec3d eye = ground.at(-1.5, 0.3, 1);
    Ground low = ground;
    ground.add(Plane{ground.at(d, 0, 0), ground.frame.u});
    expect_mean(free_sky(ground.scene, eye, ground.p), 0.5);
    EXPECT_EQ(free_sky(ground.scene, eye, ground.p, 0.99 * d).value, 1);
    expect_mean(free_sky(ground.scene, eye, ground.p, d / c), 1 - segment(c));
    low.add_wall(d, high);
    expect_mean(free_sky(low.scene, eye, low.p), 1 - (1 - d / std::hypot(d, high)) / 2, 1e-4);
  }
}

// Of two walls at right angles a quarter of the sky is left, wherever; within a radius what each
// leaves alone, as long as it does not reach the corner.
TEST(AmbientOcclusion, InACornerIsAQuarter) {
  Random random(812);
  for (int i = 0; i < rounds(8, 4); ++i) {
    Ground ground(random);
    const double turn = random.in(0.3, 1.2), corner = random.in(0.5, 3);
    const double x = corner * std::cos(turn), y = corner * std::sin(turn);
    ground.add(Plane{ground.at(x, 0, 0), ground.frame.u});
    ground.add(Plane{ground.at(0, y, 0), ground.frame.v});
    const Vec3d eye = ground.at(-0.7, -0.4, 1);
    expect_mean(free_sky(ground.scene, eye, ground.p), 0.25);
    const double radius = corner * random.in(0.95, 0.999);
    const double left = 1 - segment(std::min(1.0, x / radius)) - segment(std::min(1.0, y / radius));
    expect_mean(free_sky(ground.scene, eye, ground.p, radius), left);
  }
}

// A groove between two planes that meet at an angle leaves (1 - cos) / 2 of the sky of either; one
// with a flat floor (sin a + sin b) / 2, a and b the angles up to its rims. Source: Hottel's
// crossed strings, for what does not change along a line.
TEST(AmbientOcclusion, InAGrooveIsWhatIsBetweenItsRims) {
  Random random(813);
  for (int i = 0; i < rounds(8, 4); ++i) {
    Ground sharp(random), flat = sharp;
    const double angle = random.in(0.8, 2.5), away = random.in(0.3, 2);
    const Vec3d across = sharp.frame.n * std::cos(angle) - sharp.frame.u * std::sin(angle);
    sharp.add(Plane{sharp.at(-away, 0, 0), across});
    const double glance = angle / 2;
    const Vec3d eye = sharp.at(std::cos(glance), 0, std::sin(glance));
    expect_mean(free_sky(sharp.scene, eye, sharp.p), (1 - std::cos(angle)) / 2);

    const double deep = random.in(0.3, 1.5), left = random.in(0.2, 2), right = random.in(0.2, 2);
    flat.add_wall(-left, deep);
    flat.add_wall(right, deep);
    expect_mean(free_sky(flat.scene, flat.at(0.1, 0.5, 0.5), flat.p),
                (left / std::hypot(left, deep) + right / std::hypot(right, deep)) / 2, 1e-4);
  }
}

// A ball that rests on the ground at the distance d hides (r / D)^2 cos, D^2 = d^2 + r^2: r^3 /
// D^3.
TEST(AmbientOcclusion, BesideARestingBallIsItsFormFactorsComplement) {
  Random random(814);
  for (int i = 0; i < rounds(8, 4); ++i) {
    Ground ground(random);
    const double r = random.in(0.5, 2), d = random.in(0.3, 3) * r;
    ground.add(Sphere{ground.at(d, 0, r), r});
    const double share = std::pow(r / std::hypot(r, d), 3);
    expect_mean(free_sky(ground.scene, ground.at(-1, 0.3, 0.5), ground.p), 1 - share, 1e-4);
  }
}

// One ray a sample: two for what is hit, one for what is not.
TEST(AmbientOcclusion, CostsOneRayASample) {
  Scene scene;
  scene.objects = {object(Plane{{0, -1, 0}, {0, 1, 0}}, Finish{})};
  RenderOptions options;
  options.integrator = IntegratorName::ambient_occlusion;
  options.samples = 3;
  const RayCounts counts = picture(scene, 40, 30, options).rays;
  EXPECT_EQ(counts.primary, 3 * 40 * 30);
  EXPECT_GT(counts.shadow, 0);
  EXPECT_LT(counts.shadow, counts.primary);
}

}  // namespace
}  // namespace tia
