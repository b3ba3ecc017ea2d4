// What is counted of a text before it is parsed, against what parsing finds.
#include "core/input/item_counts.h"

#include <gtest/gtest.h>

#include "core/input/json.h"
#include "core/parallel/stopped.h"
#include "core/scene/scene.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using Counts = std::vector<std::uint32_t>;

TEST(ItemCounts, AreThoseOfEachListAndObjectInTheOrderInWhichTheyBegin) {
  EXPECT_EQ(item_counts("[]", 9), (Counts{0}));
  EXPECT_EQ(item_counts(" [ 1 , [ ] , { \"a\" : [ 2 , 3 ] } ] ", 9), (Counts{3, 0, 1, 2}));
  EXPECT_EQ(item_counts(R"(["[,", "\",", "\\", {"]":1,"}":2}])", 9), (Counts{4, 2}));
  EXPECT_EQ(item_counts("7", 9), Counts{});
  EXPECT_EQ(item_counts("[1,[[[2]]]]", 2), (Counts{1, 0})) << "as far as they are counted";
}

TEST(ItemCounts, OfWhatIsNoJsonAreNoMoreThanHalfItsBytes) {
  for (const char* text : {"[,,,,,,", "[1,,,,]", "]]]]", "}{,", "[\"", "\"\\", "[1}2]", "{,:,:,"}) {
    std::size_t sum = 0;
    for (const std::uint32_t count : item_counts(text, 99)) sum += count;
    EXPECT_LE(2 * sum, std::string_view(text).size()) << text;
  }
}

Value random_value(test::Random& random, int depth) {
  if (depth == 0 || random.chance(0.3)) return random.chance(0.5) ? Value(1) : Value("a\",[{");
  if (random.chance(0.5)) {
    Value::Array list;
    for (int i = random.below(5); i > 0; --i) list.push_back(random_value(random, depth - 1));
    return list;
  }
  Value::Object members;
  for (int i = random.below(5); i > 0; --i)
    members.emplace_back("]," + std::to_string(i), random_value(random, depth - 1));
  return members;
}

// Members in the text's order.
void expect_exact(const Value& value) {
  if (const auto* list = value.as<Value::Array>()) {
    EXPECT_EQ(list->capacity(), list->size());
    for (const Value& each : *list) expect_exact(each);
  }
  if (const auto* members = value.as<Value::Object>()) {
    EXPECT_EQ(members->capacity(), members->size());
    for (const auto& [name, each] : *members) expect_exact(each);
  }
}

TEST(ParseJson, TakesNoMoreMemoryThanItsListsAndObjectsHold) {
  test::Random random(11);
  for (int i = 0; i < 500; ++i) expect_exact(parse_json(to_json(random_value(random, 5))));
}

TEST(ParseJson, EndsWhenThatIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  const auto list = [](int count) {
    std::string text = "[0";
    for (int i = 1; i < count; ++i) text += ",0";
    return text + "]";
  };
  EXPECT_THROW(parse_json(list(10'000), {}, source.get_token()), Stopped);
  EXPECT_THROW(parse_json(list(1'000'000), {}, source.get_token()), Stopped);
  EXPECT_NO_THROW(parse_json(list(10'000), {}, std::stop_source().get_token()));
}

TEST(ReadDescribed, EndsWhenThatIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  const Value lights = Value::Array(5000, Value(Value::Object{{"type", "sky"}}));
  const Value scene = Value::Object{{"lights", lights}};
  EXPECT_EQ(read_described<Scene>(scene).lights.size(), 5000U);
  EXPECT_THROW(read_described<Scene>(scene, {}, source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
