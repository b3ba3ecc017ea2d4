// What may be changed of a live stream: the body of POST /streams/{id}.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "server/requests/render_context.h"
#include "server/requests/render_request.h"

namespace tia::server {

/// ScenePatch: what replaces parts of a scene, a JSON merge patch (RFC 7396).
struct ScenePatch {
  Value::Object members;
  bool operator==(const ScenePatch&) const = default;
};

}  // namespace tia::server

namespace tia {

/// What is wrong with a patch only the scene tells that it is for.
template <>
struct Codec<server::ScenePatch> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   server::ScenePatch& out);
  static Value write(const server::ScenePatch& v) { return v.members; }
  static Value schema(const Spec&, Definitions&) { return Value::Object{{"type", "object"}}; }
  static std::string allowed(const Spec&) { return "an object, a JSON merge patch of the scene"; }
};

}  // namespace tia

namespace tia::server {

/// StreamChange: parameters of /render that take the place of the stream's own, and a patch of its
/// scene as it is by then. A new parameter of that kind is a member here and a line in apply().
struct StreamChange : Moment {
  static constexpr std::string_view schema_name = "stream_change";
  std::optional<ScenePatch> scene;
  std::optional<std::string> key;
  std::optional<Vec3d> light;
  std::optional<CameraPatch> camera;
  std::optional<std::array<double, 2>> gaze;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using C = StreamChange;
    visit("scene", &C::scene,
          Spec{.about = "a JSON merge patch (RFC 7396) of the scene as the stream has it"});
    visit("key", &C::key, Spec{.about = "as of /render; in place of light, too"});
    visit("light", &C::light,
          Spec{.about = "as of /render; in place of key, too", .min = -1e9, .max = 1e9});
    visit(
        "camera", &C::camera,
        Spec{.about = "as of /render: what replaces fields of the scene's own camera, and nothing "
                      "of what was said before"});
    visit("gaze", &C::gaze,
          Spec{.about = "as of /render: where the eye looks",
               .unit = "pixels",
               .min = -ViewRequest::most_px,
               .max = ViewRequest::most_px});
    Moment::fields(visit);
  }
  /// key with light, time with frame.
  void check(const Place& at, Faults& faults) const;
};

/// The request after the change. Errors: InputError, of a patch at /scene; as find_scene, LongWork.
RenderRequest changed_by(const StreamChange& change, RenderRequest request,
                         const RenderContext& context, const Requester& requester);

}  // namespace tia::server
