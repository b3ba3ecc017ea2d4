// What the pictures of a model's material are multiplied into.
#include <gtest/gtest.h>

#include "core/materials/principled.h"
#include "tests/core/materials/texture_maps.h"

namespace tia {
namespace {

using namespace test;
using MapNumbers = PrincipledNumbers;

constexpr std::array<std::uint8_t, 4> map_code{51, 102, 153, 204};

MapUse map_use(Vec3d MapNumbers::*color, std::vector<MapUse::Channel> channels) {
  return {texture_map(even_rgba(2, 2, map_code)), color, std::move(channels)};
}
PrincipledNumbers map_numbers(const Principled& principled, const TexturePoint& at) {
  TextureReader reader(at);
  return numbers_at(prepare(principled), reader);
}
Vec3d normal_in(const PrincipledMaps& maps, const TexturePoint& at) {
  TextureReader reader(at);
  return mapped_normal(*maps.normal, reader);
}
std::shared_ptr<const PrincipledMaps> shared_maps(PrincipledMaps maps) {
  return std::make_shared<const PrincipledMaps>(std::move(maps));
}

TEST(PrincipledMaps, ChannelsMultiplyNumbersAndColoursColours) {
  Principled p;
  p.roughness = 0.5, p.metallic = 0.75;
  p.maps = shared_maps(
      {{map_use(nullptr, {{&MapNumbers::roughness, 1}, {&MapNumbers::metallic, 2}}),
        map_use(&MapNumbers::base, {{&MapNumbers::alpha, 3}}), map_use(&MapNumbers::emissive, {})},
       {},
       false});
  TexturePoint at = texture_point(0.5, 0.5);
  at.color = {0.1, 0.2, 0.3, 0.5};
  const PrincipledNumbers numbers = map_numbers(p, at);
  EXPECT_NEAR(numbers.roughness, 0.5 * 0.4, 1e-12);
  EXPECT_NEAR(numbers.metallic, 0.75 * 0.6, 1e-12);
  EXPECT_NEAR(numbers.alpha, 0.8 * 0.5, 1e-12);
  for (const Vec3d& color : {numbers.base, numbers.emissive})
    EXPECT_LE(length(color - Vec3d{0.2, 0.4, 0.6}), 1e-12);
  EXPECT_EQ(map_alpha(*p.maps, at), numbers.alpha);
  EXPECT_TRUE(emission_varies(*p.maps));
  EXPECT_TRUE(wants_uv(prepare(p)));
}

// glTF 3.9.3: 1 + strength (sample - 1).
TEST(PrincipledMaps, OcclusionTakesByItsStrength) {
  Principled p;
  PrincipledMaps maps{{map_use(nullptr, {{&MapNumbers::occlusion, 0}})}, {}, false};
  maps.uses[0].map.strength = 0.25;
  p.maps = shared_maps(maps);
  EXPECT_NEAR(map_numbers(p, texture_point(0, 0)).occlusion, 1 + 0.25 * (0.2 - 1), 1e-12);
  EXPECT_FALSE(emission_varies(maps));
}

TEST(PrincipledMaps, WhatIsUnlitShinesWithItsMeshsColour) {
  Principled p;
  p.emissive = {1, 0.5, 1};
  p.maps = shared_maps({{}, {}, true});
  TexturePoint at = texture_point(0, 0);
  at.color = {0.25, 0.5, 0.75, 1};
  const PrincipledForm form = prepare(p);
  const ShadingParameters shading = shading_at(form, map_numbers(p, at));
  EXPECT_LE(length(shading.emission.exact - Vec3d{0.25, 0.25, 0.75}), 1e-12);
  EXPECT_TRUE(emission_varies(*p.maps));
}

// KHR_materials_specular: f0 = min(f0 of ior times colour, 1) times specular.
TEST(PrincipledMaps, ShadingHasTheProducts) {
  Principled p;
  p.base_color = Color{0.5, 0.5, 0.5};
  p.ior = 2, p.specular = 0.5, p.specular_color = {12, 1, 1}, p.sheen_color = {1, 1, 0.5};
  PrincipledForm form = prepare(p);
  form.rest.ambient = Vec3d{1, 1, 1};
  PrincipledNumbers at = form.numbers;
  at.base = {0.1, 0.2, 0.3}, at.specular_color = {0.5, 0.5, 1}, at.sheen_color = {0.3, 0.2, 0.1};
  at.occlusion = 0.5;
  const ShadingParameters shading = shading_at(form, at);
  EXPECT_LE(length(shading.albedo.exact - Vec3d{0.05, 0.1, 0.15}), 1e-12);
  EXPECT_LE(length(shading.ambient.exact - Vec3d{0.025, 0.05, 0.075}), 1e-12);
  EXPECT_LE(length(shading.bsdf.base - Vec3d{0.05, 0.1, 0.15}), 1e-12);
  EXPECT_LE(length(shading.bsdf.tint - Vec3d{0.05, 0.1, 0.15}), 1e-12);
  EXPECT_LE(length(shading.bsdf.sheen - Vec3d{0.3, 0.2, 0.05}), 1e-12);
  const Vec3d f0{0.5 * std::min(12 * 0.5 / 9, 1.0), 0.5 * 0.5 / 9, 0.5 / 9};
  EXPECT_LE(length(shading.bsdf.f0 - f0), 1e-12);
}

TEST(PrincipledMaps, NormalIsTheTexelsScaledInItsPlane) {
  PrincipledMaps maps;
  maps.normal = texture_map(even_rgba(1, 1, {204, 102, 255, 255}));
  maps.normal->strength = 0.5;
  const Vec3d n{0.5 * (2 * 0.8 - 1), 0.5 * (2 * 0.4 - 1), 1};
  EXPECT_LE(length(normal_in(maps, texture_point(0, 0)) - normalize(n)), 1e-12);
  maps.normal = texture_map(ImageRgba8{2, 1, {0, 0, 0, 0, 255, 255, 255, 0}});
  maps.normal->strength = 1;
  maps.normal->wrap_u = Wrap::clamp_to_edge;
  EXPECT_EQ(normal_in(maps, texture_point(0.5, 0)), (Vec3d{0, 0, 1})) << "none, of no length";
}

// Changed one by one: the picture, its size, wraps, filter, set of uvs and place.
TextureMap other_map(const TextureMap& before, const std::vector<TextureMap>& pictures,
                     Random& random) {
  TextureMap map = before;
  map.pyramid = pictures[static_cast<std::size_t>(random.below(4))].pyramid;
  switch (random.below(9)) {
    case 0: map.wrap_u = Wrap::mirrored_repeat; break;
    case 1: map.wrap_v = Wrap::clamp_to_edge; break;
    case 2: map.nearest = !map.nearest; break;
    case 3: map.uv_set = 1 - map.uv_set; break;
    case 4: map.transform({0.1, 0.2}, {1, 1}, 0); break;
    case 5: map.transform({0, 0}, {2, 1}, 0.3); break;
    default: break;
  }
  return map;
}

TEST(TextureReader, GivesEachMapWhatItHasAlone) {
  Random random(517);
  std::vector<TextureMap> pictures;
  for (const auto& [w, h] : {std::pair{8, 4}, {8, 4}, {5, 4}, {8, 6}})
    pictures.push_back(texture_map(random_rgba(random, w, h)));
  for (int i = 0; i < 2000; ++i) {
    TexturePoint at = texture_point(random.in(-2, 2), random.in(-2, 2), random.in(0, 0.5));
    at.uv[1] = {random.in(-2, 2), random.in(-2, 2)}, at.footprint[1] = random.in(0, 0.5);
    std::vector<TextureMap> maps{pictures[0]};
    while (maps.size() < 6) maps.push_back(other_map(maps.back(), pictures, random));
    TextureReader reader(at);
    for (const TextureMap& map : maps) EXPECT_EQ(reader.rgba_of(map), rgba_at(map, at));
  }
}

}  // namespace
}  // namespace tia
