#include "server/requests/camera_patch.h"

#include "core/input/object_schema.h"

namespace tia {
namespace {

/// Visitor: reads those of the camera's fields that a patch replaces whole.
struct PatchReader {
  detail::MemberReader& from;
  Camera out{};
  template <class Member>
  void operator()(std::string_view name, Member Camera::*member, const Spec& spec) {
    const Value* value = from.member(name);
    if (value == nullptr || value->as<std::nullptr_t>() != nullptr) return;
    if (value->as<Value::Object>() != nullptr) return;  // a patch of what the camera has there
    read_value(*value, from.at.at(name), spec, from.faults, out.*member);
  }
};

// The schema of a merge patch of what obeys `schema`: all may be left out, null removes. Inside of
// a member null may also remove what is not known.
Value patch_schema(const Value& schema, bool inside = false) {
  Value::Object patch;
  for (const auto& [word, is] : *schema.as<Value::Object>()) {
    if (word == "required" || word == "default") continue;
    Value means = is;
    if (word == "properties")
      for (auto& [name, property] : *means.as<Value::Object>())
        property = nullable_schema(patch_schema(property, true));
    if (word == "additionalProperties" && inside) means = Value::Object{{"type", "null"}};
    patch.emplace_back(word, std::move(means));
  }
  return patch;
}

}  // namespace

Value Codec<server::CameraPatch>::schema(const Spec& spec, Definitions& named) {
  return patch_schema(Codec<Camera>::schema(spec, named));
}

void Codec<server::CameraPatch>::read(const Value& v, const Place& at, const Spec& spec,
                                      Faults& faults, server::CameraPatch& out) {
  const auto* members = v.as<Value::Object>();
  if (members == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
  detail::MemberReader from{*members, at, faults};
  PatchReader reader{from};
  Camera::fields(reader);
  from.finish();
  out.members = *members;
}

}  // namespace tia
