#include "core/input/errors.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tia {
namespace {

using enum FaultKind;

TEST(Place, PointersAreRfc6901s) {
  const Place root;
  EXPECT_EQ(root.pointer(), "");
  const Place objects = root.at("objects"), third = objects.at(std::size_t{3});
  EXPECT_EQ(objects.pointer(), "/objects");
  EXPECT_EQ(third.pointer(), "/objects/3");
  EXPECT_EQ(third.at("radius").pointer(), "/objects/3/radius");
  // The table of RFC 6901, section 5.
  EXPECT_EQ(root.at("").pointer(), "/");
  EXPECT_EQ(root.at("a/b").pointer(), "/a~1b");
  EXPECT_EQ(root.at("m~n").pointer(), "/m~0n");
  EXPECT_EQ(root.at("~1").pointer(), "/~01");
  EXPECT_EQ(root.at("k\"l").pointer(), "/k\"l");
  EXPECT_EQ(root.at(" ").pointer(), "/ ");
}

TEST(Faults, KeepTheFirstTwenty) {
  Faults faults;
  EXPECT_TRUE(faults.empty());
  EXPECT_NO_THROW(faults.raise());
  for (int i = 0; i < 30; ++i)
    faults.add({wrong_type, std::string("/").append(std::to_string(i)), Value(i), "other"});
  ASSERT_EQ(faults.list().size(), 20U);
  EXPECT_EQ(faults.list().back().pointer, "/19");
  EXPECT_THROW(faults.raise(), InputError);
}

TEST(Faults, DescriptionSaysWhereWhatCameAndWhatIsAllowed) {
  EXPECT_EQ(describe({out_of_range, "/objects/3/radius", Value(-1), "a number above 0"}),
            "/objects/3/radius: got -1, allowed: a number above 0");
  EXPECT_EQ(describe({missing, "/objects/0/center", std::nullopt, "the centre"}),
            "/objects/0/center: missing, allowed: the centre");
  EXPECT_EQ(describe({unknown_name, "/key", Value("q"), "one of a, d, s, w", "a"}),
            "/key: got \"q\", allowed: one of a, d, s, w (did you mean \"a\"?)");
  EXPECT_EQ(describe({malformed, "", std::nullopt, "JSON text"}), "allowed: JSON text");
}

TEST(Faults, ErrorsWordsAreALineAFault) {
  const InputError error({{missing, "/a", std::nullopt, "x"}, {wrong_type, "/b", Value(1), "y"}});
  EXPECT_STREQ(error.what(), "/a: missing, allowed: x\n/b: got 1, allowed: y");
}

TEST(NearestName, IsTheOneWithFewestEdits) {
  const std::vector<std::string_view> known{"center", "radius", "material", "name"};
  EXPECT_EQ(nearest_name("centre", known), "center");
  EXPECT_EQ(nearest_name("Radius", known), "radius");
  EXPECT_EQ(nearest_name("radiuss", known), "radius");
  EXPECT_EQ(nearest_name("adius", known), "radius");
  EXPECT_EQ(nearest_name("mame", known), "name");
  EXPECT_EQ(nearest_name("name", known), "name");
}

TEST(NearestName, ASwapOfNeighboursIsOneEdit) {
  EXPECT_EQ(nearest_name("widht", {"light", "width"}), "width");
  EXPECT_EQ(nearest_name("hieght", {"light", "height"}), "height");
  EXPECT_EQ(nearest_name("raduis", {"radii", "radius"}), "radius");
}

TEST(NearestName, IsNothingWhereNoneIsNear) {
  const std::vector<std::string_view> known{"center", "radius"};
  EXPECT_EQ(nearest_name("quaternion", known), "");
  EXPECT_EQ(nearest_name("", known), "");
  EXPECT_EQ(nearest_name("radius", {}), "");
  EXPECT_EQ(nearest_name(std::string(65, 'r'), known), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'r'), known), "");
}

TEST(NearestName, AnotherLetterIsNotNear) {
  EXPECT_EQ(nearest_name("x", {"a", "d", "s", "w"}), "");
}

TEST(NearestName, AtEqualDistanceIsTheFirstKnown) {
  EXPECT_EQ(nearest_name("bar", {"baz", "car"}), "baz");
}

TEST(Listed, NamesStandWithCommas) {
  EXPECT_EQ(listed({"a", "d", "s"}), "a, d, s");
  EXPECT_EQ(listed({}), "");
}

TEST(Listed, OfManyNamesTheFirstFortyOfALongOneTheStart) {
  std::vector<std::string_view> many(40, "n");
  const std::string forty = listed(many);
  EXPECT_EQ(std::count(forty.begin(), forty.end(), 'n'), 40);
  many.resize(45, "n");
  EXPECT_EQ(listed(many), forty + " and 5 more");
  const std::string name(100, 'n');
  EXPECT_EQ(listed({name}), std::string(44, 'n') + "… (56 bytes more)");
}

TEST(Listed, OfLongNamesSome420Bytes) {
  const std::string name(64, 'n');
  const std::string all = listed(std::vector<std::string_view>(30, name));
  EXPECT_LT(all.size(), 500U);
  EXPECT_TRUE(all.ends_with("n and 23 more")) << all;
}

}  // namespace
}  // namespace tia
