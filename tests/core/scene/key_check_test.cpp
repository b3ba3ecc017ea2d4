// Keys are tried before a scene is kept: each that could not be pressed is a fault.
#include <gtest/gtest.h>

#include "core/film/png.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "tests/core/faults.h"
#include "tests/core/film/files.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using enum FaultKind;

std::vector<Fault> faults_of_keys(const std::string& scene) {
  return test::faults_of([&] { check_keys(read_scene(scene)); });
}

TEST(KeyCheck, EveryKeyThatCanBePressedIsRight) {
  EXPECT_NO_THROW(check_keys(Scene{}));
  EXPECT_NO_THROW(check_keys(test::thesis_scene()));
  EXPECT_NO_THROW(check_keys(read_scene(R"({
    "materials":{"m":{},"unused":{}},
    "objects":[{"type":"sphere","radius":1,"center":[0,0,0],"material":"m"}],
    "keys":{"a":{"light":[1,2,3]}, "n":{"title":"x","background":null},
            "o":{"objects":[{"type":"sphere","radius":2,"center":[0,0,0],"material":"m"}]},
            "p":{"materials":{"m":{"diffuse":0.5},"unused":null}},
            "c":{"camera":{"fov_degrees":60}}, "k":{"keys":{"a":{"light":[3,2,1]}}},
            "q":{"objects":null,"materials":null}}})")));
}

TEST(KeyCheck, APatchThatLeavesNoSceneIsAFaultOfItsKey) {
  test::expect_faults(faults_of_keys(R"({"keys":{"b":{"background":-1},"g":{"title":"good"},
                                "l":{"light":[0,0,0],"title":"x"},"t":{"title":5}}})"),
                      {{conflict, "/keys/b", "", "/background"},
                       {conflict, "/keys/l", "", "/light"},
                       {conflict, "/keys/t", "", "/title"}});
}

// What one part says of another is checked, though only the parts that a patch changes are read.
TEST(KeyCheck, APatchMayNotTakeWhatOthersReferTo) {
  const std::string scene =
      R"({"materials":{"m":{}},"objects":[{"type":"sphere","radius":1,"center":[0,0,0],)"
      R"("material":"m"}],"keys":{"k":)";
  test::expect_faults(faults_of_keys(scene + R"({"materials":{"m":null}}}})"),
                      {{conflict, "/keys/k", "", "/objects/0/material"}});
  test::expect_faults(faults_of_keys(scene + R"({"materials":null}}})"),
                      {{conflict, "/keys/k", "", "/objects/0/material"}});
  test::expect_faults(
      faults_of_keys(scene + R"({"objects":[{"type":"sphere","radius":1,"center":[0,0,0],)"
                             R"("material":"n"}]}}})"),
      {{conflict, "/keys/k", "", "/objects/0/material"}});
}

TEST(KeyCheck, ALightMustBeAbleToShineFromWhereAKeyPutsIt) {
  const std::string scene = R"({"camera":{"look_at":[0,0,-5]},"lights":[{"type":"spot",)"
                            R"("position":[0,5,0],"point_at":[0,0,-5]}],)";
  EXPECT_EQ(faults_of_keys(scene + R"("keys":{"a":{"light":[0,5,0]}}})").size(), 0U);
  const auto faults = faults_of_keys(scene + R"("keys":{"a":{"light":[0,0,-5]}}})");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/keys/a");
  // As when it is pressed.
  const Scene pressed = read_scene(scene + R"("keys":{"a":{"light":[0,0,-5]}}})");
  EXPECT_THROW(press(pressed, "a"), InputError);
}

TEST(KeyCheck, WhatTakesTooLongToTryIsRefused) {
  std::string many = R"({"keys":{)";
  for (int i = 0; i < 101; ++i)
    many += (i > 0 ? ",\"" : "\"") + std::to_string(i) + R"(":{"title":"x"})";
  test::expect_faults(faults_of_keys(many + "}}"), {{limit, "/keys", "", "at most 100 patches"}});

  // Each patch merges with materials, which the objects wear: a megabyte of text.
  std::string big = R"({"materials":{"m":{}},"objects":[{"type":"mesh","material":"m",)"
                    R"("positions":[0,0,0,1,0,0,0,1,0],"indices":[)";
  for (int i = 0; i < 170'000; ++i) big += i > 0 ? ",0,1,2" : "0,1,2";
  big += R"(]}],"keys":{)";
  for (int i = 0; i < 50; ++i)
    big += (i > 0 ? ",\"" : "\"") + std::to_string(i) + R"(":{"materials":{"m":{"diffuse":0.5}}})";
  test::expect_faults(faults_of_keys(big + "}}"), {{limit, "/keys", "", "16777216 bytes"}});
}

// Each patch of materials reads their pictures again: few bytes, millions of pixels.
TEST(KeyCheck, CountsThePixelsThatAllPatchesRead) {
  const auto wearing = [](int size) {
    return R"({"m":{"texture":{"type":"image","data":")" +
           test::base64(encode_png(Image8(size, size))) + "\"}}}";
  };
  std::string scene = R"({"materials":)" + wearing(2048) + R"(,"objects":[],"keys":{)";
  for (int i = 0; i < 32; ++i)
    scene +=
        (i > 0 ? ",\"" : "\"") + std::to_string(i) + R"(":{"materials":{"m":{"diffuse":0.5}}})";
  test::expect_faults(faults_of_keys(scene + "}}"), {});  // 2^27 pixels
  const std::string one_more = R"(,"one":{"materials":)" + wearing(1) + "}}}";
  test::expect_faults(faults_of_keys(scene + one_more), {{limit, "/keys", "", "134217728 pixels"}});
}

TEST(KeyCheck, EndsWhenThatIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(check_keys(test::thesis_scene(), source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
