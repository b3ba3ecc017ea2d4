// Codec of described structs: three visitors that walk T::fields, one that reads, one that writes,
// one that makes the schema. Included by codec.h, for all of them name each other.
#pragma once

#include <algorithm>
#include <utility>

#include "core/input/codec.h"

namespace tia {
namespace detail {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// The `type` names of a variant's alternatives, in the list's order.
template <class... Kinds>
std::vector<std::string_view> type_names(const std::variant<Kinds...>*) {
  return {Kinds::type...};
}

/// Calls f(std::in_place_type<Kind>) for the i-th kind of the list.
template <class... Kinds, class F>
void with_kind(const std::variant<Kinds...>*, std::size_t i, F f) {
  std::size_t at = 0;
  ((at++ == i ? f(std::in_place_type<Kinds>) : void()), ...);
}

/// Reads the members of one JSON object into an Owner and, for a tagged kind, into its alternative.
template <class Owner>
class FieldReader {
 public:
  FieldReader(const Value::Object& object, const Place& at, Faults& faults, Owner& out,
              std::vector<std::string_view>& known)
      : object_(object), at_(at), faults_(faults), out_(out), known_(known) {}

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) {
    known_.push_back(name);
    if (const Value* value = find(object_, name))
      read_value(*value, at_.at(name), spec, faults_, out_.*member);
    else if (spec.required)
      faults_.add({FaultKind::missing, at_.at(name).pointer(), std::nullopt, spec.about});
  }

  /// The key `type` picks the alternative, whose fields stand in the same object.
  template <class Base, class Variant>
  void one_of(Variant Base::*member, const Spec& spec) {
    known_.push_back("type");
    Variant& variant = out_.*member;
    const auto names = type_names(&variant);
    const Value* type = find(object_, "type");
    std::size_t chosen = 0;  // the first of the list where no type is asked for
    if (type != nullptr) {
      const auto* text = type->template as<std::string>();
      if (text == nullptr) return refuse(*type, FaultKind::wrong_type, names, "");
      const auto found = std::find(names.begin(), names.end(), *text);
      if (found == names.end())
        return refuse(*type, FaultKind::unknown_name, names, nearest_name(*text, names));
      chosen = static_cast<std::size_t>(found - names.begin());
    } else if (spec.required) {
      type_known_ = false;
      return faults_.add(
          {FaultKind::missing, at_.at("type").pointer(), std::nullopt, "one of " + listed(names)});
    }
    with_kind(&variant, chosen, [&]<class Kind>(std::in_place_type_t<Kind>) {
      auto& kind = variant.template emplace<Kind>();
      Kind::fields(FieldReader<Kind>(object_, at_, faults_, kind, known_));
    });
  }

  /// Without a type it cannot be told which fields belong.
  void refuse_unknown_members() const {
    if (!type_known_) return;
    for (const auto& [name, value] : object_) {
      if (faults_.full()) return;
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      faults_.add({FaultKind::unknown_name, at_.at(name).pointer(), Value(name),
                   "one of " + listed(known_), nearest_name(name, known_)});
    }
  }

 private:
  void refuse(const Value& type, FaultKind kind, const std::vector<std::string_view>& names,
              std::string nearest) {
    type_known_ = false;
    faults_.add(
        {kind, at_.at("type").pointer(), type, "one of " + listed(names), std::move(nearest)});
  }

  const Value::Object& object_;
  const Place& at_;
  Faults& faults_;
  Owner& out_;
  std::vector<std::string_view>& known_;
  bool type_known_ = true;
};

/// Writes an Owner's fields, leaving out those that equal a default-constructed Owner's.
template <class Owner>
class FieldWriter {
 public:
  FieldWriter(const Owner& from, Value::Object& object) : from_(from), object_(object) {}

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) {
    const Member& value = from_.*member;
    if (spec.required || !(value == default_.*member))
      object_.emplace_back(name, write_value(value));
  }

  template <class Base, class Variant>
  void one_of(Variant Base::*member, const Spec& spec) {
    const Variant& variant = from_.*member;
    if (spec.required || variant.index() != 0)
      object_.emplace_back("type", type_names(&variant)[variant.index()]);
    std::visit(
        [&]<class Kind>(const Kind& kind) { Kind::fields(FieldWriter<Kind>(kind, object_)); },
        variant);
  }

 private:
  const Owner& from_;
  Value::Object& object_;
  Owner default_{};
};

/// Collects JSON Schema properties; the kinds of a tagged union become alternatives.
template <class Owner>
class FieldSchema {
 public:
  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) {
    Value::Object property = *Codec<Member>::schema(spec).template as<Value::Object>();
    std::string about = spec.about;
    if (*spec.unit != '\0') about += std::string(", in ") + spec.unit;
    property.emplace_back("description", about);
    if (spec.required) required.emplace_back(name);
    else if constexpr (!is_optional<Member>)
      property.emplace_back("default", write_value(Owner{}.*member));
    properties.emplace_back(name, std::move(property));
  }

  template <class Base, class Variant>
  void one_of(Variant Base::*, const Spec& spec) {
    const Variant* const list = nullptr;
    for (std::size_t i = 0; i < std::variant_size_v<Variant>; ++i) {
      with_kind(list, i, [&]<class Kind>(std::in_place_type_t<Kind>) {
        FieldSchema<Kind> kind;
        Kind::fields(kind);
        kind.properties.emplace_back("type", Value::Object{{"const", Kind::type}});
        if (spec.required || i != 0) kind.required.emplace_back("type");
        alternatives.push_back(std::move(kind.properties));
        alternatives_required.push_back(std::move(kind.required));
      });
    }
  }

  /// One object schema, or one for each alternative with the common fields in each.
  Value finish() const {
    if (alternatives.empty()) return object_schema(properties, required);
    Value::Array each;
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      Value::Object all = alternatives[i];
      Value::Array needs = alternatives_required[i];
      all.insert(all.end(), properties.begin(), properties.end());
      needs.insert(needs.end(), required.begin(), required.end());
      each.push_back(object_schema(std::move(all), std::move(needs)));
    }
    return each.size() == 1 ? each.front() : Value::Object{{"oneOf", each}};
  }

  Value::Object properties;
  Value::Array required;
  std::vector<Value::Object> alternatives;
  std::vector<Value::Array> alternatives_required;

 private:
  static Value object_schema(Value::Object properties, Value::Array required) {
    Value::Object schema{
        {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) schema.emplace_back("required", std::move(required));
    return schema;
  }
};

}  // namespace detail

/// Checks that concern several fields: a described type may have
/// `void check(const Place&, Faults&) const`, called when all that it holds is right.
template <class T>
concept Checked = requires(const T& t, const Place& at, Faults& faults) {
  t.check(at, faults);
};

/// Checks of what one part says of another: a described type may have
/// `void check_links(const Place&, Faults&) const`, called whatever else is wrong. What could not
/// be read is as it is by default, and has its fault.
template <class T>
concept Linked = requires(const T& t, const Place& at, Faults& faults) {
  t.check_links(at, faults);
};

template <Described T>
struct Codec<T> {
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, T& out) {
    const auto* object = v.as<Value::Object>();
    if (object == nullptr) return detail::wrong_type(v, at, "an object", faults);
    const std::size_t before = faults.list().size();
    std::vector<std::string_view> known;
    detail::FieldReader<T> reader(*object, at, faults, out, known);
    T::fields(reader);
    reader.refuse_unknown_members();
    if constexpr (Checked<T>)
      if (faults.list().size() == before) out.check(at, faults);
    if constexpr (Linked<T>) out.check_links(at, faults);
  }
  static Value write(const T& v) {
    Value::Object object;
    T::fields(detail::FieldWriter<T>(v, object));
    return object;
  }
  static Value schema(const Spec&) {
    detail::FieldSchema<T> schema;
    T::fields(schema);
    return schema.finish();
  }
};

/// Reads a whole described object. Errors: InputError with all faults (up to 20).
template <Described T>
T read_described(const Value& value, const Place& at = {}) {
  T out{};
  Faults faults;
  read_value(value, at, Spec{}, faults, out);
  faults.raise();
  return out;
}

}  // namespace tia
