// A model, a file of another program, as an object of a scene. Which file that is and what is in
// it is not known here: the objects that it stands for are made of it later, in a step of their own
// (core/scene/resolve_models.h).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/vec3.h"

namespace tia {

struct Object;

/// UpAxis: which of a model's axes points up. The scene's is y.
enum class UpAxis { y, z, minus_y, minus_z, x, minus_x };
template <>
struct Names<UpAxis> {
  static constexpr std::array<std::string_view, 6> names{"y", "z", "-y", "-z", "x", "-x"};
};

/// Fit: the box that a model fills, scaled alike in all directions until its own box first touches
/// two opposite sides. Space/units: the object's own space, before its transform.
struct Fit {
  Vec3d min{}, max{};
  Vec3d align{0.5, 0.5, 0.5};  ///< where in it the model stands on the other axes

  template <class Visitor>
  static void fields(Visitor&& visit) {
    constexpr double far = 1e9;
    visit("min", &Fit::min,
          Spec{.about = "the box' lowest corner", .min = -far, .max = far, .required = true});
    visit("max", &Fit::max,
          Spec{.about = "the box' highest corner", .min = -far, .max = far, .required = true});
    visit("align", &Fit::align,
          Spec{.about = "where in the box the model stands along x, y and z: 0 at its lowest "
                        "side, 1 at its highest",
               .min = 0,
               .max = 1});
  }
  /// A box without an inside.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Fit&) const = default;
};

/// PlacedModel. Its materials by name are its object's `materials`.
struct PlacedModel {
  static constexpr std::string_view type = "model";
  static constexpr bool one_object = false;
  std::string id;
  std::optional<int> scene;
  std::optional<UpAxis> up;
  std::optional<Fit> fit;
  std::optional<double> time;
  std::optional<int> animation;
  std::optional<std::string> variant;
  std::vector<std::string> hide;
  std::optional<double> point_radius;
  double ambient = 0;
  double smooth = 0;  ///< degrees
  bool culling = true;

  /// What it stands for; null until that is resolved. Copies share it. No part of the JSON, and
  /// none of what is compared: it follows from the rest.
  std::shared_ptr<const std::vector<Object>> shown{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using M = PlacedModel;
    constexpr double most = 1e9;
    visit("id", &M::id,
          Spec{.about = "the model's: the SHA-256 of its file as 64 hex digits, or its name",
               .required = true,
               .max_bytes = longest_name});
    visit("scene", &M::scene,
          Spec{.about = "which of its scenes, from 0 on; else its own choice", .min = 0});
    visit("up", &M::up,
          Spec{.about = "which of its axes points up and is turned to y: z turns (x, y, z) to (x, "
                        "z, -y); else its format's, z for STL and PLY, y for others"});
    visit("fit", &M::fit,
          Spec{.about = "the box that it fills, scaled alike in all directions until its own box "
                        "first does; else it is as large as its file says"});
    visit("time", &M::time,
          Spec{.about = "when in its animation; else 0", .unit = "seconds", .min = 0, .max = most});
    visit("animation", &M::animation,
          Spec{.about = "which of its animations, from 0 on; else the first where time is given, "
                        "and none where it is not",
               .min = 0});
    visit("variant", &M::variant,
          Spec{.about = "the name of one of its variants; else the materials that it has without",
               .max_bytes = longest_name});
    visit("hide", &M::hide,
          Spec{.about = "names of nodes, meshes and materials that are not shown, of nodes with "
                        "all below them",
               .max_bytes = longest_name});
    visit("point_radius", &M::point_radius,
          Spec{.about = "how large the balls are that its points are; else 1/500 of the diagonal "
                        "of its box",
               .min = 0,
               .max = most,
               .open_min = true});
    visit("ambient", &M::ambient,
          Spec{.about = "share of the scene's ambient_light that its own materials send back, by "
                        "whitted",
               .min = 0,
               .max = 1});
    visit("smooth", &M::smooth,
          Spec{.about = "where its file has no normals: faces that meet at an edge at less than "
                        "this angle share one",
               .unit = "degrees",
               .min = 0,
               .max = 180});
    visit(
        "culling", &M::culling,
        Spec{.about = "whether rays of the camera, of mirrors and of glass pass the back faces of "
                      "materials that are not double_sided"});
  }
  /// Of what is written.
  bool operator==(const PlacedModel& other) const;
};

/// The objects that it stands for; none until that is resolved.
const std::vector<Object>& children_in(const PlacedModel& model);

}  // namespace tia
