// Codecs of lists, vectors, colours, maps and alternatives. They name each other: whoever uses
// them includes codec.h.
#pragma once

#include "core/input/value_codecs.h"

namespace tia {

// ---- fixed lists ----------------------------------------------------------------------------

template <class T, std::size_t N>
struct Codec<std::array<T, N>> {
  using List = std::array<T, N>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, List& out) {
    const auto* list = v.as<Value::Array>();
    if (list == nullptr || list->size() != N)
      return detail::wrong_type(v, at, allowed(spec), faults);
    List each = out;
    const std::size_t before = faults.count();
    for (std::size_t i = 0; i < N; ++i) read_value((*list)[i], at.at(i), spec, faults, each[i]);
    if (faults.count() == before) out = each;
  }
  static Value write(const List& v) {
    Value::Array list;
    for (const T& each : v) {
      give_way();
      list.push_back(write_value(each));
    }
    return list;
  }
  static Value schema(const Spec& spec, Definitions& named) {
    return Value::Object{{"type", "array"},
                         {"items", schema_of<T>(spec, named)},
                         {"minItems", static_cast<double>(N)},
                         {"maxItems", static_cast<double>(N)}};
  }
  static std::string allowed(const Spec& spec) {
    constexpr bool is_color = std::is_same_v<T, Color>;
    std::string words = std::to_string(N);  // by itself: g++ 12 cries wolf over sums of texts
    words += std::is_arithmetic_v<T> ? " numbers" : is_color ? " colours" : " lists";
    return words += ", each " + Codec<T>::allowed(spec);
  }
};

template <>
struct Codec<Vec3d> {
  using List = std::array<double, 3>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Vec3d& out) {
    List n{out.x, out.y, out.z};
    read_value(v, at, spec, faults, n);
    out = {n[0], n[1], n[2]};
  }
  static Value write(const Vec3d& v) { return Value::Array{v.x, v.y, v.z}; }
  static Value schema(const Spec& spec, Definitions& named) { return schema_of<List>(spec, named); }
  static std::string allowed(const Spec& spec) { return Codec<List>::allowed(spec); }
};

/// A number, or three.
template <>
struct Codec<std::variant<double, Vec3d>> {
  using OneOrThree = std::variant<double, Vec3d>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   OneOrThree& out) {
    if (v.as<double>() != nullptr) read_value(v, at, spec, faults, out.emplace<0>());
    else if (v.as<Value::Array>() != nullptr) read_value(v, at, spec, faults, out.emplace<1>());
    else detail::wrong_type(v, at, allowed(spec), faults);
  }
  static Value write(const OneOrThree& v) {
    return std::visit([](const auto& is) { return write_value(is); }, v);
  }
  static Value schema(const Spec& spec, Definitions& named) {
    return Value::Object{
        {"oneOf", Value::Array{schema_of<Vec3d>(spec, named), schema_of<double>(spec, named)}}};
  }
  static std::string allowed(const Spec& spec) {
    return Codec<Vec3d>::allowed(spec) + ", or one number for all 3";
  }
};

/// Three numbers, or one for a grey.
template <>
struct Codec<Color> {
  using OneOrThree = std::variant<double, Vec3d>;
  static Spec not_negative(Spec spec) {
    spec.min = 0;
    return spec;
  }
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Color& out) {
    OneOrThree is = Vec3d{out.r, out.g, out.b};
    const std::size_t before = faults.count();
    read_value(v, at, not_negative(spec), faults, is);
    if (faults.count() != before) return;
    if (const auto* grey = std::get_if<double>(&is)) is = Vec3d{*grey, *grey, *grey};
    const auto& rgb = std::get<Vec3d>(is);
    out = {rgb.x, rgb.y, rgb.z};
  }
  static Value write(const Color& c) { return Value::Array{c.r, c.g, c.b}; }
  static Value schema(const Spec& spec, Definitions& named) {
    return schema_of<OneOrThree>(not_negative(spec), named);
  }
  static std::string allowed(const Spec& spec) {
    return Codec<OneOrThree>::allowed(not_negative(spec));
  }
};

// ---- lists and maps of any length -----------------------------------------------------------

namespace detail {

/// How many T a list of them has at most, so that it takes no memory to grow. What is larger than
/// a number is not read from numbers, the one thing of which a text has millions.
template <class T>
std::size_t places(const Value::Array& list) {
  if constexpr (sizeof(T) <= sizeof(Value)) return list.size();
  const auto may_be_one = [](const Value& each) { return each.as<double>() == nullptr; };
  return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), may_be_one));
}

}  // namespace detail

template <class T>
struct Codec<std::optional<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::optional<T>& out) {
    T value{};
    const std::size_t before = faults.count();
    read_value(v, at, spec, faults, value);
    if (faults.count() == before) out = std::move(value);
  }
  static Value write(const std::optional<T>& v) { return v ? write_value(*v) : Value(); }
  static Value schema(const Spec& spec, Definitions& named) { return schema_of<T>(spec, named); }
  static std::string allowed(const Spec& spec) { return Codec<T>::allowed(spec); }
};

template <class T>
struct Codec<std::vector<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   std::vector<T>& out) {
    const auto* list = detail::read_array(v, at, spec, faults);
    if (list == nullptr) return;
    out.clear();
    out.reserve(detail::places<T>(*list));
    for (std::size_t i = 0; i < list->size() && !faults.full(); ++i)
      read_value((*list)[i], at.at(i), spec, faults, out.emplace_back());
  }
  static Value write(const std::vector<T>& v) {
    Value::Array list;
    for (const T& each : v) {
      give_way();
      list.push_back(write_value(each));
    }
    return list;
  }
  static Value schema(const Spec& spec, Definitions& named) {
    Value::Object schema{{"type", "array"}, {"items", schema_of<T>(spec, named)}};
    if (spec.min_items > 0) schema.emplace_back("minItems", static_cast<double>(spec.min_items));
    return schema;
  }
  static std::string allowed(const Spec& spec) { return detail::array_text(spec); }
};

template <class T>
struct Codec<std::map<std::string, T>> {
  using Map = std::map<std::string, T>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, Map& out) {
    const auto* members = v.as<Value::Object>();
    if (members == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
    out.clear();
    for (const auto& [name, value] : *members) {
      if (faults.full()) return;
      if (detail::short_enough(name, at.at(name), detail::name_spec, faults))
        read_value(value, at.at(name), spec, faults, out[name]);
    }
  }
  static Value write(const Map& v) {
    Value::Object members;
    for (const auto& [name, value] : v) members.emplace_back(name, write_value(value));
    return members;
  }
  static Value schema(const Spec& spec, Definitions& named) {
    return Value::Object{{"type", "object"},
                         {"propertyNames", detail::text_schema(detail::name_spec)},
                         {"additionalProperties", schema_of<T>(spec, named)}};
  }
  static std::string allowed(const Spec&) { return "an object"; }
};

/// A name, or the thing itself.
template <class T>
struct Codec<std::variant<std::string, T>> {
  using NameOr = std::variant<std::string, T>;
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, NameOr& out) {
    if (v.as<std::string>() != nullptr) read_value(v, at, spec, faults, out.template emplace<0>());
    else if (v.as<Value::Object>() != nullptr)
      read_value(v, at, spec, faults, out.template emplace<1>());
    else detail::wrong_type(v, at, allowed(spec), faults);
  }
  static Value write(const NameOr& v) {
    return std::visit([](const auto& is) { return write_value(is); }, v);
  }
  static Value schema(const Spec& spec, Definitions& named) {
    return Value::Object{
        {"oneOf", Value::Array{schema_of<std::string>(spec, named), schema_of<T>(spec, named)}}};
  }
  static std::string allowed(const Spec&) { return "a name or an object"; }
};

}  // namespace tia
