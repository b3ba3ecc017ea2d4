// Excerpts: what answers repeat of an input is short, and says what it leaves out.
#include <gtest/gtest.h>

#include "core/input/codec.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

std::size_t json_bytes(const std::string& text) { return to_json(Value(text)).size() - 2; }

TEST(Excerpt, OfAShortTextIsTheText) {
  for (const char* text : {"", "a", "\"", "\n", "trời"}) EXPECT_EQ(excerpt_of(text, 64), text);
  EXPECT_EQ(excerpt_of(std::string(64, 'x'), 64), std::string(64, 'x'));
}

TEST(Excerpt, OfALongTextSaysHowManyBytesAreLeftOut) {
  EXPECT_EQ(excerpt_of(std::string(4000, 'x'), 64), std::string(43, 'x') + "… (3957 bytes more)");
  // What takes six bytes in JSON fills the excerpt with a sixth.
  EXPECT_EQ(excerpt_of(std::string(100, '\1'), 64), std::string(7, '\1') + "… (93 bytes more)");
}

TEST(Excerpt, IsNeverCutWithinACharacter) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "ờ";
  for (std::size_t most = 64; most < 80; ++most) {
    const std::string cut = excerpt_of(text, most);
    EXPECT_EQ(cut.find("\xEF\xBF\xBD"), cut.npos);
    EXPECT_EQ(to_json(Value(cut)), '"' + cut + '"');  // well-formed: nothing is replaced
  }
}

TEST(Excerpt, IsShortInJsonAndItsOwnExcerpt) {
  const std::string pieces[] = {"x", "\"", "\\", "\1", "\n", "é", "ờ", "😀", "\xFF", "~", "/"};
  test::Random random(7);
  for (int round = 0; round < 500; ++round) {
    std::string text;
    for (int i = random.below(300); i >= 0; --i)
      text += pieces[static_cast<std::size_t>(random.below(11))];
    for (const std::size_t most : {64U, 120U, 256U}) {
      const std::string cut = excerpt_of(text, most);
      EXPECT_LE(json_bytes(cut), most);
      EXPECT_EQ(excerpt_of(cut, most), cut);
      if (json_bytes(text) <= most) {
        EXPECT_EQ(cut, text);
      }
    }
  }
}

TEST(Excerpt, OfAListOrAnObjectSaysHowMuchThereIs) {
  const Value list = Value::Array(1'000'000, Value(7));
  const Value of_list = excerpt(list);
  EXPECT_TRUE(of_list.as<std::string>()->ends_with("… (an array of 1000000)"));
  Value::Object members;
  for (int i = 0; i < 500; ++i) members.emplace_back(std::to_string(i), i);
  EXPECT_TRUE(excerpt(members).as<std::string>()->ends_with("… (an object of 500)"));
  EXPECT_EQ(excerpt(Value::Array{1, "a"}), Value(Value::Array{1, "a"}));
  for (const Value& each : {list, Value(members)})
    EXPECT_LE(excerpt(each).as<std::string>()->size(), 120U);
}

// ---- faults ---------------------------------------------------------------------------------

TEST(Fault, PointersHaveExcerptsOfLongNames) {
  const Place root;
  const std::string name(5000, 'n');
  EXPECT_EQ(root.at(name).pointer(), "/" + std::string(235, 'n') + "… (4765 bytes more)");
  const Place scene = root.at("scene"), long_one = scene.at(name);
  EXPECT_TRUE(long_one.at("radius").pointer().ends_with("… (4765 bytes more)/radius"));
}

TEST(Fault, IsShortHoweverItIsThrown) {
  const std::string text(1'000'000, '\1');
  const Fault fault{FaultKind::unknown_name, "/" + text, Value(text), text, text};
  Faults collected;
  collected.add(fault);
  for (const Fault& each : {collected.list().at(0), InputError(fault).faults().at(0)}) {
    EXPECT_LE(json_bytes(each.pointer), 512U);
    EXPECT_LE(json_bytes(*each.got->as<std::string>()), 120U);
    EXPECT_LE(json_bytes(each.allowed), 1024U);
    EXPECT_LE(json_bytes(each.nearest), 256U);
  }
}

TEST(Fault, AShortenedPointerIsAPointer) {
  for (std::size_t i = 0; i < 3; ++i) {  // ~ without 0 or 1 is none
    std::string pointer = "/" + std::string(i, 'a');
    for (int k = 0; k < 400; ++k) pointer += "~0";
    const InputError error(Fault{FaultKind::malformed, pointer, {}, "x"});
    const std::string& cut = error.faults()[0].pointer;
    ASSERT_NE(cut.find("… ("), cut.npos);
    EXPECT_EQ(cut.find("~…"), cut.npos);
  }
}

TEST(Fault, WhatCannotBeParsedIsNotRepeated) {
  const std::string texts[] = {
      "[1" + std::string(60'000, '0') + "]", std::string(100'000, 'x'),
      "[\"" + std::string(100'000, 'x'),
      "{\"" + std::string(100'000, 'k') + "\":1,\"" + std::string(100'000, 'k') + "\":2}"};
  for (const std::string& text : texts) {
    const auto faults = test::faults_of([&] { parse_json(text); });
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_LE(faults[0].allowed.size(), 260U);
    EXPECT_LT(describe(faults[0]).size(), 1000U);
  }
}

// ---- names ----------------------------------------------------------------------------------

TEST(Names, HaveAtMost256Bytes) {
  const std::string longest(256, 'n'), longer(257, 'n');
  const auto scene = [](const std::string& name) {
    return R"({"materials":{")" + name + R"(":{}},"keys":{")" + name +
           R"(":{"title":"x"}},"objects":[{"type":"sphere","radius":1,"center":[0,0,0],"name":")" +
           name + "\"}]}";
  };
  EXPECT_NO_THROW(read_scene(scene(longest)));
  const auto faults = test::faults_of([&] { read_scene(scene(longer)); });
  const std::string cut = excerpt_of(longer, 256);
  test::expect_faults(faults, {{FaultKind::out_of_range, "/materials/" + cut,
                                to_json(excerpt(longer)), "a string of at most 256 bytes"},
                               {FaultKind::out_of_range, "/objects/0/name",
                                to_json(excerpt(longer)), "a string of at most 256 bytes"},
                               {FaultKind::out_of_range, "/keys/" + cut, to_json(excerpt(longer)),
                                "a string of at most 256 bytes"}});
}

}  // namespace
}  // namespace tia
