// What of a scene's camera a request replaces.
#pragma once

#include "core/scene/camera.h"
#include "server/contract/text_form.h"

namespace tia::server {

/// CameraPatch: what replaces fields of the scene's camera, a JSON merge patch (RFC 7396).
struct CameraPatch {
  static constexpr std::string_view schema_name = "camera_patch";
  Value::Object members;
  bool operator==(const CameraPatch&) const = default;
};

}  // namespace tia::server

namespace tia {

/// Finds all that is wrong with a patch, whatever camera it is for.
template <>
struct Codec<server::CameraPatch> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   server::CameraPatch& out);
  static Value write(const server::CameraPatch& v) { return v.members; }
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec&) { return "an object of the camera's fields"; }
};
template <>
struct server::TextForm<server::CameraPatch> : server::ObjectForm {};

}  // namespace tia
