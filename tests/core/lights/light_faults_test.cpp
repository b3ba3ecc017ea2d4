// Lights as JSON: each kind read and written back, each mistake at its place, the schema against
// the reader.
#include "core/lights/light.h"

#include <gtest/gtest.h>

#include "core/film/hdr.h"
#include "core/film/png.h"
#include "core/scene/read_scene.h"
#include "tests/core/faults.h"
#include "tests/core/film/files.h"
#include "tests/core/schema/corpus.h"

namespace tia {
namespace {

using enum FaultKind;
using test::expect_faults;

Light read_light(const std::string& json) { return read_described<Light>(parse_json(json)); }
const auto expect_light_refused =
    test::refusal_by([](const std::string& json) { read_light(json); });
// Of that kind, and more members.
std::string point_json(const std::string& more) {
  return R"({"type":"point","position":[0,1,2],)" + more + "}";
}
std::string sun_json(const std::string& more) { return R"({"type":"directional",)" + more + "}"; }
std::string spot_json(const std::string& more) {
  return R"({"type":"spot","position":[0,5,0],)" + more + "}";
}
std::string globe_json(const std::string& more) {
  return R"({"type":"sphere","position":[0,5,0],)" + more + "}";
}
std::string quad_json(const std::string& more) {
  return R"({"type":"quad","corner":[0,5,0],)" + more + "}";
}

TEST(LightFaults, EveryKindIsReadAndWrittenBack) {
  for (
      const char* json :
      {R"({"position":[0,1,2],"type":"point"})",
       R"({"color":[1,0.5,0],"fade_distance":5,"fade_power":3,"intensity":2,"position":[0,1,2],)"
       R"("type":"point"})",
       R"({"direction":[0,-2,1],"type":"directional"})",
       R"({"falloff_degrees":180,"point_at":[1,2,3],"position":[0,1,2],"radius_degrees":0,)"
       R"("tightness":1000,"type":"spot"})",
       R"({"position":[0,1,2],"radius":3,"samples":4096,"type":"sphere"})",
       R"({"corner":[0,1,2],"samples":16,"type":"quad","u":[1,0,0],"v":[1,1,0]})",
       R"({"color":[0.1,0.2,0.3],"type":"sky"})",
       R"({"azimuth_degrees":-90,"elevation_degrees":3,"ground":0,"samples":4,"turbidity":6,)"
       R"("type":"sun"})",
       R"({"date":"2026-06-21","latitude_degrees":48,"longitude_degrees":11,"time":"09:05:07",)"
       R"("type":"sun","utc_offset_hours":2})",
       R"({"data":"iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAAAAADRSSBWAAAAC0lEQVR42mP4/x8AAwAB/2+Bq7YAAAAA)"
       R"(SUVORK5CYII=","rotate_degrees":30,"type":"sky_image"})"})
    EXPECT_EQ(to_json(write_value(read_light(json))), json);
}

TEST(LightFaults, UnknownKindsAndWordsNameTheNearest) {
  const char* const kinds = "one of point, directional, spot, sphere, quad, sky, sun, sky_image";
  expect_light_refused("{}", {{missing, "/type", "", kinds}});
  expect_light_refused(R"({"type":5})", {{wrong_type, "/type", "5", kinds}});
  expect_light_refused(R"({"type":"directionl"})",
                       {{unknown_name, "/type", "\"directionl\"", kinds, "directional"}});
  expect_light_refused(R"({"type":"quat"})", {{unknown_name, "/type", "\"quat\"", kinds, "quad"}});
  expect_light_refused(R"({"type":"hemisphere"})",
                       {{unknown_name, "/type", "\"hemisphere\"", kinds, "sphere"}});
  expect_light_refused(R"({"type":"area"})", {{unknown_name, "/type", "\"area\"", kinds, ""}});
  expect_light_refused(
      point_json(R"("fade_distanze":3)"),
      {{unknown_name, "/fade_distanze", "\"fade_distanze\"", "fade_power", "fade_distance"}});
  expect_light_refused(
      spot_json(R"("fallof_degrees":50)"),
      {{unknown_name, "/fallof_degrees", "\"fallof_degrees\"", "tightness", "falloff_degrees"}});
  expect_light_refused(R"({"type":"sky","position":[0,0,0]})",
                       {{unknown_name, "/position", "\"position\"", "color, intensity", ""}});
  expect_light_refused(point_json(R"("samples":4)"),
                       {{unknown_name, "/samples", "\"samples\"", "position, color", ""}});
}

TEST(LightFaults, WhatAllKindsShareHasItsRange) {
  expect_light_refused(point_json(R"("color":[0,-1,0])"),
                       {{out_of_range, "/color/1", "-1", "from 0 to 1000000"}});
  expect_light_refused(point_json(R"("color":"red")"),
                       {{wrong_type, "/color", "\"red\"", "3 numbers"}});
  expect_light_refused(point_json(R"("intensity":-0.5)"),
                       {{out_of_range, "/intensity", "-0.5", "from 0 to 1000000"}});
  expect_light_refused(point_json(R"("intensity":1000001)"),
                       {{out_of_range, "/intensity", "1000001", "from 0 to 1000000"}});
  for (const char* distance : {"0", "-1", "1000000001"})
    expect_light_refused(
        point_json(std::string(R"("fade_distance":)") + distance),
        {{out_of_range, "/fade_distance", distance, "above 0, at most 1000000000"}});
  for (const char* power : {"-1", "101"})
    expect_light_refused(point_json(std::string(R"("fade_power":)") + power),
                         {{out_of_range, "/fade_power", power, "from 0 to 100"}});
  for (const std::string& json : {sun_json(R"("direction":[0,-1,0],"fade_distance":2)"),
                                  std::string(R"({"type":"sky","fade_distance":2})")})
    expect_light_refused(json, {{conflict, "/fade_distance", "2", "at some distance"}});
}

TEST(LightFaults, DirectionHasSomeLength) {
  expect_light_refused(sun_json(R"("direction":[0,0,0])"),
                       {{out_of_range, "/direction", "[0,0,0]", "a direction of some length"}});
  expect_light_refused(sun_json(R"("direction":[-0.0,0,0])"),
                       {{out_of_range, "/direction", "[0,0,0]", "a direction of some length"}});
  expect_light_refused(sun_json(R"("direction":[0,1])"),
                       {{wrong_type, "/direction", "[0,1]", "3 numbers"}});
  expect_light_refused(sun_json(R"("direction":[0,2e9,0])"),
                       {{out_of_range, "/direction/1", "2000000000", "from -1000000000"}});
  EXPECT_NO_THROW(read_light(sun_json(R"("direction":[0,-1e-300,0])")));
}

TEST(LightFaults, SpotPointsElsewhereAndFallsOffBeyondItsRadius) {
  expect_light_refused(spot_json(R"("point_at":[0,5,0])"),
                       {{out_of_range, "/point_at", "[0,5,0]", "a point other than position"}});
  expect_light_refused(R"({"type":"spot","position":[0,0,0]})",
                       {{out_of_range, "/point_at", "[0,0,0]", "a point other than position"}});
  expect_light_refused(
      spot_json(R"("radius_degrees":50)"),
      {{out_of_range, "/falloff_degrees", "45", "from radius_degrees, 50, to 180"}});
  expect_light_refused(
      spot_json(R"("falloff_degrees":29.5)"),
      {{out_of_range, "/falloff_degrees", "29.5", "from radius_degrees, 30, to 180"}});
  for (const char* angle : {"-1", "180.5"}) {
    expect_light_refused(spot_json(std::string(R"("falloff_degrees":)") + angle),
                         {{out_of_range, "/falloff_degrees", angle, "from 0 to 180"}});
    expect_light_refused(
        spot_json(std::string(R"("falloff_degrees":180,"radius_degrees":)") + angle),
        {{out_of_range, "/radius_degrees", angle, "from 0 to 180"}});
  }
  for (const char* tightness : {"-1", "1001"})
    expect_light_refused(spot_json(std::string(R"("tightness":)") + tightness),
                         {{out_of_range, "/tightness", tightness, "from 0 to 1000"}});
  EXPECT_NO_THROW(read_light(spot_json(R"("radius_degrees":45)"))) << "equal angles: a hard edge";
}

std::string sun_at(const std::string& fields) { return R"({"type":"sun",)" + fields + "}"; }

TEST(LightFaults, SunStandsByAnglesOrByDateAndPlace) {
  const std::string place = R"("latitude_degrees":48,"longitude_degrees":11)";
  const char* const together = "date, time, latitude_degrees and longitude_degrees together";
  expect_light_refused(sun_at(R"("date":"2026-06-21")"),
                       {{missing, "/time", "", together},
                        {missing, "/latitude_degrees", "", together},
                        {missing, "/longitude_degrees", "", together}});
  const std::string whole = R"("date":"2026-06-21","time":"12:00",)" + place;
  EXPECT_NO_THROW(read_light(sun_at(whole)));
  expect_light_refused(sun_at(whole + R"(,"elevation_degrees":3,"azimuth_degrees":4)"),
                       {{conflict, "/elevation_degrees", "3", "either elevation_degrees and"},
                        {conflict, "/azimuth_degrees", "4", "either elevation_degrees and"}});
  expect_light_refused(sun_at(R"("date":"2026-02-29","time":"12:00",)" + place),
                       {{out_of_range, "/date", "\"2026-02-29\"", "a day that its month has"}});
  for (const char* date : {"2026-6-21", "1899-12-31", "2026-13-01", "2026-01-32", "", "tomorrow"})
    expect_light_refused(
        sun_at(std::string(R"("time":"12:00","date":")") + date + "\"," + place),
        {{wrong_type, "/date", "\"" + std::string(date) + "\"", "a date from \"1900-01-01\""}});
  for (const char* time : {"12", "24:00", "12:60", "12:00:60", "12.00", "1 :00"})
    expect_light_refused(
        sun_at(std::string(R"("date":"2026-06-21","time":")") + time + "\"," + place),
        {{wrong_type, "/time", "\"" + std::string(time) + "\"", "a time from \"00:00\""}});
  expect_light_refused(sun_at(R"("elevation_degrees":91)"),
                       {{out_of_range, "/elevation_degrees", "91", "from -90 to 90"}});
  expect_light_refused(sun_at(R"("turbidity":0.5)"),
                       {{out_of_range, "/turbidity", "0.5", "from 1 to 10"}});
}

std::string image_json(const std::string& file) {
  return R"({"type":"sky_image","data":")" + test::base64(file) + "\"}";
}

TEST(LightFaults, SkyImagesAreTwiceAsWideAsHigh) {
  expect_light_refused(R"({"type":"sky_image"})", {{missing, "/data", "", "all around"}});
  expect_light_refused(R"({"type":"sky_image","data":"####"})",
                       {{wrong_type, "/data", "\"####\"", "not from its character 0 on"}});
  expect_light_refused(image_json("GIF89a"),
                       {{wrong_type, "/data", "\"bytes that begin like neither\"", "picture"}});
  expect_light_refused(image_json(encode_png(Image8(3, 2))),
                       {{wrong_type, "/data", "\"3 x 2 pixels\"", "twice as wide as high"}});
  Image bright(4, 2);
  bright.rgb[5] = 2e9F;
  expect_light_refused(
      image_json(encode_hdr(bright)),
      {{wrong_type, "/data", "\"the texel 1, 0, brighter than 1e9\"", "texels up to 1e9"}});
  const std::string hdr = encode_hdr(Image(16, 8));
  expect_light_refused(image_json(hdr.substr(0, hdr.size() - 1)),
                       {{wrong_type, "/data", "\"bytes that cannot be decoded\"", "HDR"}});
  expect_light_refused(image_json("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2050 +X 4100\n"),
                       {{limit, "/data", "\"4100 x 2050 pixels\"", "at most 8388608 pixels"}});
  expect_light_refused(image_json(std::string((8 << 20) + 1, 'x')),
                       {{limit, "/data", "\"8388609 bytes\"", "at most 8388608 bytes"}});
}

TEST(LightFaults, LuminousBallHasARadius) {
  expect_light_refused(R"({"type":"sphere","position":[0,5,0]})",
                       {{missing, "/radius", "", "the radius"}});
  for (const char* radius : {"0", "-1", "2000000000"})
    expect_light_refused(globe_json(std::string(R"("radius":)") + radius),
                         {{out_of_range, "/radius", radius, "above 0, at most 1000000000"}});
}

TEST(LightFaults, SamplesAreAWholeNumberOfPlaces) {
  for (const std::string& start :
       {std::string(R"({"type":"sphere","position":[0,5,0],"radius":1,"samples":)"),
        std::string(R"({"type":"quad","corner":[0,5,0],"u":[1,0,0],"v":[0,0,1],"samples":)")}) {
    for (const char* samples : {"0", "-1", "4097", "65536"})
      expect_light_refused(start + samples + "}",
                           {{out_of_range, "/samples", samples, "an integer from 1 to 4096"}});
    expect_light_refused(start + "1.5}",
                         {{wrong_type, "/samples", "1.5", "an integer from 1 to 4096"}});
    expect_light_refused(start + "null}", {{wrong_type, "/samples", "null", "an integer"}});
  }
}

TEST(LightFaults, QuadSpansAnArea) {
  expect_light_refused(quad_json(R"("u":[1,0,0])"), {{missing, "/v", "", "the other edge"}});
  expect_light_refused(quad_json(R"("v":[1,0,0])"), {{missing, "/u", "", "one edge"}});
  for (const char* v : {"[0,0,0]", "[1,2,3]", "[-0.5,-1,-1.5]"})
    expect_light_refused(quad_json(std::string(R"("u":[1,2,3],"v":)") + v),
                         {{out_of_range, "/v", v, "an edge that spans an area with u"}});
}

TEST(LightFaults, SeveralComeAtOnceInTheirOrder) {
  expect_light_refused(
      spot_json(R"("radius_degrees":-3,"tightness":"much","intensity":-1,"colour":1)"),
      {{out_of_range, "/radius_degrees", "-3", "from 0 to 180"},
       {wrong_type, "/tightness", "\"much\"", "from 0 to 1000"},
       {out_of_range, "/intensity", "-1", "from 0"},
       {unknown_name, "/colour", "\"colour\"", "color", "color"}});
}

TEST(LightFaults, LightsOfASceneNeedTheirPlaceAndTheKeyLightDoesNot) {
  const auto in_scene = [](const std::string& json) {
    return test::faults_of([&] { read_scene(R"({"lights":[)" + json + "]}"); });
  };
  expect_faults(in_scene(R"({"type":"spot"})"),
                {{missing, "/lights/0/position", "", "where the light is"}});
  expect_faults(in_scene(R"({"type":"quad","u":[1,0,0],"v":[0,1,0]})"),
                {{missing, "/lights/0/corner", "", "where the light is"}});
  expect_faults(in_scene(R"({"type":"directional"})"), {{missing, "/lights/0/direction", "", ""}});
  expect_faults(in_scene(R"({"type":"sky"})"), {});
  for (const char* json : {R"({"type":"spot"})", R"({"type":"directional"})", R"({"type":"sky"})",
                           R"({"type":"quad","u":[1,0,0],"v":[0,1,0]})"})
    EXPECT_NO_THROW(read_scene(std::string(R"({"key_light":)") + json + "}")) << json;
}

TEST(LightFaults, TheSchemaAgreesWithTheReader) {
  const std::vector<std::string> beyond = {"a direction of some length",
                                           "from radius_degrees",
                                           "a point other than position",
                                           "spans an area",
                                           "at some distance",
                                           "longitude_degrees together",
                                           "either elevation_degrees",
                                           "a day that its month has",
                                           "a whole PNG or JPEG picture",
                                           "a whole Radiance HDR picture",
                                           "a picture by latitude"};
  test::expect_agreement<Light>(whole_schema<Light>(), 4000, beyond);
}

TEST(LightFaults, FiveSunsAreOneTooMany) {
  std::string suns;
  for (int i = 0; i < 5; ++i) suns += std::string(i > 0 ? "," : "") + R"({"type":"sun"})";
  test::expect_scene_refused(
      R"({"camera":{"location":[0,0,5],"look_at":[0,0,0]},"lights":[)" + suns + "]}",
      {{FaultKind::limit, "/lights/4", "", "at most 4 suns"}});
}

}  // namespace
}  // namespace tia
