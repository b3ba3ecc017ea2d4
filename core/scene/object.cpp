#include "core/scene/object.h"

#include <cmath>

namespace tia {
namespace {

Aabb bounds_of(const Mesh& mesh) {
  Aabb box;
  const auto& p = mesh.positions.values.get();
  for (std::size_t i = 0; i + 2 < p.size(); i += 3)
    box = around(box, Vec3d{p[i], p[i + 1], p[i + 2]});
  return box;
}

}  // namespace

// Not defaulted, for what they hold is complete only here.
bool Group::operator==(const Group& other) const {
  return children == other.children && repeat == other.repeat;
}
bool Csg::operator==(const Csg& other) const {
  return operation == other.operation && children == other.children;
}

namespace {

// Calls f with each kind of the list.
template <class F>
void for_each_kind(F f) {
  const Shape* list = nullptr;
  for (std::size_t i = 0; i < std::variant_size_v<Shape>; ++i) detail::with_kind(list, i, f);
}

std::string numbered_names() {
  std::string names;
  for_each_kind([&]<class Kind>(std::in_place_type_t<Kind>) {
    if constexpr (IsNumbered<Kind>) names += (names.empty() ? "" : ", ") + std::string(Kind::type);
  });
  return names;
}

}  // namespace

void Object::check(const Place& at, Faults& faults) const {
  const std::size_t numbered = numbered_materials(*this).size();
  const std::size_t named = named_materials(*this).size();
  const auto refuse = [&](std::size_t count, const char* how, const std::string& allowed) {
    faults.add({FaultKind::conflict, at.at("materials").pointer(),
                Value(std::to_string(count) + how), "one `material`; several only of " + allowed});
  };
  if (named > 0 && !std::holds_alternative<PlacedModel>(shape))
    return refuse(named, " materials by name", "a model");
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (IsNumbered<Kind>) kind.check_materials(numbered, at, faults);
        else if (numbered > 0) refuse(numbered, " materials", numbered_names());
      },
      shape);
}

const std::vector<MaterialRef>& numbered_materials(const Object& object) {
  static const std::vector<MaterialRef> none;
  const auto* list = std::get_if<std::vector<MaterialRef>>(&object.materials);
  return list != nullptr ? *list : none;
}
const std::map<std::string, MaterialRef>& named_materials(const Object& object) {
  static const std::map<std::string, MaterialRef> none;
  const auto* list = std::get_if<1>(&object.materials);
  return list != nullptr ? **list : none;
}

const std::vector<Object>& children_in(const PlacedModel& model) {
  static const std::vector<Object> none;
  return model.shown ? *model.shown : none;
}

const std::vector<Object>* children_of(const Object& object) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> const std::vector<Object>* {
        if constexpr (IsComposite<Kind>) return &children_in(kind);
        else return nullptr;
      },
      object.shape);
}

bool is_many(const Object& object) {
  return std::visit(
      []<class Kind>(const Kind&) {
        if constexpr (IsComposite<Kind>) return !Kind::one_object;
        else return false;
      },
      object.shape);
}

bool is_lowered(const Object& object) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        return requires { kind.shown; };
      },
      object.shape);
}

bool is_solid(const Shape& shape) {
  return std::visit(
      []<class Kind>(const Kind&) {
        if constexpr (IsSurface<Kind>) return FormOf<Kind>::solid;
        else if constexpr (IsComposite<Kind>) return Kind::one_object;
        else return false;
      },
      shape);
}

bool lights_from_center(const Shape& shape) {
  return std::visit(
      []<class Kind>(const Kind&) {
        if constexpr (IsSurface<Kind>) return LightsFromCenter<FormOf<Kind>>;
        else return false;
      },
      shape);
}

std::string solid_names() {
  std::string names;
  for_each_kind([&]<class Kind>(std::in_place_type_t<Kind>) {
    if (is_solid(Kind{})) names += std::string(Kind::type) + ", ";
  });
  return names;
}

Aabb ObjectBounds::of(const Csg& csg) {
  const auto known = known_.find(&csg);
  if (known != known_.end()) return known->second;
  Aabb box = of(csg.children.front());
  for (std::size_t i = 1; i < csg.children.size() && csg.operation != Operation::difference; ++i) {
    const Aabb child = of(csg.children[i]);
    box = csg.operation == Operation::union_ ? around(box, child) : common(box, child);
  }
  return known_[&csg] = box.empty() ? Aabb{} : box;
}

Aabb ObjectBounds::of(const std::vector<Object>& list) {
  Aabb box;
  for (const Object& each : list) box = around(box, of(each));
  return box;
}

Aabb ObjectBounds::of(const Group& group) {
  const auto known = known_.find(&group);
  if (known != known_.end()) return known->second;
  const Aabb box = of(group.children);
  return known_[&group] = group.repeat ? group.repeat->swept(box) : box;
}

Aabb ObjectBounds::of(const PlacedModel& model) {
  const auto known = known_.find(&model);
  if (known != known_.end()) return known->second;
  return known_[&model] = of(children_in(model));
}

Aabb ObjectBounds::of(const Object& object) {
  end_if_asked(stop_);
  const Aabb box = std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (TellsBounds<Kind>) return bounds(kind);  // with less than a form
        else if constexpr (IsSurface<Kind>) return bounds(prepare(kind));
        else if constexpr (IsComposite<Kind>) return of(kind);
        else return bounds_of(kind);
      },
      object.shape);
  return bounds_of(object.transform.affine(), box);
}

Aabb bounds_of(const Object& object, const std::stop_token& stop) {
  return ObjectBounds(stop).of(object);
}

// ---- JSON -----------------------------------------------------------------------------------

namespace {

using NumberedMaterials = std::vector<MaterialRef>;
using NamedMaterials = std::map<std::string, MaterialRef>;

}  // namespace

// Without any it is as by default, however that is written.
void Codec<ObjectMaterials>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                                  ObjectMaterials& out) {
  if (v.as<Value::Array>() != nullptr)
    return read_value(v, at, spec, faults, out.emplace<NumberedMaterials>());
  if (v.as<Value::Object>() == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
  NamedMaterials named;
  read_value(v, at, spec, faults, named);
  if (!named.empty()) out = std::move(named);
}
Value Codec<ObjectMaterials>::write(const ObjectMaterials& v) {
  return std::visit([](const auto& is) { return write_value(is); }, v);
}
Value Codec<ObjectMaterials>::schema(const Spec& spec, Definitions& named) {
  return Value::Object{{"oneOf", Value::Array{schema_of<NumberedMaterials>(spec, named),
                                              schema_of<NamedMaterials>(spec, named)}}};
}
std::string Codec<ObjectMaterials>::allowed(const Spec&) { return "an array or an object"; }

template struct FieldsCodec<Object>;
bool Object::operator==(const Object&) const = default;

}  // namespace tia
