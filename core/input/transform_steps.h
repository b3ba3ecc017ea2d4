// Where an object or a texture stands: the scene's `transform`, as it is written and as the map
// that it gives.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "core/input/codec.h"
#include "core/math/quaternion.h"

namespace tia {

struct Translate {
  static constexpr std::string_view key = "translate";
  static constexpr Spec spec{.about = "how far along x, y and z", .min = -1e9, .max = 1e9};
  Vec3d by{};
  Affine affine() const { return Affine::translation(by); }
  bool operator==(const Translate&) const = default;
};

struct RotateDegrees {
  static constexpr std::string_view key = "rotate_degrees";
  static constexpr Spec spec{
      .about = "about x, then y, then z, counter-clockwise seen from the axis' tip",
      .unit = "degrees",
      .min = -1e6,
      .max = 1e6};
  Vec3d by{};
  Affine affine() const { return Affine::rotation_degrees(by); }
  bool operator==(const RotateDegrees&) const = default;
};

struct Scale {
  static constexpr std::string_view key = "scale";
  static constexpr Spec spec{
      .about = "factors of x, y and z", .min = -1e9, .max = 1e9, .not_zero = true};
  std::variant<double, Vec3d> by = 1.0;
  Affine affine() const;
  bool operator==(const Scale&) const = default;
};

/// MatrixRows: column vectors, last row 0 0 0 1.
struct MatrixRows {
  std::array<std::array<double, 4>, 4> row{};
  bool operator==(const MatrixRows&) const = default;
};

struct Matrix {
  static constexpr std::string_view key = "matrix";
  static constexpr Spec spec{
      .about = "four rows of four for column vectors, the last 0 0 0 1", .min = -1e9, .max = 1e9};
  MatrixRows by{};
  Affine affine() const;
  bool operator==(const Matrix&) const = default;
};

struct RotateQuaternion {
  static constexpr std::string_view key = "rotate_quaternion";
  static constexpr Spec spec{.about =
                                 "x, y, z, w of a quaternion of any length but 0: an axis "
                                 "times the sine of half the angle, and its cosine",
                             .min = -1e9,
                             .max = 1e9};
  Quaternion by{0, 0, 0, 1};
  Affine affine() const { return rotation_of(by); }
  bool operator==(const RotateQuaternion&) const = default;
};

/// TransformSteps: steps that move a shape, the first step first. They are kept as written, so that
/// canonical text repeats them.
struct TransformSteps {
  static constexpr std::string_view schema_name = "transform";
  using Step = std::variant<Translate, RotateDegrees, Scale, Matrix, RotateQuaternion>;
  std::vector<Step> steps;

  /// The product of all steps. Once read, it has an inverse.
  Affine affine() const;
  bool operator==(const TransformSteps&) const = default;
};

/// Whether a map can be computed with: it scales every axis by 1e-9 to 1e9, and the unit cube
/// keeps at least 1e-12 of the volume of a box with edges of those lengths.
bool is_usable(const Affine& map);

template <>
struct Codec<TransformSteps> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   TransformSteps& out);
  static Value write(const TransformSteps& v);
  static Value schema(const Spec&, Definitions& named);
  static std::string allowed(const Spec&);
};

}  // namespace tia
