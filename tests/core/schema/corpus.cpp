#include "tests/core/schema/corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tia::test {

Corpus::Corpus(const JsonSchema& schema, std::uint64_t seed) : schema_(schema), random_(seed) {
  collect_numbers(schema.document());
}
Value Corpus::document() { return make(schema_.document(), 0); }
Value Corpus::changed(Value document) {
  std::vector<Value*> parts;
  collect_parts(document, parts);
  change(*parts[pick(parts.size())]);
  return document;
}

std::size_t Corpus::pick(std::size_t n) {
  return static_cast<std::size_t>(random_.below(static_cast<int>(n)));
}

Value Corpus::make(const Value& reference, int depth) {
  const auto& schema = as_object(schema_.resolved(reference));
  if (const Value* only = find(schema, "const")) return *only;
  if (const Value* words = find(schema, "enum"))
    return as_array(*words)[pick(as_array(*words).size())];
  if (const Value* examples = find(schema, "examples"))
    return as_array(*examples)[pick(as_array(*examples).size())];
  for (const char* either : {"oneOf", "anyOf"})
    if (const Value* alternatives = find(schema, either)) {
      const auto& list = as_array(*alternatives);
      return make(list[depth < deepest ? pick(list.size()) : 0], depth + 1);
    }
  const Value* type = find(schema, "type");
  if (type == nullptr) return random_.chance(0.5) ? Value(1) : Value("any");
  if (as_text(*type) == "object") return make_object(schema, depth);
  if (as_text(*type) == "array") return make_array(schema, depth);
  if (as_text(*type) == "string") return random_.chance(0.5) ? "" : "text";
  if (as_text(*type) == "boolean") return random_.chance(0.5);
  if (as_text(*type) == "null") return {};
  return make_number(schema, as_text(*type) == "integer");
}

Value Corpus::make_object(const Value::Object& schema, int depth) {
  Value::Object made;
  const Value* required = find(schema, "required");
  const auto needs = [&](const Value& name) {
    return required != nullptr && std::find(as_array(*required).begin(), as_array(*required).end(),
                                            name) != as_array(*required).end();
  };
  if (const Value* properties = find(schema, "properties"))
    for (const auto& [name, property] : as_object(*properties))
      if (needs(Value(name)) || (depth < deepest && random_.chance(0.3)))
        made.emplace_back(name, make(property, depth + 1));
  const Value* others = find(schema, "additionalProperties");
  if (others != nullptr && others->as<bool>() == nullptr)
    for (int i = depth < deepest ? random_.below(3) : 0; i > 0; --i)
      made.emplace_back("name " + std::to_string(i), make(*others, depth + 1));
  return made;
}

Value Corpus::make_array(const Value::Object& schema, int depth) {
  const auto bound = [&](const char* word, std::size_t otherwise) {
    const Value* is = find(schema, word);
    return is != nullptr ? static_cast<std::size_t>(as_number(*is)) : otherwise;
  };
  const std::size_t least = bound("minItems", 0);
  const std::size_t most = depth < deepest ? bound("maxItems", least + 3) : least;
  const Value* first = find(schema, "prefixItems");
  Value::Array made(least + pick(most - least + 1));
  for (std::size_t i = 0; i < made.size(); ++i) {
    const bool own = first != nullptr && i < as_array(*first).size();
    made[i] = make(own ? as_array(*first)[i] : *find(schema, "items"), depth + 1);
  }
  return made;
}

// Often small, so that values agree with each other; at times a bound itself.
Value Corpus::make_number(const Value::Object& schema, bool integer) {
  const Value *least = find(schema, "minimum"), *above = find(schema, "exclusiveMinimum");
  const Value* most = find(schema, "maximum");
  const double low = least != nullptr   ? as_number(*least)
                     : above != nullptr ? as_number(*above)
                                        : -1e9;
  const double high = most != nullptr ? as_number(*most) : 1e9;
  if (least != nullptr && low != 0 && random_.chance(0.02)) return low;
  if (most != nullptr && random_.chance(0.02)) return high;
  double made = random_.in(std::max(low, -5.0), std::min(high, 5.0));
  if (random_.chance(0.5) || integer) made = std::ceil(made);
  made = std::min(made, high);
  return made > low && made != 0 ? made : std::min(high, std::max(low, 0.0) + 1);
}

// Every number of the schema and its neighbours.
void Corpus::collect_numbers(const Value& part) {
  if (const auto* bound = part.as<double>())
    for (const double n : {*bound, std::nextafter(*bound, -INFINITY),
                           std::nextafter(*bound, INFINITY), *bound - 1, *bound + 1, -*bound})
      numbers_.insert(n);
  if (const auto* items = part.as<Value::Array>())
    for (const Value& item : *items) collect_numbers(item);
  if (const auto* members = part.as<Value::Object>())
    for (const auto& [name, member] : *members) collect_numbers(member);
}

void Corpus::collect_parts(Value& value, std::vector<Value*>& parts) {
  parts.push_back(&value);
  if (auto* items = value.as<Value::Array>())
    for (Value& item : *items) collect_parts(item, parts);
  if (auto* members = value.as<Value::Object>())
    for (auto& [name, member] : *members) collect_parts(member, parts);
}

void Corpus::change(Value& part) {
  if (random_.chance(0.25)) return void(part = any_value());
  if (auto* members = part.as<Value::Object>()) change_members(*members);
  else if (auto* items = part.as<Value::Array>()) change_items(*items);
  else if (part.as<double>() != nullptr) part = random_.chance(0.2) ? 0 : any_bound();
  else if (auto* word = part.as<std::string>()) change_text(*word);
  else part = any_value();
}

double Corpus::any_bound() {
  return *std::next(numbers_.begin(), static_cast<std::ptrdiff_t>(pick(numbers_.size())));
}

void Corpus::change_members(Value::Object& members) {
  const std::size_t at = members.empty() ? 0 : pick(members.size());
  if (members.empty() || random_.chance(0.3)) return void(members.emplace_back("unheard of", 1));
  if (random_.chance(0.5)) members.erase(members.begin() + static_cast<std::ptrdiff_t>(at));
  else members[at].first += 's';
}

void Corpus::change_items(Value::Array& items) {
  if (items.empty()) return void(items.push_back(any_value()));
  if (random_.chance(0.5)) items.pop_back();
  else items.push_back(items[pick(items.size())]);
}

void Corpus::change_text(std::string& word) {
  if (word.empty() || random_.chance(0.3)) word += 'x';
  else if (random_.chance(0.5)) word.pop_back();
  else word[pick(word.size())] = random_.chance(0.5) ? 'B' : '!';
}

Value Corpus::any_value() {
  const Value values[] = {Value(),
                          true,
                          0,
                          -1,
                          0.5,
                          1e300,
                          "text",
                          "",
                          Value::Array{},
                          Value::Array{1, 2, 3},
                          Value::Object{},
                          Value::Object{{"type", "sphere"}}};
  return values[pick(std::size(values))];
}

Agreement judge(const Value& schema_document, const Reader& reader, int count,
                const std::vector<std::string>& beyond_schema) {
  const JsonSchema schema(schema_document);
  Corpus corpus(schema, 7);
  Agreement agreement;
  const auto seen_by_schema = [&](const Fault& fault) {
    return std::none_of(beyond_schema.begin(), beyond_schema.end(), [&](const std::string& words) {
      return fault.allowed.find(words) != std::string::npos;
    });
  };
  const auto judge_one = [&](const Value& document) {
    const std::vector<Fault> list = reader(document);
    const bool accepts = std::none_of(list.begin(), list.end(), seen_by_schema);
    if (accepts && list.size() == Faults::most) return;  // and more that is not told
    if (accepts != schema.valid(document)) {
      std::string text = to_json(document);
      for (const Fault& fault : list) text += "\n  " + describe(fault);
      return agreement.disputed.push_back(text);
    }
    ++(accepts ? agreement.both_accept : agreement.both_refuse);
  };
  for (int i = 0; i < count && agreement.disputed.size() < 10; ++i) {
    Value document = corpus.document();
    judge_one(document);
    judge_one(corpus.changed(std::move(document)));
  }
  return agreement;
}

void expect_agreement(const Value& schema_document, const Reader& reader, int count,
                      const std::vector<std::string>& beyond_schema) {
  const Agreement agreement = judge(schema_document, reader, count, beyond_schema);
  EXPECT_TRUE(agreement.disputed.empty())
      << agreement.disputed.size() << " such as " << agreement.disputed.front();
  EXPECT_GT(agreement.both_accept, count * 3 / 4);
  EXPECT_GT(agreement.both_refuse, count / 4);
}

}  // namespace tia::test
