// Who watches a picture: what is seen before it is done, and that this changes nothing.
#include <map>
#include <vector>

#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::bits_of;
using test::chance;
using test::denoised;
using test::of_room;
using test::picture;
using test::Picture;
using test::room_of_chance;
using test::square_between;
using test::with_budget;

/// Seen: one glimpse, with the picture that it showed.
struct Seen {
  bool is_preview = false;
  RayCounts rays = {};
  Reached reached = {};
  Image image;
};

/// Watched: all that was seen of a picture of the room, and the picture.
struct Watched {
  std::vector<Seen> seen = {};
  Picture picture;
};

Watched watched(RenderOptions options, int width = 40, int height = 30) {
  Watched all;
  options.watch = [&](const Glimpse& glimpse) {
    Seen seen{glimpse.is_preview, glimpse.rays, {}, Image(width, height)};
    LinearFilm film(width, height);
    seen.reached = glimpse.show([&](const FilmTile& tile) { film.put(tile); });
    seen.image = std::move(film).image();
    all.seen.push_back(std::move(seen));
  };
  all.picture = of_room(options, width, height);
  return all;
}

std::vector<int> samples_seen(const Watched& all) {
  std::vector<int> samples;
  for (const Seen& each : all.seen) samples.push_back(each.reached.samples);
  return samples;
}

TEST(Watch, ChangesNoByteAndNoCountOfThePicture) {
  for (const auto& [samples, noise] : {std::pair{1, 0.0}, {24, 0.0}, {100, 0.0}, {128, 0.03}})
    for (const int threads : {1, 7}) {
      RenderOptions options = chance(samples, noise);
      const Picture alone = of_room(options, 40, 30);
      options.threads = threads;
      const Watched all = watched(options);
      EXPECT_EQ(bits_of(all.picture.image), bits_of(alone.image)) << samples << ' ' << noise;
      EXPECT_EQ(all.picture.rays, alone.rays) << samples << ' ' << noise;
      ASSERT_TRUE(all.picture.reached);
      EXPECT_EQ(all.picture.reached->samples, samples);
    }
}

// Of what is no chance, too, tile by tile and by rounds.
TEST(Watch, ChangesNothingOfWhitted) {
  for (const auto& [samples, threshold] : {std::pair{1, 0.0}, {9, 0.0}, {4, 0.02}}) {
    RenderOptions options;
    options.integrator = IntegratorName::whitted;
    options.samples = samples;
    options.threshold = threshold;
    const Picture alone = of_room(options, 40, 30);
    const Watched all = watched(options);
    EXPECT_EQ(bits_of(all.picture.image), bits_of(alone.image)) << samples;
    EXPECT_EQ(all.picture.rays, alone.rays) << samples;
    EXPECT_EQ(all.seen.size() > 1, threshold > 0) << samples;
    // One ray a pixel is all that there is, or less than the first round.
    EXPECT_EQ(!all.seen.empty() && all.seen[0].is_preview, samples == 9) << samples;
  }
}

// Each round is the picture that as many samples give, with its rays and its noise.
TEST(Watch, SeesThePicturesOfFewerSamplesInOrder) {
  for (const double noise : {0.0, 0.02}) {
    const Watched all = watched(chance(100, noise));
    EXPECT_EQ(samples_seen(all), (std::vector{1, 2, 4, 8, 16, 32, 64}));
    for (const Seen& each : all.seen) {
      EXPECT_EQ(each.is_preview, each.reached.samples == 1);
      if (each.is_preview) continue;  // one sample asked for goes through the pixel's centre
      const Picture alone = of_room(with_budget(chance(each.reached.samples, noise)), 40, 30);
      EXPECT_EQ(bits_of(each.image), bits_of(alone.image)) << each.reached.samples;
      EXPECT_EQ(each.rays, alone.rays) << each.reached.samples;
      EXPECT_EQ(each.reached.noise, alone.reached->noise);
      EXPECT_EQ(each.reached.mean, alone.reached->mean);
    }
  }
}

// Of 96 x 96 pixels blocks of 2 x 2: the most are 8192.
TEST(Watch, FirstSeesOneRayOfEachBlock) {
  RenderOptions one;
  one.integrator = IntegratorName::whitted;
  const Watched all = watched(one, 96, 96);
  ASSERT_EQ(all.seen.size(), 1U);
  const Picture centers = of_room(one, 96, 96);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const float* const middle = centers.image.at(x / 2 * 2 + 1, y / 2 * 2 + 1);
      EXPECT_TRUE(std::equal(middle, middle + 3, all.seen[0].image.at(x, y))) << x << ' ' << y;
    }
  EXPECT_EQ(all.seen[0].rays, RayCounts{});
  EXPECT_EQ(all.seen[0].reached.mean, 0.25);
}

// As if one ray of a block told all of it.
Image in_blocks(Image image, int side) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.at(x / side * side + side / 2, y / side * side + side / 2), 3,
                  image.at(x, y));
  return image;
}

// A preview of a box, lit from behind the eye and by its walls, has at most half the squared error
// of the light that was traced for it.
TEST(Watch, SeesPreviewsOfChanceWithLessNoise) {
  const Scene scene = read_scene(R"({
      "camera": {"location": [0, 0, 3], "look_at": [0, 0, 0], "fov_degrees": 60},
      "objects": [{"type": "box", "min": [-2, -2, -4], "max": [2, 2, 4],
                   "material": {"color": [0.7, 0.7, 0.7], "diffuse": 1, "specular": 0}},
                  {"type": "sphere", "center": [0.5, -1, 0], "radius": 0.7,
                   "material": {"color": [0.8, 0.3, 0.2], "diffuse": 1, "specular": 0}}],
      "lights": [{"type": "sphere", "position": [0, 1.5, 3.4], "radius": 0.3, "intensity": 20}]})");
  RenderOptions options = chance(2);
  std::vector<Image> seen;
  options.watch = [&](const Glimpse& glimpse) {
    LinearFilm film(96, 96);
    glimpse.show([&](const FilmTile& tile) { film.put(tile); });
    seen.push_back(std::move(film).image());
  };
  picture(scene, 96, 96, options);
  ASSERT_EQ(seen.size(), 2U);
  const Image one = picture(scene, 96, 96, chance(1)).image;
  const Image many = picture(scene, 96, 96, chance(test::rounds(64, 16))).image;
  EXPECT_LT(2 * square_between(seen[0], many), square_between(in_blocks(one, 2), many));
  EXPECT_LT(2 * square_between(seen[1], many), square_between(one, many));
}

// Of other numbers of samples than powers of two, too.
TEST(Watch, ChangesNothingOfADenoisedPicture) {
  for (const auto& [samples, noise] : {std::pair{2, 0.0}, {11, 0.0}, {48, 0.03}})
    for (const int threads : test::cases({1, 7})) {
      RenderOptions options = denoised(chance(samples, noise));
      const Picture alone = of_room(options, 40, 30);
      options.threads = threads;
      const Watched all = watched(options);
      EXPECT_EQ(bits_of(all.picture.image), bits_of(alone.image)) << samples << ' ' << noise;
      EXPECT_EQ(all.picture.rays, alone.rays) << samples << ' ' << noise;
      EXPECT_EQ(all.picture.reached->samples, samples);
      EXPECT_EQ(all.picture.reached->most, samples);
    }
}

// At first as previews, none of which is farther from the light than its samples are; once 256 rays
// a pixel have been traced, denoised, as such a picture of so many samples is.
TEST(Watch, SeesADenoisedPictureClearUp) {
  const Watched all = watched(denoised(chance(test::sanitized() ? 12 : 150)));
  EXPECT_EQ(all.seen.size(), test::sanitized() ? 4U : 8U);
  EXPECT_EQ(all.seen.back().is_preview, test::sanitized());
  const Image many = of_room(chance(test::rounds(1024, 256)), 40, 30).image;
  for (const Seen& each : all.seen) {
    const int samples = each.reached.samples;
    EXPECT_EQ(each.is_preview, each.rays.all() < 256 * 40 * 30) << samples;
    if (samples == 1) continue;  // one sample asked for goes through the pixel's centre
    if (each.is_preview) {
      const Image noisy = of_room(chance(samples), 40, 30).image;
      EXPECT_LE(square_between(each.image, many), square_between(noisy, many)) << samples;
    } else {
      EXPECT_EQ(bits_of(each.image), bits_of(of_room(denoised(chance(samples)), 40, 30).image));
    }
  }
}

// Shadows fall on the backdrop's colour in what is seen, too.
TEST(Watch, SeesShadowsOnAGround) {
  Scene scene = room_of_chance();
  scene.objects = {scene.objects.get()[1]};
  scene.backdrop = Backdrop{Color{0.5, 0.25, 1}};
  scene.shadow_ground = ShadowGround{{0, 0, 0}, {0, 1, 0}};
  std::vector<Image> seen;
  RenderOptions options = chance(16);
  options.watch = [&](const Glimpse& glimpse) {
    LinearFilm film(40, 30);
    glimpse.show([&](const FilmTile& tile) { film.put(tile); });
    seen.push_back(std::move(film).image());
  };
  const Picture all = picture(scene, 40, 30, options);
  EXPECT_EQ(bits_of(all.image), bits_of(picture(scene, 40, 30, chance(16)).image));
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_EQ(bits_of(seen[3]), bits_of(picture(scene, 40, 30, chance(8)).image));
}

TEST(Watch, WhatIsNotShownIsNotTraced) {
  std::map<bool, int> told;
  RenderOptions options = chance(32);
  options.watch = [&](const Glimpse& glimpse) { ++told[glimpse.is_preview]; };
  const Picture drawn = of_room(options), alone = of_room(chance(32));
  EXPECT_EQ(bits_of(drawn.image), bits_of(alone.image));
  EXPECT_EQ(told[true], 1);   // of one sample
  EXPECT_EQ(told[false], 4);  // of 2, 4, 8, 16
}

// A budget ends whole rounds of 16, whoever watches.
TEST(Watch, LeavesBudgetsTheirRounds) {
  const std::int64_t rays = of_room(chance(16)).rays.all();
  RenderOptions options = with_budget(chance(256), {.max_rays = 3 * rays});
  options.watch = [](const Glimpse&) {};
  EXPECT_EQ(of_room(options).reached->samples, 32);
  options = with_budget(chance(256), {.max_rays = rays - 1});
  options.watch = [](const Glimpse&) {};
  EXPECT_THROW(of_room(options), BudgetSpent);
}

TEST(Watch, WhoStopsWatchingEndsIt) {
  struct Left {};
  RenderOptions options = chance(64);
  int told = 0;
  options.watch = [&](const Glimpse&) {
    if (++told == 3) throw Left();
  };
  EXPECT_THROW(of_room(options), Left);
  EXPECT_EQ(told, 3);
}

}  // namespace
}  // namespace tia
