// Described types that hold themselves, kinds with checks of their own, and schemas by name.
#include <gtest/gtest.h>

#include "core/input/codec.h"
#include "core/input/numbers.h"
#include "core/input/transform_steps.h"
#include "tests/core/faults.h"
#include "tests/core/schema/corpus.h"

namespace tia {
namespace {

using enum FaultKind;
using test::Expected;

enum class Timber { oak, pine };

}  // namespace
template <>
struct Names<Timber> {
  static constexpr std::array<std::string_view, 2> names{"oak", "pine"};
};
namespace {

// A tree of every codec there is: leaves, and branches that hold nodes again.
struct Node;

struct Leaf {
  static constexpr std::string_view type = "leaf";
  double size = 0, bend = 1;
  std::array<double, 3> parts{};
  bool green = true;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("size", &Leaf::size,
          Spec{.about = "the size", .min = 0, .max = 9, .open_min = true, .required = true});
    visit("bend", &Leaf::bend, Spec{.about = "the bend", .min = -3, .max = 3, .not_zero = true});
    visit("parts", &Leaf::parts, Spec{.about = "three shares", .min = 0, .max = 4});
    visit("green", &Leaf::green, Spec{.about = "whether it is green"});
  }
  void check(const Place& at, Faults& faults) const {
    if (parts[0] > parts[1])
      faults.add({conflict, at.at("parts").pointer(), write_value(parts), "shares that grow"});
  }
  bool operator==(const Leaf&) const = default;
};

struct Branch {
  static constexpr std::string_view type = "branch";
  std::vector<Node> children;
  std::array<int, 2> count{1, 1};
  Timber wood = Timber::oak;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("children", &Branch::children,
          Spec{.about = "the nodes", .required = true, .min_items = 1});
    visit("count", &Branch::count, Spec{.about = "how many", .min = 1, .max = 3});
    visit("wood", &Branch::wood, Spec{.about = "the wood"});
  }
  bool operator==(const Branch&) const = default;
};

struct Node {
  static constexpr std::string_view schema_name = "node";
  std::variant<Leaf, Branch> kind;
  std::string name;
  TransformSteps transform;
  Numbers<float> heights;
  Numbers<std::uint32_t> marks;
  std::optional<std::variant<std::string, Leaf>> fruit;
  std::map<std::string, Color> colors;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("name", &Node::name, Spec{.about = "its name"});
    visit.one_of(&Node::kind, Spec{.about = "the kind of node", .required = true});
    visit("transform", &Node::transform, Spec{.about = "where it stands"});
    visit("heights", &Node::heights, Spec{.about = "heights", .min = -8, .max = 8, .min_items = 2});
    visit("marks", &Node::marks, Spec{.about = "marks", .max = 700});
    visit("fruit", &Node::fruit, Spec{.about = "a name, or a leaf"});
    visit("colors", &Node::colors, Spec{.about = "colours by name", .max = 5});
  }
  bool operator==(const Node&) const = default;
};

Node read_node(const std::string& json) { return read_described<Node>(parse_json(json)); }
const auto expect_node_refused = test::refusal_by([](const std::string& json) { read_node(json); });

// ---- reading ----------------------------------------------------------------------------------

TEST(Described, TypesMayHoldThemselves) {
  const char* json = R"({"children":[{"children":[{"size":1,"type":"leaf"}],"type":"branch"},)"
                     R"({"size":2,"transform":[{"scale":2}],"type":"leaf"}],"type":"branch"})";
  const Node node = read_node(json);
  const auto& children = std::get<Branch>(node.kind).children;
  EXPECT_EQ(std::get<Leaf>(children.at(1).kind).size, 2);
  EXPECT_EQ(std::get<Leaf>(std::get<Branch>(children.at(0).kind).children.at(0).kind).size, 1);
  EXPECT_EQ(to_json(write_value(node)), json);
}

TEST(Described, FaultsOfAllDepthsComeAtOnce) {
  expect_node_refused(
      R"({"type":"branch","wood":"oat","transform":[{"scale":0}],"children":[
          {"type":"branch","children":[{"type":"leaf","size":0},{"type":"leafs"}]},
          {"type":"leaf","size":1,"parts":[2,1,0],"heights":[0]},
          {"type":"branch","children":[]}]})",
      {{out_of_range, "/children/0/children/0/size", "0", "above 0, at most 9"},
       {unknown_name, "/children/0/children/1/type", "\"leafs\"", "one of leaf, branch", "leaf"},
       {wrong_type, "/children/1/heights", "[0]", "an array of at least 2"},
       {conflict, "/children/1/parts", "[2,1,0]", "shares that grow"},
       {wrong_type, "/children/2/children", "[]", "an array of at least 1"},
       {unknown_name, "/wood", "\"oat\"", "one of oak, pine", "oak"},
       {out_of_range, "/transform/0/scale", "0", "not 0"}});
}

TEST(Described, MissingFieldsSayWhatTheyMeanAndAllow) {
  expect_node_refused(R"({"type":"leaf"})",
                      {{missing, "/size", "", "the size: a number above 0, at most 9"}});
  expect_node_refused(R"({"type":"branch"})",
                      {{missing, "/children", "", "the nodes: an array of at least 1"}});
  expect_node_refused("{}", {{missing, "/type", "", "the kind of node: one of leaf, branch"}});
}

TEST(Described, KindsAreCheckedOnlyWhereAllTheirFieldsAreRight) {
  const char* growing = R"({"type":"leaf","size":1,"parts":[2,1,0]})";
  expect_node_refused(growing, {{conflict, "/parts", "[2,1,0]", "shares that grow"}});
  expect_node_refused(R"({"type":"leaf","size":1,"parts":[9,1,0]})",
                      {{out_of_range, "/parts/0", "9", "from 0 to 4"}});
  expect_node_refused(R"({"type":"leaf","size":1,"parts":[2,1,0],"part":1})",
                      {{unknown_name, "/part", "\"part\"", "parts", "parts"}});
}

TEST(Described, LongValuesAreCutShortInFaults) {
  const std::string name(500, 'x');
  const auto faults = test::faults_of([&] { read_node(("{\"type\":\"" + name + "\"}").c_str()); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(*faults[0].got, Value(std::string(100, 'x') + "… (400 bytes more)"));
  Faults bare;
  bare.add({wrong_type, "", Value(Value::Array(1000, Value(1))), "less"});
  const std::string got = to_json(*bare.list()[0].got);
  EXPECT_LT(got.size(), 130U);
  EXPECT_TRUE(got.ends_with("1,1… (an array of 1000)\"")) << got;
}

// ---- writing ----------------------------------------------------------------------------------

struct Before {
  double a = 1;
  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("a", &Before::a, Spec{});
  }
};
struct After {
  Numbers<float> new_list;
  double a = 1;
  TransformSteps new_transform;
  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("0", &After::new_list, Spec{});
    visit("a", &After::a, Spec{});
    visit("b", &After::new_transform, Spec{});
  }
};

TEST(Described, FieldsThatComeLaterDoNotChangeTheText) {
  for (const char* json : {"{}", R"({"a":2})"}) {
    const Value text = parse_json(json);
    EXPECT_EQ(to_json(write_value(read_described<After>(text))), json);
    EXPECT_EQ(to_json(write_value(read_described<Before>(text))), json);
  }
}

// ---- schema -----------------------------------------------------------------------------------

TEST(NamedSchema, StandsOnceAndIsReferredTo) {
  const Value::Object schema = whole_schema<Node>();
  EXPECT_EQ(*find(schema, "$ref"), Value("#/$defs/node"));
  const auto& named = *find(schema, "$defs")->as<Value::Object>();
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0].first, "node");
  EXPECT_EQ(named[1].first, "transform");
  EXPECT_NE(to_json(named[0].second).find(R"("items":{"$ref":"#/$defs/node"})"), std::string::npos);
}

const std::vector<std::string> beyond_node_schema = {
    "shares that grow", "can be undone", "bytes of numbers",
    "numbers of 4 bytes"  // the schema sees only how base64 is spelt
};

TEST(NamedSchema, AgreesWithTheReaderOnMadeDocuments) {
  test::expect_agreement<Node>(whole_schema<Node>(), 1000, beyond_node_schema);
}

// The value without any member of that name.
Value without(const Value& value, std::string_view word) {
  if (const auto* items = value.as<Value::Array>()) {
    Value::Array kept;
    for (const Value& item : *items) kept.push_back(without(item, word));
    return kept;
  }
  const auto* members = value.as<Value::Object>();
  if (members == nullptr) return value;
  Value::Object kept;
  for (const auto& [name, member] : *members)
    if (name != word) kept.emplace_back(name, without(member, word));
  return kept;
}

// The corpus must be rich enough to tell: a schema that keeps one thing to itself is found out.
TEST(NamedSchema, WithAnyWordLeftOutDisagreesWithTheReader) {
  for (const char* word : {"minimum", "exclusiveMinimum", "maximum", "required", "minItems",
                           "additionalProperties", "pattern", "prefixItems", "not"}) {
    const Value weaker = without(whole_schema<Node>(), word);
    EXPECT_FALSE(test::judge<Node>(weaker, 600, beyond_node_schema).disputed.empty()) << word;
  }
}

}  // namespace
}  // namespace tia
