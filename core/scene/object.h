// Object: a shape with its place and its material. Groups and solids hold objects again.
#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/input/boxed.h"
#include "core/input/codec.h"
#include "core/input/transform_steps.h"
#include "core/materials/material.h"
#include "core/shapes/shape.h"

namespace tia {

/// The name of one of the scene's materials, or a material of its own.
using MaterialRef = std::variant<std::string, Boxed<Material>>;

/// ObjectMaterials: several of one object: those that its shape's own numbers mean, from 1 on, or
/// those that stand for others of these names. In JSON an array or an object.
using ObjectMaterials =
    std::variant<std::vector<MaterialRef>, Boxed<std::map<std::string, MaterialRef>>>;
template <>
struct Codec<ObjectMaterials> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   ObjectMaterials& out);
  static Value write(const ObjectMaterials& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

struct Object {
  static constexpr std::string_view schema_name = "object";
  std::string name;
  Shape shape;
  TransformSteps transform;
  std::optional<MaterialRef> material;
  ObjectMaterials materials{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("name", &Object::name,
          Spec{.about = "what answers call it, in at most 256 bytes", .max_bytes = longest_name});
    visit.one_of(&Object::shape, Spec{.about = "the kind of shape", .required = true});
    visit("transform", &Object::transform,
          Spec{.about = "steps that place it, the first step first"});
    visit("material", &Object::material,
          Spec{.about = "a name from materials, or a material; else its nearest ancestor's",
               .max_bytes = longest_name});
    visit("materials", &Object::materials,
          Spec{.about =
                   "of voxels an array of those that their numbers mean, number 1 the first; of a "
                   "model an object of those that replace its own of these names; each a name "
                   "or a material"});
  }
  /// Numbers beyond `materials`; materials of a shape that has no numbers, or no names.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Object&) const;
};
extern template struct FieldsCodec<Object>;

/// Its materials by number, and by name.
const std::vector<MaterialRef>& numbered_materials(const Object& object);
const std::map<std::string, MaterialRef>& named_materials(const Object& object);

/// The children of a composite, or null.
const std::vector<Object>* children_of(const Object& object);
/// Whether its children are objects of their own, as a group's and a model's are and a solid's are
/// not.
bool is_many(const Object& object);
/// Whether its children follow from what is written and are not in the JSON, as a model's and those
/// of walls.
bool is_lowered(const Object& object);

/// Whether a shape has an inside of its own, so that it can be an operand of CSG. (A group is none;
/// its children may be.)
bool is_solid(const Shape& shape);
/// Whether a luminous one is a light.
bool lights_from_center(const Shape& shape);
/// The kinds that have an inside, as words: "sphere, plane, ".
std::string solid_names();

/// A box around an object in its parent's space; infinite where the object is, empty where there
/// is nothing of it. Domain: an object that was read without a fault.
/// Cost: of a surface whose form tells its box, making that form: milliseconds. Errors: Stopped.
Aabb bounds_of(const Object& object, const std::stop_token& stop = {});

/// ObjectBounds: the same of many objects, those of composites found once, however often they and
/// the groups around them are asked for. Domain: objects that outlive it.
class ObjectBounds {
 public:
  explicit ObjectBounds(std::stop_token stop = {}) : stop_(std::move(stop)) {}
  Aabb of(const Object& object);
  Aabb of(const Csg& csg);
  Aabb of(const Group& group);
  Aabb of(const PlacedModel& model);
  Aabb of(const Walls& walls) { return of(children_in(walls)); }

 private:
  Aabb of(const std::vector<Object>& list);
  std::stop_token stop_;
  std::unordered_map<const void*, Aabb> known_;  // by composite, in its own space
};

}  // namespace tia
