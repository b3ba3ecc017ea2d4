// Pictures for a gaze: which pixels are traced themselves, how many rays there are beside, and what
// is filled in between.
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "core/film/similarity.h"
#include "core/render/gaze_fill.h"
#include "core/render/gaze_slope.h"
#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::chance;
using test::picture;
using test::Random;
using test::room_of_chance;

constexpr double degree = std::numbers::pi / 180;

double angle(const Vec3d& a, const Vec3d& b) {
  return 2 * std::asin(length(normalize(a) - normalize(b)) / 2);
}
// The way to a point of the raster, by the definition of a view.
Vec3d way_to(const View& view, double x, double y) {
  return view.forward + view.right * (2 * x / view.width - 1) + view.up * (1 - 2 * y / view.height);
}
double seen_at(const Gaze& gaze, double eccentricity) {
  return gaze.acuity.slope * eccentricity + gaze.acuity.w0_degrees * degree;
}
bool is_sharp(const View& view, const Gaze& gaze, double x, double y) {
  const double e = angle(way_to(view, x, y), way_to(view, gaze.x, gaze.y));
  return seen_at(gaze, e) <= angle(way_to(view, x, y - 0.5), way_to(view, x, y + 0.5));
}

View view_of_fov(double fov_degrees, int width, int height) {
  Camera camera;
  camera.look_at = Vec3d{0.3, -0.2, -1};
  camera.fov_degrees = fov_degrees;
  return view_of(camera, width, height);
}
RenderOptions looking(const Gaze& gaze, RenderOptions options = {}) {
  options.gaze = gaze;
  return options;
}

struct Traced {
  const char* law;
  IntegratorName integrator;
  int samples;
};
void PrintTo(const Traced& traced, std::ostream* out) { *out << traced.law; }
class GazeFoveaOf : public testing::TestWithParam<Traced> {};

TEST_P(GazeFoveaOf, IsTheFullPictureBitForBitAndNothingElseIsTraced) {
  constexpr int w = 96, h = 64;
  const World world = compile(room_of_chance());
  const View view = view_of(room_of_chance().camera, w, h);
  RenderOptions options = chance(GetParam().samples);
  options.integrator = GetParam().integrator;
  const Image full = picture(world, view, {0, 0, w, h}, options).image;
  for (const Gaze& gaze : {Gaze{48, 32, {0.2}}, Gaze{90.3, 5.5, {0.1}}, Gaze{-7, 40, {0.1}}}) {
    const test::Picture seen = picture(world, view, {0, 0, w, h}, looking(gaze, options));
    int sharp = 0;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        if (!is_sharp(view, gaze, x + 0.5, y + 0.5)) continue;
        ++sharp;
        for (int c = 0; c < 3; ++c) ASSERT_EQ(seen.image.at(x, y)[c], full.at(x, y)[c]);
      }
    const GazeCount count = GazeLimit(view, gaze, {0, 0, w, h}).count(gaze.acuity.slope);
    EXPECT_EQ(count.fovea, sharp);
    EXPECT_EQ(seen.rays.primary, count.all() * GetParam().samples);
  }
}
INSTANTIATE_TEST_SUITE_P(Is, GazeFoveaOf,
                         testing::Values(Traced{"whitted", IntegratorName::whitted, 1},
                                         Traced{"sampled", IntegratorName::whitted, 3},
                                         Traced{"path", IntegratorName::path, 2},
                                         Traced{"normal", IntegratorName::normal, 1},
                                         Traced{"object", IntegratorName::object, 1}),
                         [](const auto& info) { return std::string(info.param.law); });

TEST(Gaze, GivesTheSameBytesForScalarsThreadsTilesAndWindows) {
  constexpr int w = 100, h = 70;
  const World world = compile(room_of_chance());
  const View view = view_of(room_of_chance().camera, w, h);
  RenderOptions options = looking({30, 20, {0.1}}, chance(2));
  const Image all = picture(world, view, {0, 0, w, h}, options).image;
  const Window window{21, 9, 77, 50};
  options.scalar = Scalar::narrow, options.threads = 3, options.tile = 8;
  const Image part = picture(world, view, window, options).image;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(part.at(x, y)[c], all.at(x + window.x0, y + window.y0)[c]) << x << ' ' << y;
}

// The integral of 1 / w^2 over the directions of the periphery that the picture has, or that are no
// more than a ring beside it: over the sphere around the gaze, e by e and turn by turn.
double integral_of(const View& view, const Gaze& gaze) {
  const Vec3d to_gaze = normalize(way_to(view, gaze.x, gaze.y));
  const Vec3d a = normalize(cross(to_gaze, view.up)), b = cross(a, to_gaze);
  const double across = length(view.right), upwards = length(view.up);
  const Vec3d corners[] = {way_to(view, 0, 0), way_to(view, view.width, 0),
                           way_to(view, view.width, view.height), way_to(view, 0, view.height)};
  std::array<Vec3d, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = normalize(cross(corners[i], corners[(i + 1) % 4]));
    if (dot(sides[i], view.forward) < 0) sides[i] = -sides[i];
  }
  constexpr int turns = 180;
  double sum = 0;
  for (double e = 0.01 * degree, step = 0; e < std::numbers::pi; e += step) {
    const double w = seen_at(gaze, e);
    step = w / 2;
    for (int i = 0; i < turns; ++i) {
      const double turn = 2 * std::numbers::pi * (i + 0.5) / turns;
      const Vec3d d =
          to_gaze * std::cos(e) + (a * std::cos(turn) + b * std::sin(turn)) * std::sin(e);
      if (!std::ranges::all_of(sides, [&](auto& side) { return dot(d, side) >= -std::sin(w); }))
        continue;
      const double z = dot(d, view.forward);
      const double x = (dot(d, view.right) / (across * across) / z + 1) * view.width / 2;
      const double y = (1 - dot(d, view.up) / (upwards * upwards) / z) * view.height / 2;
      if (z > 0 && x > 0 && x < view.width && y > 0 && y < view.height &&
          is_sharp(view, gaze, x, y))
        continue;
      sum += step * std::sin(e) * 2 * std::numbers::pi / turns / (w * w);
    }
  }
  return sum;
}

TEST(Gaze, TakesAsManyRaysAsTheIntegralSays) {
  Random random(5);
  for (int i = 0; i < test::rounds(8, 2); ++i) {
    const int w = random.whole(300, 1920), h = random.whole(300, 1080);
    const double fov = random.in(20, 100), x = random.in(-0.2, 1.2), y = random.in(-0.2, 1.2);
    const View view = view_of_fov(fov, w, h);
    const Gaze gaze{x * w, y * h, {random.in(0.022, 0.0275)}};
    const GazeCount count = GazeLimit(view, gaze, {0, 0, w, h}).count(gaze.acuity.slope);
    const double expected = static_cast<double>(count.fovea) + integral_of(view, gaze);
    EXPECT_NEAR(static_cast<double>(count.all()) / expected, 1, 0.05)
        << w << " x " << h << " fov " << fov << " gaze " << gaze.x << ' ' << gaze.y;
  }
}

TEST(Gaze, OfAFullPictureTakesLessThanAnEighthOfItsRays) {
  const View view = view_of_fov(60, 1920, 1080);
  const GazeCount count = GazeLimit(view, {960, 540}, {0, 0, 1920, 1080}).count(Acuity{}.slope);
  EXPECT_LT(8 * count.all(), 1920 * 1080);
}

TEST(Gaze, KeepsToItsRaysAndUsesThem) {
  Random random(6);
  for (int i = 0; i < test::rounds(8, 2); ++i) {
    const int w = random.whole(100, 800), h = random.whole(100, 800);
    const double x = random.in(-0.2, 1.2), fov = random.in(20, 100);
    const Gaze gaze{x * w, random.in(0, 1) * h};
    const GazeLimit limit(view_of_fov(fov, w, h), gaze, {0, 0, w, h});
    const std::int64_t all = limit.count(gaze.acuity.slope).all(), most = all * 2 / 5;
    EXPECT_EQ(limit.slope_within(all), gaze.acuity.slope);
    const auto slope = limit.slope_within(most);
    ASSERT_TRUE(slope);
    EXPECT_LE(limit.count(*slope).all(), most);
    EXPECT_GT(limit.count(*slope).all() * 100, most * 97);
    EXPECT_EQ(limit.slope_within(1), std::nullopt);
  }
}

TEST(Gaze, ShowsAConstantAsItIs) {
  Scene scene;
  scene.background = {0.1, 0.1, 0.1};
  const Image image =
      picture(compile(scene), view_of_fov(60, 90, 60), {0, 0, 90, 60}, looking({20, 70})).image;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) ASSERT_EQ(image.rgb[i], 0.1F);
}

// Rays that find two angles: how far they are from the gaze, and from a plane through the eye.
TEST(Gaze, ShowsARampOfAnglesAsItIs) {
  const int w = 320, h = 200;
  const View view = view_of_fov(70, w, h);
  const Gaze gaze{110, 60};
  const Vec3d to_gaze = way_to(view, gaze.x, gaze.y), side = normalize(view.right);
  const auto aside = [&](const Vec3d& d) { return std::asin(dot(normalize(d), side)); };
  const Window window{0, 0, w, h};
  const GazeFrame frame(view, gaze.x, gaze.y);
  const GazeFovea fovea(frame, gaze.acuity, window);
  const GazeRings rings(frame, gaze.acuity, fovea, window);
  std::vector<GazeSample> samples(static_cast<std::size_t>(rings.rays()));
  for (const GazeRing& ring : rings.rings())
    for (const Arc& arc : ring.arcs)
      for (int i = arc.begin; i < arc.end; ++i) {
        const double turn = ring.start + static_cast<double>(i) / ring.count;
        const Vec3d d = frame.place(ring.eccentricity, turn).direction;
        samples[static_cast<std::size_t>(arc.slot + i - arc.begin)] = {
            {static_cast<float>(angle(d, to_gaze)), static_cast<float>(aside(d)), 0, 0}};
      }
  const GazeFilling filling{frame, fovea, rings, samples, gaze.acuity.slope, false};
  FilmTile tile;
  tile.width = tile.height = FilmTile::size;
  for (tile.y = 0; tile.y + tile.height <= h; tile.y += tile.height)
    for (tile.x = 0; tile.x + tile.width <= w; tile.x += tile.width) {
      fill_from_rings(filling, 0, 0, tile);
      for (int i = 0; i < FilmTile::size * FilmTile::size; ++i) {
        const int x = i % FilmTile::size, y = i / FilmTile::size;
        const Vec3d d = way_to(view, tile.x + x + 0.5, tile.y + y + 0.5);
        if (fovea.has(tile.x + x, tile.y + y, gaze.acuity.slope)) continue;
        const std::size_t at = FilmTile::index(x, y);
        ASSERT_NEAR(static_cast<double>(tile.r[at]), angle(d, to_gaze), 1e-5);
        ASSERT_NEAR(static_cast<double>(tile.g[at]), aside(d), 1e-3) << tile.x + x;
      }
    }
}

TEST(Gaze, ShowsNumbersThatHaveNoMeanByTheNearestRay) {
  RenderOptions options = looking({10, 10, {0.3}});
  options.integrator = IntegratorName::object;
  const Image image = picture(room_of_chance(), 80, 60, options).image;
  const std::set<float> numbers(image.rgb.begin(), image.rgb.end());
  EXPECT_EQ(numbers, (std::set<float>{0, 1, 2}));
}

TEST(Gaze, IsNearerToTheFullPictureWithMoreRaysInEachBand) {
  constexpr int w = 160, h = 120;
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  const View view = view_of(room_of_chance().camera, w, h);
  const auto band = [&](int x, int y) {
    const double e = angle(way_to(view, x + 0.5, y + 0.5), way_to(view, 80, 60)) / degree;
    return e < 5 ? 0 : e < 15 ? 1 : 2;
  };
  const Image full = picture(room_of_chance(), w, h, options).image;
  std::array<double, 3> before{};
  for (const double slope : {0.4, 0.2, 0.1, 0.05}) {
    const Image seen = picture(room_of_chance(), w, h, looking({80, 60, {slope}}, options)).image;
    const Similarities all = similarity_of(full, seen, 3, band);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GT(*all.classes[i].ssim, before[i] - 0.002) << slope << ' ' << i;
      before[i] = *all.classes[i].ssim;
    }
  }
  EXPECT_GT(before[0], 0.99);
}

}  // namespace
}  // namespace tia
