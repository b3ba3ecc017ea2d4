// A JSON value as plain data: what parsing gives and what readers, writers and problem documents
// share. Members keep the order of the text. Numbers are doubles, as RFC 8785 has them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tia {

struct Value {
  using Array = std::vector<Value>;
  using Member = std::pair<std::string, Value>;
  using Object = std::vector<Member>;

  using Kind = std::variant<std::nullptr_t, bool, double, std::string, Array, Object>;
  Kind is = nullptr;

  Value() = default;
  /// Not the variant's own copy: where memory for it is short, libstdc++ 12 destroys what it has
  /// not made yet, if it takes all kinds for such that are never without a value, as these.
  Value(const Value& other)
      : is(std::visit([](const auto& kind) { return Kind(kind); }, other.is)) {}
  Value(Value&&) = default;
  Value& operator=(const Value&) = default;
  Value& operator=(Value&&) = default;
  ~Value() = default;
  Value(bool b) : is(b) {}
  Value(double d) : is(d) {}
  Value(int i) : is(static_cast<double>(i)) {}
  Value(std::string s) : is(std::move(s)) {}
  Value(std::string_view s) : is(std::string(s)) {}
  Value(const char* s) : is(std::string(s)) {}
  Value(Array a) : is(std::move(a)) {}
  Value(Object o) : is(std::move(o)) {}

  template <class T>
  const T* as() const {
    return std::get_if<T>(&is);
  }
  template <class T>
  T* as() {
    return std::get_if<T>(&is);
  }
  /// Equal as JSON: members in any order, each name once.
  bool operator==(const Value& other) const;
};

/// The member of that name, or null.
inline const Value* find(const Value::Object& object, std::string_view name) {
  for (const auto& [key, value] : object)
    if (key == name) return &value;
  return nullptr;
}

/// RFC 7396 (JSON merge patch): the patch's members replace or, where null, remove the target's.
Value merge_patch(Value target, const Value& patch);

}  // namespace tia
