// Codec<T>: how a T stands in JSON: read (with every fault at its place), write (defaults left
// out), schema (JSON Schema 2020-12) and allowed (the same in words). One specialisation a type;
// here numbers and words. Whoever uses codecs includes codec.h, which has them all.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/input/json.h"
#include "core/input/value.h"
#include "core/math/vec3.h"

namespace tia {

template <class T>
struct Codec;

/// Reads value into out; adds faults and leaves out as it was where the value is wrong.
template <class T>
void read_value(const Value& value, const Place& at, const Spec& spec, Faults& faults, T& out) {
  Codec<T>::read(value, at, spec, faults, out);
}
template <class T>
Value write_value(const T& value) {
  return Codec<T>::write(value);
}

/// Definitions: the schemas that others refer to ("$defs"), by name.
using Definitions = std::map<std::string, Value>;

/// NamedSchema: a type whose schema is written once and referred to, so that it may hold itself:
///   static constexpr std::string_view schema_name = "object";
template <class T>
concept NamedSchema = requires {
  T::schema_name;
};

/// The reference to the schema of that name, which `make` makes where it is not there yet; it may
/// refer to itself.
template <class Make>
Value schema_called(std::string_view name, Definitions& named, const Make& make) {
  const std::string key(name);
  if (named.emplace(key, Value()).second) named[key] = make();
  return Value::Object{{"$ref", "#/$defs/" + key}};
}

/// A codec whose parts may have names: schema() takes the definitions as well.
template <class T>
concept SchemaOfNamedParts = requires(const Spec& spec, Definitions& named) {
  { Codec<T>::schema(spec, named) } -> std::same_as<Value>;
};

/// The schema of a T, or the reference to it. Whatever it refers to is in `named` afterwards.
template <class T>
Value schema_of(const Spec& spec, Definitions& named) {
  if constexpr (NamedSchema<T>) {
    return schema_called(T::schema_name, named, [&] { return Codec<T>::schema(Spec{}, named); });
  } else if constexpr (SchemaOfNamedParts<T>) {
    return Codec<T>::schema(spec, named);
  } else {
    return Codec<T>::schema(spec);
  }
}

/// A schema with all that it refers to.
Value::Object with_definitions(const Value& schema, const Definitions& named);
template <class T>
Value::Object whole_schema() {
  Definitions named;
  const Value schema = schema_of<T>({}, named);
  return with_definitions(schema, named);
}

namespace detail {

inline void wrong_type(const Value& got, const Place& at, std::string allowed, Faults& faults) {
  faults.add({FaultKind::wrong_type, at.pointer(), excerpt(got), std::move(allowed)});
}

/// A number in the field's range, or a fault and nothing. Never -0, which canonical text lacks.
std::optional<double> read_number(const Value& value, const Place& at, const Spec& spec,
                                  bool integer, Faults& faults);
/// {"type": "number" or "integer", and the range}.
Value::Object number_schema(const Spec& spec, bool integer);

/// The field's range within the type's own and within that in which doubles tell integers apart.
template <std::integral Int>
Spec narrowed(Spec spec) {
  constexpr double exact = 9007199254740991;  // 2^53 - 1
  using Limits = std::numeric_limits<Int>;
  spec.min = std::max({spec.min, static_cast<double>(Limits::min()), -exact});
  spec.max = std::min({spec.max, static_cast<double>(Limits::max()), exact});
  return spec;
}

/// Whether a text is no longer than the field's may be, or a fault.
bool short_enough(const std::string& text, const Place& at, const Spec& spec, Faults& faults);
/// "a string", "a string of at most 256 bytes"; the same as a schema, which counts characters.
std::string text_words(const Spec& spec);
Value::Object text_schema(const Spec& spec);

/// What the names of maps may be.
inline constexpr Spec name_spec{.about = "a name", .max_bytes = longest_name};

/// "an array", "an array of at least 2".
std::string array_text(const Spec& spec);
/// The array that a value is and its length allows, or a fault and null.
const Value::Array* read_array(const Value& value, const Place& at, const Spec& spec,
                               Faults& faults);
/// Adds the fault of a word that is none of the names.
void unknown_word(const Value& got, const Place& at, const std::vector<std::string_view>& names,
                  Faults& faults);

}  // namespace detail

// ---- numbers, words -------------------------------------------------------------------------

template <>
struct Codec<bool> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, bool& out) {
    if (const auto* is = v.as<bool>()) out = *is;
    else detail::wrong_type(v, at, allowed(spec), faults);
  }
  static Value write(bool v) { return v; }
  static Value schema(const Spec&) { return Value::Object{{"type", "boolean"}}; }
  static std::string allowed(const Spec&) { return "true or false"; }
};

template <>
struct Codec<double> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, double& out) {
    if (const auto number = detail::read_number(v, at, spec, false, faults)) out = *number;
  }
  static Value write(double v) { return v; }
  static Value schema(const Spec& spec) { return detail::number_schema(spec, false); }
  static std::string allowed(const Spec& spec) { return range_text(spec, false); }
};

/// Integers are checked as doubles, against the type's own range too, before they are narrowed.
template <std::integral Int>
struct Codec<Int> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Int& out) {
    if (const auto number = detail::read_number(v, at, detail::narrowed<Int>(spec), true, faults))
      out = static_cast<Int>(*number);
  }
  static Value write(Int v) { return static_cast<double>(v); }
  static Value schema(const Spec& spec) {
    return detail::number_schema(detail::narrowed<Int>(spec), true);
  }
  static std::string allowed(const Spec& spec) {
    return range_text(detail::narrowed<Int>(spec), true);
  }
};

template <>
struct Codec<std::string> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::string& out) {
    const auto* text = v.as<std::string>();
    if (text == nullptr) detail::wrong_type(v, at, allowed(spec), faults);
    else if (detail::short_enough(*text, at, spec, faults)) out = *text;
  }
  static Value write(const std::string& v) { return v; }
  static Value schema(const Spec& spec) { return detail::text_schema(spec); }
  static std::string allowed(const Spec& spec) { return detail::text_words(spec); }
};

/// NamesCodec: the codec of words, one a value.
template <Named E>
struct NamesCodec {
  static std::vector<std::string_view> names() {
    return {Names<E>::names.begin(), Names<E>::names.end()};
  }
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, E& out) {
    const auto* text = v.as<std::string>();
    for (std::size_t i = 0; text != nullptr && i < Names<E>::names.size(); ++i)
      if (Names<E>::names[i] == *text) return void(out = static_cast<E>(i));
    detail::unknown_word(v, at, names(), faults);
  }
  static Value write(E v) { return name_of(v); }
  static Value schema(const Spec&) {
    Value::Array list;
    for (const std::string_view name : names()) list.emplace_back(name);
    return Value::Object{{"enum", list}};
  }
  static std::string allowed(const Spec&) { return "one of " + listed(names()); }
};
template <Named E>
struct Codec<E> : NamesCodec<E> {};

}  // namespace tia
