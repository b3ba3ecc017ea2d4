#include "core/input/described.h"

#include <algorithm>

namespace tia::detail {

const Value* MemberReader::member(std::string_view name) {
  known.push_back(name);
  return find(object, name);
}

void MemberReader::add_missing(std::string_view name, const Spec& spec,
                               const std::string& allowed) {
  faults.add({FaultKind::missing, at.at(name).pointer(), std::nullopt,
              std::string(spec.about) + ": " + allowed});
}

std::optional<std::size_t> MemberReader::kind(std::span<const KindType> kinds, const Spec& spec) {
  const Value* const type = member("type");
  if (type == nullptr && !spec.required) return 0;
  std::vector<std::string_view> names;
  for (const KindType& kind : kinds) names.push_back(kind.name);
  if (type == nullptr) {
    add_missing("type", spec, "one of " + listed(names));
  } else {
    const auto* word = type->as<std::string>();
    const auto found = word != nullptr ? std::find(names.begin(), names.end(), *word) : names.end();
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    unknown_word(*type, at.at("type"), names, faults);
  }
  kind_known = false;
  return std::nullopt;
}

void MemberReader::finish() const {
  if (!kind_known) return;
  const std::size_t before = faults.count();
  for (const auto& [name, value] : object) {
    if (faults.full()) return;
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    unknown_word(Value(name), at.at(name), known, faults);
  }
  if (faults.count() == before && check_kind != nullptr) check_kind(kind_read, at, faults);
}

void ObjectSchema::add(std::string_view name, const Value& schema, const Spec& spec,
                       const std::optional<Value>& standard) {
  Value::Object property = *schema.as<Value::Object>();
  property.emplace_back("description", about_text(spec));
  if (spec.required) required.emplace_back(name);
  else if (standard) property.emplace_back("default", *standard);
  properties.emplace_back(name, std::move(property));
}

void ObjectSchema::add_kind(std::string_view type, ObjectSchema kind, bool asked_for) {
  kind.properties.emplace_back("type", Value::Object{{"const", type}});
  if (asked_for) kind.required.emplace_back("type");
  alternatives.push_back(std::move(kind));
}

void ObjectSchema::add_spelling(std::span<const std::string_view> names) {
  ObjectSchema spelling;
  for (const auto& property : properties)
    if (std::find(names.begin(), names.end(), property.first) != names.end()) {
      spelling.properties.push_back(property);
      spelling.required.emplace_back(property.first);
    }
  alternatives.push_back(std::move(spelling));
}

Value ObjectSchema::finish() const {
  Value::Array each;
  for (const ObjectSchema& alternative : alternatives) {
    ObjectSchema all = alternative;
    all.properties.insert(all.properties.end(), properties.begin(), properties.end());
    all.required.insert(all.required.end(), required.begin(), required.end());
    each.push_back(all.finish());
  }
  if (each.size() == 1) return each.front();
  if (!each.empty()) return Value::Object{{"oneOf", each}};
  Value::Object schema{
      {"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema.emplace_back("required", required);
  return schema;
}

// ---- walking the fields -----------------------------------------------------------------------

namespace {

class FieldsRead final : public FieldSink {
 public:
  explicit FieldsRead(MemberReader& from) : FieldSink(false), from_(from) {}

  void field(std::string_view name, const Spec& spec, const MemberType& type, void* value,
             const void*) override {
    if (const Value* given = from_.member(name))
      type.read(*given, from_.at.at(name), spec, from_.faults, value);
    else if (spec.required) from_.add_missing(name, spec, type.allowed(spec));
  }
  void one_of(const Spec& spec, const UnionType& type, void* variant) override {
    const auto chosen = from_.kind(type.kinds, spec);
    if (!chosen) return;
    const KindType& kind = type.kinds[*chosen];
    const std::size_t before = from_.faults.count();
    void* const owner = kind.emplace(variant);
    kind.fields->walk(*this, owner);
    if (from_.faults.count() != before) return;
    from_.check_kind = kind.fields->check;
    from_.kind_read = owner;
  }

 private:
  MemberReader& from_;
};

class FieldsWrite final : public FieldSink {
 public:
  explicit FieldsWrite(Value::Object& object) : FieldSink(true), object_(object) {}

  void field(std::string_view name, const Spec& spec, const MemberType& type, void* value,
             const void* standard) override {
    if (spec.required || !type.equal(value, standard))
      object_.emplace_back(name, type.write(value));
  }
  void one_of(const Spec& spec, const UnionType& type, void* variant) override {
    const std::size_t index = type.index(variant);
    const KindType& kind = type.kinds[index];
    if (spec.required || index != 0) object_.emplace_back("type", kind.name);
    kind.fields->walk(*this, kind.held(variant));
  }

 private:
  Value::Object& object_;
};

// Of owners by default: walked with null.
class FieldsSchema final : public FieldSink {
 public:
  FieldsSchema(ObjectSchema& schema, Definitions& named)
      : FieldSink(true), schema_(schema), named_(named) {}

  void field(std::string_view name, const Spec& spec, const MemberType& type, void*,
             const void* standard) override {
    std::optional<Value> value;
    if (!type.optional) value = type.write(standard);
    schema_.add(name, type.schema(spec, named_), spec, value);
  }
  void one_of(const Spec& spec, const UnionType& type, void*) override {
    for (const KindType& kind : type.kinds)
      schema_.add_kind(kind.name, fields_schema(*kind.fields, named_),
                       spec.required || &kind != type.kinds.data());
  }

 private:
  ObjectSchema& schema_;
  Definitions& named_;
};

}  // namespace

void read_fields(const OwnerType& type, const Value& v, const Place& at, Faults& faults,
                 void* owner) {
  const auto* object = v.as<Value::Object>();
  if (object == nullptr) return wrong_type(v, at, "an object", faults);
  const std::size_t before = faults.count();
  MemberReader from{*object, at, faults};
  FieldsRead reader(from);
  type.walk(reader, owner);
  from.finish();
  if (type.check != nullptr && faults.count() == before) type.check(owner, at, faults);
  if (type.check_links != nullptr) type.check_links(owner, at, faults);
}

Value write_fields(const OwnerType& type, const void* owner) {
  Value::Object object;
  FieldsWrite writer(object);
  type.walk(writer, const_cast<void*>(owner));  // which the writer only looks at
  return object;
}

ObjectSchema fields_schema(const OwnerType& type, Definitions& named) {
  ObjectSchema schema;
  FieldsSchema maker(schema, named);
  type.walk(maker, nullptr);
  return schema;
}

}  // namespace tia::detail
