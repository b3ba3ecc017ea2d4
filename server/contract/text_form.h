// How a field stands in text, in a query string, a flag or an environment variable: turned into the
// JSON that the field's own reader then checks. What cannot be turned stays a string, so that the
// reader can say what came.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/input/codec.h"

namespace tia::server {

/// A number's text as a number, any other as a string: so one with spaces around it.
Value number_from_text(std::string_view text);
/// "true" or "false" as a truth, any other as a string.
Value truth_from_text(std::string_view text);
/// "x,y,z" or "[x,y,z]" as an array of numbers, any other as a string.
Value list_from_text(std::string_view text);
/// "a, b" or ["a","b"] as an array of strings; "" as an empty one.
Value words_from_text(std::string_view text);
/// "x,y,z" or "[[x,y,z],…]" as an array of such, any other as a string.
Value places_from_text(std::string_view text);
/// "[…]" as the JSON that it is, any other as a string. Errors: InputError, pointers below `at`.
Value json_list_from_text(std::string_view text, const Place& at);
/// "{…}" as the JSON that it is, "z:…" as the JSON that is packed in it (packed_text.h), any other
/// as a string. Errors: InputError, pointers below `at`.
Value json_or_name_from_text(std::string_view text, const Place& at);
/// How OpenAPI describes a field in a query, by the schema of its JSON: a list with commas between,
/// an object as JSON, and what is a name or an object as either, or as packed JSON.
Value::Object list_in_query(Value::Object schema);
Value::Object json_in_query(Value::Object schema);
Value::Object places_in_query(const Value::Object& schema);
Value::Object json_or_name_in_query(Value::Object schema);
/// The text that gives this value: strings as they are, lists of them with commas.
std::string text_of(const Value& value);

template <class T>
struct TextForm {
  static Value read(std::string_view text, const Place&) {
    if constexpr (std::same_as<T, bool>) return truth_from_text(text);
    else if constexpr (std::is_arithmetic_v<T>) return number_from_text(text);
    else return text;
  }
  /// What is allowed, for people.
  static std::string allowed(const Spec& spec) {
    if constexpr (std::same_as<T, bool>) return "true or false";
    else if constexpr (std::is_arithmetic_v<T>) return range_text(spec, std::integral<T>);
    else if constexpr (Named<T>) return listed({Names<T>::names.begin(), Names<T>::names.end()});
    else return "text";
  }
  /// How OpenAPI describes it in a query, by the schema of its JSON.
  static Value::Object in_query(Value::Object schema) { return {{"schema", std::move(schema)}}; }
};
template <class T>
struct TextForm<std::optional<T>> : TextForm<T> {};

/// Numbers with commas between, or a JSON array.
struct NumbersForm {
  static Value read(std::string_view text, const Place&) { return list_from_text(text); }
  static Value::Object in_query(Value::Object schema) { return list_in_query(std::move(schema)); }
};
template <>
struct TextForm<Vec3d> : NumbersForm {
  static std::string allowed(const Spec& spec) { return "x,y,z, each " + range_text(spec, false); }
};
template <class Number, std::size_t N>
struct TextForm<std::array<Number, N>> : NumbersForm {
  static std::string allowed(const Spec& spec) {
    return std::to_string(N) + " numbers, each " + range_text(spec, std::integral<Number>);
  }
};
template <class T>
struct TextForm<std::vector<T>> {
  static Value read(std::string_view text, const Place&) { return words_from_text(text); }
  static std::string allowed(const Spec& spec) {
    return "a list with commas between, each " + Codec<T>::allowed(spec);
  }
};
/// Places, one each time that the parameter comes, or a JSON array of them.
template <>
struct TextForm<std::vector<Vec3d>> {
  static Value read(std::string_view text, const Place&) { return places_from_text(text); }
  static std::string allowed(const Spec& spec) { return TextForm<Vec3d>::allowed(spec); }
  // NOLINTNEXTLINE(performance-unnecessary-value-param): as those of all types
  static Value::Object in_query(Value::Object schema) { return places_in_query(schema); }
};
/// Objects, as a JSON array.
template <Described T>
struct TextForm<std::vector<T>> {
  static Value read(std::string_view text, const Place& at) {
    return json_list_from_text(text, at);
  }
  static std::string allowed(const Spec&) { return "a JSON array of objects"; }
  static Value::Object in_query(Value::Object schema) { return json_in_query(std::move(schema)); }
};
template <class T>
struct TextForm<std::variant<std::string, T>> {
  static Value read(std::string_view text, const Place& at) {
    return json_or_name_from_text(text, at);
  }
  static Value::Object in_query(Value::Object schema) {
    return json_or_name_in_query(std::move(schema));
  }
};

/// An object, as URL-encoded JSON.
struct ObjectForm {
  static Value read(std::string_view text, const Place& at) {
    return json_or_name_from_text(text, at);
  }
  static std::string allowed(const Spec&) { return "a JSON object"; }
  static Value::Object in_query(Value::Object schema) { return json_in_query(std::move(schema)); }
};
template <Described T>
struct TextForm<T> : ObjectForm {};

/// Visitor: finds the field of that name and reads the text in its form.
struct FieldFromText {
  std::string_view name, text;
  Value value;
  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*, const Spec&) {
    if (field == name) value = TextForm<Member>::read(text, Place{}.at(name));
  }
};

/// The JSON of the field called `name` of a described T; a string where T has no such field.
template <class T>
Value field_from_text(std::string_view name, std::string_view text) {
  FieldFromText visitor{name, text, text};
  T::fields(visitor);
  return visitor.value;
}

/// Whether that field may come several times in a query, each time with one element of its list.
template <class T>
bool comes_again(std::string_view name) {
  bool again = false;
  T::fields([&]<class Base, class Member>(std::string_view field, Member Base::*, const Spec&) {
    if (field == name) again = std::same_as<Member, std::vector<Vec3d>>;
  });
  return again;
}

/// Visitor: the same of a field inside a group, an object of its own.
struct GroupFieldFromText {
  std::string_view group, name, text;
  std::optional<Value> value;
  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*, const Spec&) {
    if constexpr (detail::is_optional<Member>)
      if constexpr (Described<typename Member::value_type>)
        if (field == group) value = field_from_text<typename Member::value_type>(name, text);
  }
};

/// The JSON of the field `name` of T's field `group`; nothing where T has no such group.
template <class T>
std::optional<Value> field_of_group_from_text(std::string_view group, std::string_view name,
                                              std::string_view text) {
  GroupFieldFromText visitor{group, name, text, {}};
  T::fields(visitor);
  return visitor.value;
}

}  // namespace tia::server
