#include "core/input/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/input/nearest_listed.h"
#include "tests/core/support.h"

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

TEST(Listed, OfManyNamesTheFirst64OfALongOneTheStart) {
  std::vector<std::string_view> many(64, "n");
  const std::string told = listed(many);
  EXPECT_EQ(std::count(told.begin(), told.end(), 'n'), 64);
  many.resize(69, "n");
  EXPECT_EQ(listed(many), told + " and 5 more");
  const std::string name(100, 'n');
  EXPECT_EQ(listed({name}), std::string(44, 'n') + "… (56 bytes more)");
}

TEST(Listed, OfLongNamesSome440Bytes) {
  const std::string name(64, 'n');
  const std::string all = listed(std::vector<std::string_view>(30, name));
  EXPECT_LT(all.size(), 500U);
  EXPECT_TRUE(all.ends_with("n and 23 more")) << all;
}

TEST(NearestName, OfALongNameIsAtMostFiveEditsAway) {
  const std::string name(60, 'n');
  std::string wrong = name;
  for (std::size_t i = 0; i < 5; ++i) wrong[10 * i] = 'x';
  EXPECT_EQ(nearest_name(wrong, {name}), name);
  wrong[55] = 'x';
  EXPECT_EQ(nearest_name(wrong, {name}), "");
}

// The whole table of distances, as its definition has it.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string random_word(test::Random& random) {
  std::string text(static_cast<std::size_t>(random.whole(1, 12)), 'a');
  for (char& c : text) c = static_cast<char>('a' + random.whole(0, 2));
  return text;
}

TEST(NearestName, IsFoundAsByTheWholeTable) {
  test::Random random(11);
  const auto word = [&] { return random_word(random); };
  for (int i = 0; i < 20'000; ++i) {
    const std::string a = word(), b = word();
    const std::size_t most = std::min({1 + a.size() / 3, a.size() - 1, std::size_t{5}});
    EXPECT_EQ(nearest_name(a, {b}), edits_between(a, b) <= most ? b : "") << a << ' ' << b;
  }
}

// Sorted by the whole table of distances.
TEST(NearestListed, AreTheEightNearestAndTheNumberOfTheOthersHoweverMany) {
  test::Random random(12);
  for (int i = 0; i < 40; ++i) {
    const std::string wrong = random_word(random);
    std::vector<std::string> known(static_cast<std::size_t>(random.whole(0, 100)));
    for (std::string& each : known) each = random_word(random);
    const std::string told = nearest_listed(wrong, {known.begin(), known.end()});
    std::stable_sort(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
      return edits_between(wrong, a) < edits_between(wrong, b);
    });
    std::string expected;
    for (std::size_t k = 0; k < std::min<std::size_t>(8, known.size()); ++k)
      expected += (k > 0 ? ", " : "") + known[k];
    if (known.size() > 8) expected += " and " + std::to_string(known.size() - 8) + " more";
    EXPECT_EQ(told, expected) << wrong;
  }
}

}  // namespace
}  // namespace tia
