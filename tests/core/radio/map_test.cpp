// Maps: each cell is what /radio/paths tells at its centre; quantities by hand; pictures by
// numbers.
#include "core/radio/radio_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/film/palette.h"
#include "core/parallel/pool.h"
#include "core/radio/decibels.h"
#include "core/radio/map_picture.h"
#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::box_text;
using test::link;
using test::paths_of;
using test::point_in;
using test::radio_scene;
using test::Random;
using test::triple;

// The places of a map do not care for a NaN's bits.
bool same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : std::memcmp(&a, &b, sizeof a) == 0;
}

RadioMapQuestion map_of(const Vec3d& tx, RadioMethod method = RadioMethod::hybrid) {
  RadioMapQuestion question;
  question.tx = {tx};
  question.frequency_hz = 2.4e9;
  question.method = method;
  question.rays = 2000;
  return question;
}

// Two rooms with a door between and things in them, all but the outer walls of glass.
std::string rooms(Random& random) {
  std::string text =
      test::plane_text({}, {0, 1, 0}) + "," + test::plane_text({0, 3, 0}, {0, -1, 0});
  for (const auto& [low, high] :
       {std::pair{Vec3d{0, 0, 0}, Vec3d{8, 3, 0.2}}, std::pair{Vec3d{0, 0, 4.8}, Vec3d{8, 3, 5}},
        std::pair{Vec3d{3.9, 0, 0.2}, Vec3d{4.1, 3, 3}}})
    text += "," + box_text(low, high);
  for (int i = 0; i < 2; ++i) {
    const Vec3d low = point_in(random, {0.5, 0, 0.5}, {7, 0.5, 4});
    text += "," + box_text(low, low + point_in(random, {0.2, 1.5, 0.2}, {0.9, 2, 0.7}));
  }
  return text;
}
const char* const glass = R"({"type":"itu","name":"glass","through":true})";

void expect_paths_at_centers(const Scene& scene, const RadioMapQuestion& question,
                             const RadioMap& map, int every) {
  const bool waves = question.combine == MapCombine::coherent;
  int told = 0;
  for (int i = 0; i < static_cast<int>(map.values.size()); ++i) {
    const double is = map.values[static_cast<std::size_t>(i)];
    told += std::isnan(is) ? 0 : 1;
    if (map.inside[static_cast<std::size_t>(i)] != 0) EXPECT_TRUE(std::isnan(is));
    if (map.inside[static_cast<std::size_t>(i)] != 0 || i % every != 0) continue;
    const RadioQuestion paths =
        paths_question(question, map.grid, i % map.grid.width, i / map.grid.width);
    const RadioTotal total = radio_paths(scene, paths).pairs.front().total;
    const auto& gain = waves ? total.coherent_db : total.incoherent_db;
    EXPECT_TRUE(same(is, gain.value_or(std::nan("")))) << i << " " << is;
  }
  EXPECT_GT(told, static_cast<int>(map.values.size()) / 4);
}

TEST(RadioMap, EachCellIsThePathsAtItsCenterWhateverTheMethodAndTheThreads) {
  Random random(11);
  Pool two(2), seven(7);
  for (const RadioMethod method : {RadioMethod::hybrid, RadioMethod::image, RadioMethod::sbr}) {
    const Scene scene = radio_scene(rooms(random), glass);
    RadioMapQuestion question = map_of(point_in(random, {0.6, 2.7, 1}, {3, 2.9, 4}), method);
    question.area = {{0.03, 0.05, 7.7, 4.9}};
    question.cell = 0.73;
    question.max_reflections = method == RadioMethod::image ? 2 : 3;
    question.max_transmissions = 1;
    question.max_diffractions = method == RadioMethod::image ? 1 : 0;
    question.combine = method == RadioMethod::image ? MapCombine::coherent : MapCombine::incoherent;
    const RadioMap map = radio_map(scene, question);
    expect_paths_at_centers(scene, question, map, 5);
    for (Pool* pool : {&two, &seven}) {
      const RadioMap again = radio_map(scene, question, {}, pool->workers(pool->threads()));
      EXPECT_TRUE(std::equal(map.values.begin(), map.values.end(), again.values.begin(), same));
      EXPECT_EQ(map.counts.images, again.counts.images);
    }
  }
}

TEST(RadioMap, EachCellIsThePathsAtItsCenterByWayOfABall) {
  const Scene scene =
      radio_scene(test::plane_text({}, {0, 1, 0}) +
                  R"(,{"type":"sphere","material":"m","center":[2,1,0],"radius":0.8})");
  RadioMapQuestion question = map_of({-2, 2, 0.3});
  question.area = {{-3, -2, 4, 2}};
  question.cell = 1;
  question.height = 1;
  question.max_reflections = 2;
  const RadioMap map = radio_map(scene, question);
  EXPECT_EQ(map.inside[11], 1);  // the cell at (1.5, 0.5)
  expect_paths_at_centers(scene, question, map, 3);
}

// On a grid, whose points see edges of bodies in simple directions, too.
TEST(RadioMap, CellsInBodiesAreThoseInTheirBoxes) {
  Random random(3);
  std::string text;
  std::vector<std::array<double, 4>> boxes;
  for (int i = 0; i < 8; ++i) {
    const auto tenth = [&](double from, double to) {
      return std::round(random.in(from, to) * 10) / 10;
    };
    const double x = tenth(0, 4), z = tenth(0, 4), wide = tenth(0.3, 2), deep = tenth(0.3, 2);
    boxes.push_back({x, z, x + wide, z + deep});
    text += (i > 0 ? "," : "") + box_text({x, 0, z}, {x + wide, 2.0 + i, z + deep});
  }
  RadioMapQuestion question = map_of({-1, 1.5, -1}, RadioMethod::image);
  question.area = {{0, 0, 6, 6}};
  question.cell = 0.1;
  question.max_reflections = 0;
  const RadioMap map = radio_map(radio_scene(text), question);
  for (int i = 0; i < 3600; ++i) {
    const Vec3d p = map.grid.center(i % 60, i / 60);
    const bool is = std::any_of(boxes.begin(), boxes.end(), [&](const auto& b) {
      return b[0] < p.x && p.x < b[2] && b[1] < p.z && p.z < b[3];
    });
    ASSERT_EQ(map.inside[static_cast<std::size_t>(i)] != 0, is) << triple(p);
  }
}

// The points where one is left and the other entered are the same, which tell no direction.
TEST(RadioMap, WallsThatTouchAreGoneThroughOneByOne) {
  const auto gain = [](const std::string& boxes) {
    RadioQuestion question = link({0, 1, 0}, {9, 1, 0}, RadioMethod::image, 2.4e9);
    question.max_transmissions = 2;
    return paths_of(radio_scene(boxes, glass), question).at(0).gain[0][0];
  };
  const std::string first = box_text({3, -9, -9}, {3.1, 9, 9}),
                    second = box_text({3.1, -9, -9}, {3.2, 9, 9});
  const Complex none = gain(""), one = gain(first), both = gain(first + "," + second);
  const Complex expected = one / none * one;
  EXPECT_NEAR(both.re, expected.re, 1e-15);
  EXPECT_NEAR(both.im, expected.im, 1e-15);
  EXPECT_GT(norm_of(both), 0.05 * norm_of(none));
}

// Friis, "A note on a simple transmission formula" (1946): (lambda / 4 pi d)^2.
TEST(RadioMap, QuantitiesInFreeSpaceAreFriis) {
  const Scene empty = radio_scene("");
  RadioMapQuestion question;
  question.frequency_hz = 3e9;
  question.transmitters = {{.position = {0, 3, 0}, .power_dbm = 10},
                           {.position = {20, 3, 4}, .power_dbm = 13}};
  question.area = {{-2, -3, 26, 9}};
  question.cell = 4;
  question.noise_dbm = -70;
  const auto map_in = [&](MapQuantity quantity) {
    question.quantity = quantity;
    return radio_map(empty, question);
  };
  const RadioMap gain = map_in(MapQuantity::gain), power = map_in(MapQuantity::power);
  const RadioMap best = map_in(MapQuantity::best_server), sinr = map_in(MapQuantity::sinr);
  const RadioMap spread = map_in(MapQuantity::delay_spread);
  ASSERT_EQ(gain.grid.width, 7);
  ASSERT_EQ(gain.grid.height, 3);
  const double lambda = speed_of_light / 3e9;
  for (std::size_t i = 0; i < gain.values.size(); ++i) {
    const Vec3d at{-2 + 4 * (static_cast<double>(i % 7) + 0.5), 1.5,
                   -3 + 4 * (static_cast<double>(i / 7) + 0.5)};
    std::array<double, 2> gains{}, dbm{};
    for (std::size_t t = 0; t < 2; ++t) {
      const double far = length(at - question.transmitters[t].position);
      gains[t] = 20 * std::log10(lambda / (4 * pi * far));
      dbm[t] = gains[t] + question.transmitters[t].power_dbm;
    }
    const std::size_t server = dbm[1] > dbm[0] ? 1 : 0;
    const double other = std::pow(10, dbm[1 - server] / 10);
    EXPECT_EQ(best.values[i], static_cast<double>(server));
    EXPECT_NEAR(gain.values[i], gains[server], 1e-9);
    EXPECT_NEAR(power.values[i],
                10 * std::log10(std::pow(10, dbm[0] / 10) + std::pow(10, dbm[1] / 10)), 1e-9);
    EXPECT_NEAR(sinr.values[i], dbm[server] - 10 * std::log10(other + 1e-7), 1e-9);
    EXPECT_LT(spread.values[i], 1e-20);  // of one path: what its delay is rounded by
  }
  EXPECT_EQ(unit_of(MapQuantity::power), "dBm");
}

// -174 dBm/Hz over 20 MHz are -100.99 dBm.
TEST(RadioMap, NoiseIsThermalWhereNoneIsTold) {
  RadioMapQuestion question = map_of({0, 1.5, 0});
  question.area = {{9.5, -0.5, 10.5, 0.5}};
  question.cell = 1;
  question.quantity = MapQuantity::sinr;
  const double received = 20 * std::log10(speed_of_light / 2.4e9 / (4 * pi * 10));
  EXPECT_NEAR(radio_map(radio_scene(""), question).values.at(0),
              received + 174 - 10 * std::log10(20e6), 1e-9);
}

std::string fault_of(const Scene& scene, const RadioMapQuestion& question) {
  try {
    radio_map(scene, question, {.max_cells = 10'000});
  } catch (const InputError& error) {
    return error.faults().front().pointer;
  }
  return "none";
}

TEST(RadioMap, RefusesWhatHasNoPlace) {
  RadioMapQuestion question = map_of({0, 2, 0});
  EXPECT_EQ(fault_of(radio_scene(""), question), "/area");
  question.area = {{0, 0, 100, 100}};
  question.cell = 0.5;
  EXPECT_EQ(fault_of(radio_scene(""), question), "/cell");
  question.cell = 20;
  const std::string box = box_text({-1, 0, -1}, {1, 3, 1});
  EXPECT_EQ(fault_of(radio_scene(box), question), "/tx/0");
}

TEST(RadioMap, AnyPlaneHasItsCellsAlongItsSides) {
  RadioMapQuestion question = map_of({0, 0, 5});
  question.origin = Vec3d{1, 6, 0}, question.u = Vec3d{0, 0, -8}, question.v = Vec3d{0, -4, 0};
  question.cell = 2;
  const RadioMap map = radio_map(radio_scene(""), question);
  EXPECT_EQ(map.grid.width, 4);
  EXPECT_EQ(map.grid.height, 2);
  EXPECT_EQ(map.grid.center(3, 1), (Vec3d{1, 3, -7}));
}

std::array<std::uint8_t, 3> pixel(const Image8& image, int x, int y) {
  const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

// Each cell's pixels have the colour that the legend has at its value, or its contour's.
TEST(RadioMap, APictureShowsItsNumbersAndTheLegendTellsThem) {
  RadioMapQuestion question = map_of({0, 2, 0});
  question.area = {{-4, -3, 6, 5}};
  question.cell = 0.25;
  const Scene scene = radio_scene(box_text({2, 0, -1}, {3, 3, 2}));
  const RadioMap map = radio_map(scene, question);
  const MapLook look{4, true, {}};
  const Image8 image = map_picture(map, MapQuantity::gain, look);
  const MapScale scale = scale_of(map, MapQuantity::gain, look);
  ASSERT_EQ(image.width, 40 * 4 + 72);
  ASSERT_EQ(image.height, 160);
  int plain = 0, contours = 0;
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 40; ++column) {
      const auto i = static_cast<std::size_t>(row * 40 + column);
      const auto is = pixel(image, 4 * column + 1, 4 * row + 1);
      if (is == std::array<std::uint8_t, 3>{0, 0, 0}) continue;  // a wall's line
      if (map.inside[i] != 0) EXPECT_EQ(is[0], 72);
      if (std::isnan(map.values[i])) continue;
      auto color = viridis((map.values[i] - scale.low) / (scale.high - scale.low));
      if (is == color) ++plain;
      for (std::uint8_t& each : color) each = static_cast<std::uint8_t>(each * 5 / 8);
      if (is == color) ++contours;
      // In the legend the same colour stands where the value does.
      const double part = (map.values[i] - scale.low) / (scale.high - scale.low);
      const int y = std::min(static_cast<int>(152 - part * 136), 151);
      const auto beside = pixel(image, 160 + 12, y);
      const auto own = viridis(part);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(beside[k], own[k], 6);
    }
  int told = 0;
  for (const double each : map.values) told += std::isnan(each) ? 0 : 1;
  EXPECT_GT(contours, 20);
  EXPECT_GT(plain, told / 2);
  EXPECT_GE(plain + contours, told - 60);  // but for lines of walls
  EXPECT_EQ(std::fmod(scale.low, 3), 0);
  EXPECT_EQ(viridis(0), (std::array<std::uint8_t, 3>{68, 1, 84}));
  EXPECT_EQ(viridis(1), (std::array<std::uint8_t, 3>{253, 231, 37}));
}

// Lightness grows with the value, as those see it who lack any one kind of cone.
// Source: IEC 61966-2-1 (luma from linear light).
TEST(Palette, ViridisGrowsLighter) {
  double last = -1;
  for (int i = 0; i < 256; ++i) {
    const auto code = viridis(i / 255.0);
    const auto linear = [](int c) { return std::pow(c / 255.0, 2.2); };
    const double luma =
        0.2126 * linear(code[0]) + 0.7152 * linear(code[1]) + 0.0722 * linear(code[2]);
    EXPECT_GT(luma, last - 1e-3);
    last = std::max(last, luma);
  }
}

}  // namespace
}  // namespace tia
