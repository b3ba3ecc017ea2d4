#include "core/scene/animation_fields.h"

namespace tia {
namespace {

/// Visitor.
struct MovableFields {
  std::vector<std::string_view> names = {};
  template <class Member>
  void operator()(std::string_view name, Member Scene::*, const Spec&) {
    if (name != "animation" && name != "physics" && name != "keys") names.push_back(name);
  }
};

/// Visitor.
struct FieldsWritten {
  const Scene& scene;
  const SceneFields& names;
  Value::Object written = {};
  Scene usual = {};

  template <class Member>
  void operator()(std::string_view name, Member Scene::*member, const Spec&) {
    if (!names.contains(name) || scene.*member == usual.*member) return;
    written.emplace_back(name, write_value(scene.*member));
  }
};

/// Visitor.
struct FieldsRead {
  const Value::Object& written;
  const SceneFields& names;
  Faults& faults;
  Scene& scene;

  template <class Member>
  void operator()(std::string_view name, Member Scene::*member, const Spec& spec) {
    if (!names.contains(name)) return;
    scene.*member = Member{};
    const Place all{};
    if (const Value* value = find(written, name))
      read_value(*value, all.at(name), spec, faults, scene.*member);
  }
};

}  // namespace

std::vector<std::string_view> movable_fields() {
  MovableFields fields;
  Scene::fields(fields);
  return fields.names;
}

Value::Object written_fields(const Scene& scene, const SceneFields& names) {
  FieldsWritten writer{scene, names};
  Scene::fields(writer);
  return std::move(writer.written);
}

void read_fields(const Value::Object& written, const SceneFields& names, Faults& faults,
                 Scene& scene) {
  Scene::fields(FieldsRead{written, names, faults, scene});
}

}  // namespace tia
