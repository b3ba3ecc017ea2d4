// Codec of described structs: three visitors that walk T::fields, one that reads, one that writes,
// one that makes the schema; what does not depend on T is in the .cpp.
#pragma once

#include <functional>
#include <span>
#include <utility>

#include "core/input/value_codecs.h"

namespace tia {

/// Checks that concern several fields: a described type may have
/// `void check(const Place&, Faults&) const`, called when all that it holds is right. So may a kind
/// of a tagged union.
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

template <class T>
class Boxed;

/// Spelled: a described type that has several spellings: `spellings` has the names of the fields of
/// each, of which an object gives one whole and no other. Its check must see to that.
template <class T>
concept Spelled = requires {
  T::spellings;
};

namespace detail {

// A list may hold a kind that is larger than most in a Boxed: what it is stays the kind.
template <class Held>
struct KindIn {
  using Kind = Held;
};
template <class T>
struct KindIn<Boxed<T>> {
  using Kind = T;
};
template <class Held>
using KindOf = typename KindIn<Held>::Kind;
template <class Held>
auto& unboxed(Held& held) {
  if constexpr (std::is_same_v<KindOf<std::remove_const_t<Held>>, std::remove_const_t<Held>>)
    return held;
  else return *held;
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// The `type` names of a variant's alternatives, in the list's order.
template <class... Kinds>
std::vector<std::string_view> type_names(const std::variant<Kinds...>*) {
  return {KindOf<Kinds>::type...};
}

/// Calls f(std::in_place_type<Kind>) for the i-th kind of the list, as it is held.
template <class... Kinds, class F>
void with_kind(const std::variant<Kinds...>*, std::size_t i, F f) {
  std::size_t at = 0;
  ((at++ == i ? f(std::in_place_type<Kinds>) : void()), ...);
}

// ---- reading --------------------------------------------------------------------------------

/// MemberReader: the members of one JSON object and which of them are known.
struct MemberReader {
  const Value::Object& object;
  const Place& at;
  Faults& faults;
  std::vector<std::string_view> known = {};
  bool kind_known = true;
  std::function<void()> check_kind = {};  ///< none where the kind has none or is not right

  /// The member of that name, known from now on; null where there is none.
  const Value* member(std::string_view name);
  void add_missing(std::string_view name, const Spec& spec, const std::string& allowed);
  /// Which of the kinds the key `type` picks, the first where none is asked for; or a fault.
  std::optional<std::size_t> kind(const std::vector<std::string_view>& names, const Spec& spec);
  /// Faults of members that are not known, else those of the kind's own check. Where the kind is
  /// unknown it cannot be told which members belong.
  void finish() const;
};

/// Reads the members of one JSON object into an Owner and, for a tagged kind, into its alternative.
template <class Owner>
class FieldReader {
 public:
  FieldReader(MemberReader& from, Owner& out) : from_(from), out_(out) {}

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) {
    if (const Value* value = from_.member(name))
      read_value(*value, from_.at.at(name), spec, from_.faults, out_.*member);
    else if (spec.required) from_.add_missing(name, spec, Codec<Member>::allowed(spec));
  }

  /// The key `type` picks the alternative, whose fields stand in the same object.
  template <class Base, class Variant>
  void one_of(Variant Base::*member, const Spec& spec) {
    Variant& variant = out_.*member;
    const auto chosen = from_.kind(type_names(&variant), spec);
    if (!chosen) return;
    with_kind(&variant, *chosen, [&]<class Held>(std::in_place_type_t<Held>) {
      using Kind = KindOf<Held>;
      [[maybe_unused]] const std::size_t before = from_.faults.count();
      Kind& kind = unboxed(variant.template emplace<Held>());
      Kind::fields(FieldReader<Kind>(from_, kind));
      if constexpr (Checked<Kind>)
        if (from_.faults.count() == before)
          from_.check_kind = [&kind, &from = from_] { kind.check(from.at, from.faults); };
    });
  }

 private:
  MemberReader& from_;
  Owner& out_;
};

// ---- writing --------------------------------------------------------------------------------

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
        [&]<class Held>(const Held& held) {
          KindOf<Held>::fields(FieldWriter<KindOf<Held>>(unboxed(held), object_));
        },
        variant);
  }

 private:
  const Owner& from_;
  Value::Object& object_;
  Owner default_{};
};

// ---- schema ---------------------------------------------------------------------------------

/// ObjectSchema: JSON Schema properties; the kinds of a tagged union are alternatives.
struct ObjectSchema {
  Value::Object properties;
  Value::Array required;
  std::vector<ObjectSchema> alternatives;

  void add(std::string_view name, const Value& schema, const Spec& spec,
           const std::optional<Value>& standard);
  void add_kind(std::string_view type, ObjectSchema kind, bool asked_for);
  /// Makes an alternative of the fields of that spelling.
  void add_spelling(std::span<const std::string_view> names);
  /// One object schema, or one for each alternative with the common fields in each.
  Value finish() const;
};

template <class Owner>
class FieldSchema {
 public:
  FieldSchema(ObjectSchema& schema, Definitions& named) : schema_(schema), named_(named) {}

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) {
    std::optional<Value> standard;
    if constexpr (!is_optional<Member>) standard = write_value(Owner{}.*member);
    schema_.add(name, schema_of<Member>(spec, named_), spec, standard);
  }

  template <class Base, class Variant>
  void one_of(Variant Base::*, const Spec& spec) {
    const Variant* const list = nullptr;
    for (std::size_t i = 0; i < std::variant_size_v<Variant>; ++i) {
      with_kind(list, i, [&]<class Held>(std::in_place_type_t<Held>) {
        using Kind = KindOf<Held>;
        ObjectSchema kind;
        Kind::fields(FieldSchema<Kind>(kind, named_));
        schema_.add_kind(Kind::type, std::move(kind), spec.required || i != 0);
      });
    }
  }

 private:
  ObjectSchema& schema_;
  Definitions& named_;
};

}  // namespace detail

/// FieldsCodec: the codec of a described struct. Not inline: where a header says that a type's is
/// made elsewhere (extern template), others need not make it again; a scene's is all kinds'
/// together.
template <class T>
struct FieldsCodec {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, T& out);
  static Value write(const T& v);
  static Value schema(const Spec&, Definitions& named);
  static std::string allowed(const Spec&) { return "an object"; }
};
template <Described T>
struct Codec<T> : FieldsCodec<T> {};

template <class T>
void FieldsCodec<T>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                          T& out) {
  const auto* object = v.as<Value::Object>();
  if (object == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
  [[maybe_unused]] const std::size_t before = faults.count();
  detail::MemberReader from{*object, at, faults};
  T::fields(detail::FieldReader<T>(from, out));
  from.finish();
  if constexpr (Checked<T>)
    if (faults.count() == before) out.check(at, faults);
  if constexpr (Linked<T>) out.check_links(at, faults);
}

template <class T>
Value FieldsCodec<T>::write(const T& v) {
  Value::Object object;
  T::fields(detail::FieldWriter<T>(v, object));
  return object;
}

template <class T>
Value FieldsCodec<T>::schema(const Spec&, Definitions& named) {
  detail::ObjectSchema schema;
  T::fields(detail::FieldSchema<T>(schema, named));
  if constexpr (Spelled<T>) {
    for (const auto& spelling : T::spellings) schema.add_spelling(spelling);
    schema.properties.clear();
  }
  return schema.finish();
}

/// Reads a whole described object. Errors: InputError with all faults (up to 20); Stopped.
template <Described T>
T read_described(const Value& value, const Place& at = {}, const std::stop_token& stop = {}) {
  T out{};
  Faults faults(stop);
  read_value(value, at, Spec{}, faults, out);
  faults.raise();
  return out;
}

}  // namespace tia
