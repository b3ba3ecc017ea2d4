#include "core/input/value.h"

#include <gtest/gtest.h>

#include "core/input/json.h"

namespace tia {
namespace {

TEST(MergePatch, KeepsTheOrderOfWhatStaysAndTakesTimeInProportion) {
  const Value target = parse_json(R"({"a":1,"b":2,"c":3})");
  EXPECT_EQ(to_json(merge_patch(target, parse_json(R"({"b":null})"))), R"({"a":1,"c":3})");
  Value::Object members;
  for (int i = 0; i < 100'000; ++i) members.emplace_back(std::to_string(i), i);
  const Value many(members);  // a minute, were each name searched among all
  EXPECT_EQ(merge_patch(many, many), many);
}

TEST(MergePatch, TableOfRfc7396AppendixA) {
  struct Row {
    const char *original, *patch, *result;
  };
  const Row table[] = {
      {R"({"a":"b"})", R"({"a":"c"})", R"({"a":"c"})"},
      {R"({"a":"b"})", R"({"b":"c"})", R"({"a":"b","b":"c"})"},
      {R"({"a":"b"})", R"({"a":null})", R"({})"},
      {R"({"a":"b","b":"c"})", R"({"a":null})", R"({"b":"c"})"},
      {R"({"a":["b"]})", R"({"a":"c"})", R"({"a":"c"})"},
      {R"({"a":"c"})", R"({"a":["b"]})", R"({"a":["b"]})"},
      {R"({"a":{"b":"c"}})", R"({"a":{"b":"d","c":null}})", R"({"a":{"b":"d"}})"},
      {R"({"a":[{"b":"c"}]})", R"({"a":[1]})", R"({"a":[1]})"},
      {R"(["a","b"])", R"(["c","d"])", R"(["c","d"])"},
      {R"({"a":"b"})", R"(["c"])", R"(["c"])"},
      {R"({"a":"foo"})", "null", "null"},
      {R"({"a":"foo"})", R"("bar")", R"("bar")"},
      {R"({"e":null})", R"({"a":1})", R"({"e":null,"a":1})"},
      {R"([1,2])", R"({"a":"b","c":null})", R"({"a":"b"})"},
      {R"({})", R"({"a":{"bb":{"ccc":null}}})", R"({"a":{"bb":{}}})"},
  };
  for (const Row& row : table)
    EXPECT_EQ(to_json(merge_patch(parse_json(row.original), parse_json(row.patch))),
              to_json(parse_json(row.result)))
        << row.original << " + " << row.patch;
}

TEST(MergePatch, DocumentOfRfc7396Section3) {
  const Value original = parse_json(R"({
    "title": "Goodbye!", "author": {"givenName": "John", "familyName": "Doe"},
    "tags": ["example", "sample"], "content": "This will be unchanged"})");
  const Value patch = parse_json(R"({
    "title": "Hello!", "phoneNumber": "+01-123-456-7890", "author": {"familyName": null},
    "tags": ["example"]})");
  const Value result = parse_json(R"({
    "title": "Hello!", "author": {"givenName": "John"}, "tags": ["example"],
    "content": "This will be unchanged", "phoneNumber": "+01-123-456-7890"})");
  EXPECT_EQ(merge_patch(original, patch), result);
}

TEST(MergePatch, EmptyPatchChangesNothing) {
  const Value original = parse_json(R"({"a":{"b":[1,null]},"c":null})");
  EXPECT_EQ(merge_patch(original, Value::Object{}), original);
}

}  // namespace
}  // namespace tia
