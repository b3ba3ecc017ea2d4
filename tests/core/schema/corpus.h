// Documents made from a JSON Schema and from a fixed seed: right ones, and ones with a mistake.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/input/codec.h"
#include "tests/core/schema/json_schema.h"
#include "tests/core/support.h"

namespace tia::test {

/// Corpus: makes values that a schema accepts, and changes them so that it may no longer.
class Corpus {
 public:
  Corpus(const JsonSchema& schema, std::uint64_t seed);
  Value document();
  /// The document with one thing changed: a member dropped, renamed or added, a value of another
  /// type, a number at or beyond some bound of the schema, an item more or less.
  Value changed(Value document);

 private:
  static constexpr int deepest = 9;  // from there on the first alternative and the fewest items

  std::size_t pick(std::size_t n);
  Value make(const Value& reference, int depth);
  Value make_object(const Value::Object& schema, int depth);
  Value make_array(const Value::Object& schema, int depth);
  Value make_number(const Value::Object& schema, bool integer);
  void collect_numbers(const Value& part);
  void collect_parts(Value& value, std::vector<Value*>& parts);
  void change(Value& part);
  double any_bound();
  void change_members(Value::Object& members);
  void change_items(Value::Array& items);
  void change_text(std::string& word);
  Value any_value();

  const JsonSchema& schema_;
  Random random_;
  std::set<double> numbers_;
};

/// Agreement: how a type's reader and its schema judged a corpus.
struct Agreement {
  int both_accept = 0, both_refuse = 0;
  std::vector<std::string> disputed;  ///< the documents on which they differ, with the faults
};

/// The faults that a reader finds in a document.
using Reader = std::function<std::vector<Fault>(const Value&)>;
template <class T>
std::vector<Fault> faults_by_reader(const Value& document) {
  Faults faults;
  T read{};
  read_value(document, Place{}, Spec{}, faults, read);
  return faults.list();
}

/// Lets both judge `count` documents and as many changed ones, until they differ on ten. Faults
/// with one of the texts of `beyond_schema` in what they allow are those that only the reader can
/// see, and do not count.
Agreement judge(const Value& schema_document, const Reader& reader, int count,
                const std::vector<std::string>& beyond_schema);
template <class T>
Agreement judge(const Value& schema_document, int count,
                const std::vector<std::string>& beyond_schema) {
  return judge(schema_document, faults_by_reader<T>, count, beyond_schema);
}

/// Checks that they agree on a corpus, of which each accepts and refuses a good part.
void expect_agreement(const Value& schema_document, const Reader& reader, int count,
                      const std::vector<std::string>& beyond_schema);
template <class T>
void expect_agreement(const Value& schema_document, int count,
                      const std::vector<std::string>& beyond_schema) {
  expect_agreement(schema_document, faults_by_reader<T>, count, beyond_schema);
}

}  // namespace tia::test
