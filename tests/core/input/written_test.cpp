// Schemas of objects that code writes member by member.
#include "core/input/object_schema.h"

#include <gtest/gtest.h>

#include "tests/core/schema/json_schema.h"

namespace tia {
namespace {

bool obeys(const Value& schema, const char* json) {
  return test::JsonSchema(schema).valid(parse_json(json));
}

TEST(WrittenObject, HasItsMembersAndNoOthers) {
  const Value schema = object_schema({{"name", plain_schema<std::string>(), "what it is called"},
                                      {"size", count_schema(1), "", false}});
  EXPECT_TRUE(obeys(schema, R"({"name":"a"})"));
  EXPECT_TRUE(obeys(schema, R"({"name":"a","size":1})"));
  for (const char* wrong :
       {"[]", "{}", R"({"size":1})", R"({"name":1})", R"({"name":"a","size":0})",
        R"({"name":"a","size":1.5})", R"({"name":"a","more":1})"})
    EXPECT_FALSE(obeys(schema, wrong)) << wrong;
}

TEST(WrittenObject, TellsWhatAMemberMeans) {
  EXPECT_EQ(to_json(object_schema({{"a", plain_schema<bool>(), "whether"}, {"b", count_schema()}})),
            R"({"additionalProperties":false,"properties":{)"
            R"("a":{"description":"whether","type":"boolean"},"b":{"minimum":0,"type":"integer"}},)"
            R"("required":["a","b"],"type":"object"})");
}

TEST(WrittenList, AndWhatMayBeNull) {
  const Value list = list_schema(nullable_schema(plain_schema<double>({.min = 0})));
  EXPECT_TRUE(obeys(list, "[]"));
  EXPECT_TRUE(obeys(list, "[1,null]"));
  for (const char* wrong : {"null", "[-1]", "[\"1\"]", "{}"})
    EXPECT_FALSE(obeys(list, wrong)) << wrong;
}

// One that refers to itself is made once.
Value tree_schema(Definitions& named, int& made) {
  return schema_called("tree", named, [&] {
    ++made;
    return object_schema({{"children", list_schema(tree_schema(named, made))}});
  });
}

TEST(NamedSchema, OfWhatIsWrittenMayReferToItself) {
  Definitions named;
  int made = 0;
  const Value reference = tree_schema(named, made);
  EXPECT_EQ(made, 1);
  const Value whole = with_definitions(reference, named);
  EXPECT_TRUE(obeys(whole, R"({"children":[{"children":[]}]})"));
  EXPECT_FALSE(obeys(whole, R"({"children":[{"children":[{}]}]})"));
}

}  // namespace
}  // namespace tia
