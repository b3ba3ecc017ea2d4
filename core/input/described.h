// Codec of described structs: one reads, one writes, one makes the schema of whatever T::fields
// names; what does not depend on T is in the .cpp.
#pragma once

#include <span>
#include <utility>

#include "core/input/field_walk.h"

namespace tia {

/// Spelled: a described type that has several spellings: `spellings` has the names of the fields of
/// each, of which an object gives one whole and no other. Its check must see to that.
template <class T>
concept Spelled = requires {
  T::spellings;
};

namespace detail {

/// MemberReader: the members of one JSON object and which of them are known.
struct MemberReader {
  const Value::Object& object;
  const Place& at;
  Faults& faults;
  std::vector<std::string_view> known = {};
  bool kind_known = true;
  CheckOf check_kind = nullptr;  ///< none where the kind has none or is not right
  void* kind_read = nullptr;

  /// The member of that name, known from now on; null where there is none.
  const Value* member(std::string_view name);
  void add_missing(std::string_view name, const Spec& spec, const std::string& allowed);
  /// Which of the kinds the key `type` picks, the first where none is asked for; or a fault.
  std::optional<std::size_t> kind(std::span<const KindType> kinds, const Spec& spec);
  /// Faults of members that are not known, else those of the kind's own check. Where the kind is
  /// unknown it cannot be told which members belong.
  void finish() const;
};

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

/// Reads the members of a JSON object into an owner and, for a tagged kind, into its alternative;
/// then checks them.
void read_fields(const OwnerType& type, const Value& v, const Place& at, Faults& faults,
                 void* owner);
/// Writes an owner's fields, leaving out those that equal a default-constructed owner's.
Value write_fields(const OwnerType& type, const void* owner);
ObjectSchema fields_schema(const OwnerType& type, Definitions& named);

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
void FieldsCodec<T>::read(const Value& v, const Place& at, const Spec&, Faults& faults, T& out) {
  detail::read_fields(detail::owner_type<T>, v, at, faults, &out);
}

template <class T>
Value FieldsCodec<T>::write(const T& v) {
  return detail::write_fields(detail::owner_type<T>, &v);
}

template <class T>
Value FieldsCodec<T>::schema(const Spec&, Definitions& named) {
  detail::ObjectSchema schema = detail::fields_schema(detail::owner_type<T>, named);
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
