// Codec<T>: how a T stands in JSON: read (with every fault at its place), write (defaults left out)
// and schema (JSON Schema 2020-12). One specialisation a type; described structs share one.
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

namespace detail {

inline void wrong_type(const Value& got, const Place& at, std::string allowed, Faults& faults) {
  faults.add({FaultKind::wrong_type, at.pointer(), got, std::move(allowed)});
}

/// A number in the field's range, or a fault and nothing.
std::optional<double> read_number(const Value& value, const Place& at, const Spec& spec,
                                  bool integer, Faults& faults);
/// {"type": "number" or "integer", and the range}.
Value::Object number_schema(const Spec& spec, bool integer);

template <std::size_t N>
bool read_numbers(const Value& value, const Place& at, const Spec& spec, bool integer,
                  Faults& faults, std::array<double, N>& out) {
  const auto* list = value.as<Value::Array>();
  if (list == nullptr || list->size() != N) {
    wrong_type(value, at, std::to_string(N) + " numbers, each " + range_text(spec, integer),
               faults);
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < N; ++i) {
    const auto number = read_number((*list)[i], at.at(i), spec, integer, faults);
    if (number) out[i] = *number;
    good = good && number.has_value();
  }
  return good;
}

inline Value numbers_schema(const Spec& spec, bool integer, int n) {
  return Value::Object{
      {"type", "array"}, {"items", number_schema(spec, integer)}, {"minItems", n}, {"maxItems", n}};
}

}  // namespace detail

// ---- numbers, words -------------------------------------------------------------------------

template <>
struct Codec<double> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, double& out) {
    if (const auto number = detail::read_number(v, at, spec, false, faults)) out = *number;
  }
  static Value write(double v) { return v; }
  static Value schema(const Spec& spec) { return detail::number_schema(spec, false); }
};

/// Integers are checked as doubles, against the type's own range too, before they are narrowed.
template <std::signed_integral Int>
struct Codec<Int> {
  static void read(const Value& v, const Place& at, Spec spec, Faults& faults, Int& out) {
    spec.min = std::max(spec.min, static_cast<double>(std::numeric_limits<Int>::min()));
    spec.max = std::min(spec.max, static_cast<double>(std::numeric_limits<Int>::max()));
    if (const auto number = detail::read_number(v, at, spec, true, faults))
      out = static_cast<Int>(*number);
  }
  static Value write(Int v) { return static_cast<double>(v); }
  static Value schema(const Spec& spec) { return detail::number_schema(spec, true); }
};

template <>
struct Codec<std::string> {
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, std::string& out) {
    if (const auto* text = v.as<std::string>()) out = *text;
    else detail::wrong_type(v, at, "a string", faults);
  }
  static Value write(const std::string& v) { return v; }
  static Value schema(const Spec&) { return Value::Object{{"type", "string"}}; }
};

template <Named E>
struct Codec<E> {
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, E& out) {
    const std::vector<std::string_view> names(Names<E>::names.begin(), Names<E>::names.end());
    const auto* text = v.as<std::string>();
    if (text == nullptr) return detail::wrong_type(v, at, "one of " + listed(names), faults);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == *text) return void(out = static_cast<E>(i));
    faults.add({FaultKind::unknown_name, at.pointer(), v, "one of " + listed(names),
                nearest_name(*text, names)});
  }
  static Value write(E v) { return name_of(v); }
  static Value schema(const Spec&) {
    Value::Array names;
    for (const std::string_view name : Names<E>::names) names.emplace_back(name);
    return Value::Object{{"enum", names}};
  }
};

// ---- vectors, colours -----------------------------------------------------------------------

template <>
struct Codec<Vec3d> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Vec3d& out) {
    std::array<double, 3> n{};
    if (detail::read_numbers(v, at, spec, false, faults, n)) out = {n[0], n[1], n[2]};
  }
  static Value write(const Vec3d& v) { return Value::Array{v.x, v.y, v.z}; }
  static Value schema(const Spec& spec) { return detail::numbers_schema(spec, false, 3); }
};

template <>
struct Codec<Color> {
  static Spec not_negative(Spec spec) {
    spec.min = 0;
    return spec;
  }
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Color& out) {
    std::array<double, 3> n{};
    if (v.as<double>() != nullptr) {
      if (const auto grey = detail::read_number(v, at, not_negative(spec), false, faults))
        out = {*grey, *grey, *grey};
    } else if (detail::read_numbers(v, at, not_negative(spec), false, faults, n)) {
      out = {n[0], n[1], n[2]};
    }
  }
  static Value write(const Color& c) { return Value::Array{c.r, c.g, c.b}; }
  static Value schema(const Spec& spec) {
    return Value::Object{
        {"oneOf", Value::Array{detail::numbers_schema(not_negative(spec), false, 3),
                               detail::number_schema(not_negative(spec), false)}}};
  }
};

template <std::size_t N>
struct Codec<std::array<int, N>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::array<int, N>& out) {
    std::array<double, N> n{};
    if (!detail::read_numbers(v, at, spec, true, faults, n)) return;
    for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<int>(n[i]);
  }
  static Value write(const std::array<int, N>& v) { return Value::Array(v.begin(), v.end()); }
  static Value schema(const Spec& spec) {
    return detail::numbers_schema(spec, true, static_cast<int>(N));
  }
};

template <std::size_t N>
struct Codec<std::array<double, N>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::array<double, N>& out) {
    std::array<double, N> n{};
    if (detail::read_numbers(v, at, spec, false, faults, n)) out = n;
  }
  static Value write(const std::array<double, N>& v) { return Value::Array(v.begin(), v.end()); }
  static Value schema(const Spec& spec) {
    return detail::numbers_schema(spec, false, static_cast<int>(N));
  }
};

// ---- containers -----------------------------------------------------------------------------

template <class T>
struct Codec<std::optional<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::optional<T>& out) {
    T value{};
    const std::size_t before = faults.list().size();
    read_value(v, at, spec, faults, value);
    if (faults.list().size() == before) out = std::move(value);
  }
  static Value write(const std::optional<T>& v) { return v ? write_value(*v) : Value(); }
  static Value schema(const Spec& spec) { return Codec<T>::schema(spec); }
};

template <class T>
struct Codec<std::vector<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::vector<T>& out) {
    const auto* list = v.as<Value::Array>();
    if (list == nullptr) return detail::wrong_type(v, at, "an array", faults);
    out.clear();
    for (std::size_t i = 0; i < list->size() && !faults.full(); ++i)
      read_value((*list)[i], at.at(i), spec, faults, out.emplace_back());
  }
  static Value write(const std::vector<T>& v) {
    Value::Array list;
    for (const T& each : v) list.push_back(write_value(each));
    return list;
  }
  static Value schema(const Spec& spec) {
    return Value::Object{{"type", "array"}, {"items", Codec<T>::schema(spec)}};
  }
};

template <class T>
struct Codec<std::map<std::string, T>> {
  using Map = std::map<std::string, T>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Map& out) {
    const auto* members = v.as<Value::Object>();
    if (members == nullptr) return detail::wrong_type(v, at, "an object", faults);
    out.clear();
    for (const auto& [name, value] : *members) {
      if (faults.full()) return;
      read_value(value, at.at(name), spec, faults, out[name]);
    }
  }
  static Value write(const Map& v) {
    Value::Object members;
    for (const auto& [name, value] : v) members.emplace_back(name, write_value(value));
    return members;
  }
  static Value schema(const Spec& spec) {
    return Value::Object{{"type", "object"}, {"additionalProperties", Codec<T>::schema(spec)}};
  }
};

/// A name, or the thing itself.
template <class T>
struct Codec<std::variant<std::string, T>> {
  using NameOr = std::variant<std::string, T>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, NameOr& out) {
    if (v.as<std::string>() != nullptr) read_value(v, at, spec, faults, out.template emplace<0>());
    else if (v.as<Value::Object>() != nullptr)
      read_value(v, at, spec, faults, out.template emplace<1>());
    else detail::wrong_type(v, at, "a name or an object", faults);
  }
  static Value write(const NameOr& v) {
    return std::visit([](const auto& is) { return write_value(is); }, v);
  }
  static Value schema(const Spec& spec) {
    return Value::Object{
        {"oneOf", Value::Array{Codec<std::string>::schema(spec), Codec<T>::schema(spec)}}};
  }
};

}  // namespace tia

#include "core/input/described.h"  // IWYU pragma: export
