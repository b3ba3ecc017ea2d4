// What questions of radio are refused with, and what they are told beside the answer.
#include <gtest/gtest.h>

#include "tests/core/faults.h"
#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::link;
using test::radio_scene;

// The only fault of a question.
Fault fault_of(const Scene& scene, const RadioQuestion& question, const RadioLimits& limits = {}) {
  const auto faults = test::faults_of([&] { radio_paths(scene, question, limits); });
  EXPECT_EQ(faults.size(), 1U);
  return faults.empty() ? Fault{} : faults[0];
}

TEST(RadioFaults, AntennasAreInTheAir) {
  const Scene scene = read_scene(R"({"objects":[
    {"name":"crate","type":"box","min":[0,0,0],"max":[1,1,1]},
    {"name":"egg","type":"sphere","center":[5,0,0],"radius":1},
    {"name":"street","type":"plane","point":[0,-2,0],"normal":[0,1,0]}]})");
  const auto refused = [&](const Vec3d& from, const Vec3d& to) {
    return fault_of(scene, link(from, to, RadioMethod::hybrid));
  };
  const Fault inside = refused({0.3, 0.4, 0.5}, {3, 3, 3});
  EXPECT_EQ(inside.pointer, "/transmitters/0/position");
  EXPECT_NE(inside.allowed.find("crate"), std::string::npos);
  const Fault on = refused({-3, 3, 3}, {1, 0.5, 0.5});
  EXPECT_EQ(on.pointer, "/receivers/0/position");
  EXPECT_NE(on.allowed.find("crate"), std::string::npos);
  EXPECT_NE(refused({5.1, 0.2, 0.1}, {3, 3, 3}).allowed.find("egg"), std::string::npos);
  EXPECT_NE(refused({3, -5, 0}, {3, 3, 3}).allowed.find("street"), std::string::npos);
}

TEST(RadioFaults, ImagesNeedFlatFacesAndSaysWhichAreNot) {
  const Scene scene = read_scene(R"({"objects":[
    {"name":"crate","type":"box","min":[0,0,0],"max":[1,1,1]},
    {"name":"egg","type":"sphere","center":[5,0,0],"radius":1}]})");
  const Fault fault = fault_of(scene, link({9, 9, 9}, {3, 3, 3}, RadioMethod::image));
  EXPECT_EQ(fault.pointer, "/method");
  EXPECT_NE(fault.allowed.find("egg"), std::string::npos);
  EXPECT_EQ(fault.allowed.find("crate"), std::string::npos);
  EXPECT_NE(fault.allowed.find("hybrid"), std::string::npos);
}

TEST(RadioFaults, BudgetsAreNamed) {
  const Scene room = radio_scene(test::room_text({}, {4, 4, 4}));
  RadioQuestion question = link({1, 1, 1}, {2, 3, 3}, RadioMethod::image);
  question.max_reflections = 10;
  const Fault images = fault_of(room, question, {.max_images = 1000});
  EXPECT_EQ(images.kind, FaultKind::limit);
  EXPECT_EQ(images.pointer, "/max_reflections");
  EXPECT_NE(images.allowed.find("1000 images"), std::string::npos);
  question.method = RadioMethod::hybrid;
  const Fault rays = fault_of(room, question, {.max_rays = 1000});
  EXPECT_EQ(rays.pointer, "/rays");
}

TEST(RadioFaults, MaterialsAreReadWithTheirNearestName) {
  const auto faults = [](const std::string& radio) {
    return test::faults_of([&] { read_scene(R"({"materials":{"m":{"radio":)" + radio + "}}}"); });
  };
  const auto name = faults(R"({"type":"itu","name":"concret"})");
  ASSERT_EQ(name.size(), 1U);
  EXPECT_EQ(name[0].pointer, "/materials/m/radio/name");
  EXPECT_EQ(name[0].nearest, "concrete");
  EXPECT_EQ(faults(R"({"type":"itu","name":"brick","thickness":0})").at(0).pointer,
            "/materials/m/radio/thickness");
  EXPECT_EQ(faults(R"({"type":"dielectric"})").at(0).pointer,
            "/materials/m/radio/relative_permittivity");
  EXPECT_EQ(faults(R"({"type":"conductor","thickness":1})").size(), 1U);
}

TEST(RadioFaults, QuestionsAreReadAsTheyAreDescribed) {
  const auto faults = [](const std::string& text) {
    return test::faults_of([&] { read_described<RadioQuestion>(parse_json(text)); });
  };
  const std::string ends = R"("transmitters":[{"position":[0,0,0]}],
                              "receivers":[{"position":[1,0,0]}])";
  EXPECT_TRUE(faults("{" + ends + R"(,"frequency_hz":1e6})").empty());
  EXPECT_TRUE(faults("{" + ends + R"(,"frequency_hz":3e11,"max_reflections":10})").empty());
  for (const char* more : {R"("frequency_hz":9e5)", R"("frequency_hz":3.1e11)"})
    EXPECT_EQ(faults("{" + ends + "," + more + "}").at(0).pointer, "/frequency_hz");
  EXPECT_EQ(faults("{" + ends + R"(,"frequency_hz":1e9,"max_reflections":11})").at(0).pointer,
            "/max_reflections");
  EXPECT_EQ(faults(R"({"receivers":[{"position":[1,0,0]}],"frequency_hz":1e9})").at(0).pointer,
            "/transmitters");
  EXPECT_EQ(faults(R"({"transmitters":[],"receivers":[{"position":[1,0,0]}],"frequency_hz":1e9})")
                .at(0)
                .pointer,
            "/transmitters");
}

TEST(RadioFaults, WhatIsAssumedIsTold) {
  const Scene scene = read_scene(R"({"materials":{"plank":{"radio":{"type":"itu",
      "name":"floorboard"}}},"objects":[
    {"name":"crate","type":"box","min":[0,0,0],"max":[1,1,1]},
    {"name":"board","type":"triangle","a":[3,0,0],"b":[4,0,0],"c":[3,1,0],"material":"plank"},
    {"name":"hole","type":"box","min":[8,0,0],"max":[9,1,1],
     "material":{"radio":{"type":"air"}}}]})");
  RadioQuestion question = link({8.5, 0.5, 0.5}, {20, 0.5, 0.5}, RadioMethod::image);
  question.max_reflections = 0;
  const auto answer = radio_paths(scene, question);
  ASSERT_EQ(answer.assumed.size(), 2U);
  EXPECT_NE(answer.assumed[0].find("crate"), std::string::npos);
  EXPECT_EQ(answer.assumed[0].find("board"), std::string::npos);
  EXPECT_NE(answer.assumed[1].find("board"), std::string::npos);
  ASSERT_EQ(answer.warnings.size(), 1U);
  EXPECT_NE(answer.warnings[0].find("floorboard was measured from 50 to 100 GHz"),
            std::string::npos);
  EXPECT_EQ(answer.pairs[0].paths.size(), 1U);  // air is not there
}

TEST(RadioFaults, RadioIsCanonicalAndLeftOutWhereThereIsNone) {
  const Scene scene = read_scene(
      R"({"materials":{"m":{"radio":{"type":"itu","name":"glass","thickness":0.006}},"n":{}}})");
  EXPECT_EQ(
      canonical_text(scene),
      R"({"materials":{"m":{"radio":{"name":"glass","thickness":0.006,"type":"itu"}},"n":{}}})");
}

}  // namespace
}  // namespace tia
