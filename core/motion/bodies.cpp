#include "core/motion/bodies.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/motion/body_tracks.h"
#include "core/motion/similarity.h"

namespace tia {
namespace {

// Whether lengths and angles stay, mirrored or not, to 1e-9.
bool keeps_lengths(const Affine& map) {
  const auto scale = similarity_of(map);
  return scale && std::abs(*scale - 1) <= 1e-9;
}

/// ObjectFinder: all objects of a scene that are objects of their own, by name and by pointer.
class ObjectFinder {
 public:
  explicit ObjectFinder(const Scene& scene, const Faults& faults) : faults_(faults) {
    collect(scene.objects.get(), {{"objects"}, {}, true, true});
  }

  /// The object, or null and a fault.
  const PlacedObject* find(const std::string& called, const Place& at, Faults& faults) const {
    const auto number = called.starts_with('/') ? by_pointer_.find(called) : by_name_.find(called);
    const bool found = number != (called.starts_with('/') ? by_pointer_ : by_name_).end();
    if (found && number->second != several) return &all_[number->second];
    if (found)
      faults.add({FaultKind::conflict, at.pointer(), Value(called),
                  "a name that one object alone has, or its JSON Pointer"});
    else
      faults.add({FaultKind::unknown_name, at.pointer(), Value(called),
                  "an object's name or JSON Pointer" + known(), nearest_name(called, names())});
    return nullptr;
  }

 private:
  static constexpr std::size_t several = std::numeric_limits<std::size_t>::max();
  struct Above {
    TargetPath path;
    Affine place{};
    bool free = true, alone = true;
  };

  void collect(const std::vector<Object>& list, const Above& above) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i % 4096 == 0) end_if_asked(faults_.stop());
      const Object& object = list[i];
      TargetPath path = above.path;
      path.push_back(std::to_string(i));
      add({&object, path, above.place, above.free, above.alone});
      const auto* group = std::get_if<Group>(&object.shape);
      if (group == nullptr) continue;
      path.emplace_back("children");
      const Affine own = object.transform.affine();
      collect(group->children, {std::move(path), above.place * own,
                                above.free && keeps_lengths(own), above.alone && !group->repeat});
    }
  }
  void add(PlacedObject object) {
    const std::size_t number = all_.size();
    by_pointer_.emplace(pointer_of(object.path), number);
    const std::string& name = object.object->name;
    if (!name.empty() && !by_name_.emplace(name, number).second) by_name_[name] = several;
    all_.push_back(std::move(object));
  }
  std::vector<std::string_view> names() const {
    std::vector<std::string_view> list;
    for (const PlacedObject& each : all_)
      if (!each.object->name.empty()) list.push_back(each.object->name);
    return list;
  }
  std::string known() const {
    const auto list = names();
    return list.empty() ? "; no object has a name" : ": one of " + listed(list);
  }

  const Faults& faults_;
  std::vector<PlacedObject> all_;
  std::unordered_map<std::string, std::size_t> by_name_, by_pointer_;
};

/// BodyFinder: the rows of physics one by one.
class BodyFinder {
 public:
  BodyFinder(const Scene& scene, const Place& at, Faults& faults)
      : physics_(*scene.physics),
        at_(at),
        faults_(faults),
        finder_(scene, faults),
        tracks_(scene) {}

  SceneBodies operator()() {
    const Place bodies = at_.at("bodies"), fixed = at_.at("fixed");
    for (std::size_t i = 0; i < physics_.bodies.size() && !faults_.full(); ++i)
      add_body(physics_.bodies[i], bodies.at(i));
    for (std::size_t i = 0; i < physics_.fixed.size() && !faults_.full(); ++i)
      add_fixed(physics_.fixed[i], fixed.at(i));
    const Place pairs = at_.at("pairs");
    for (std::size_t i = 0; i < physics_.pairs.size() && !faults_.full(); ++i)
      add_pair(physics_.pairs[i], pairs.at(i));
    return std::move(found_);
  }

 private:
  void add_body(const PhysicsBody& said, const Place& at) {
    const Place where = at.at("object");
    const PlacedObject* const object = taken(said.object, found_.bodies.size(), where);
    found_.bodies.push_back({&said, object != nullptr ? *object : PlacedObject{}});
    if (object == nullptr) return;
    if (!object->free) refuse(where, said.object, "a body in groups that neither scale nor skew");
    tracks_.refuse_moved(*object, where, said.object, faults_);
    MovingBody& body = found_.bodies.back();
    if (const auto presence = tracks_.presence(*object))
      std::tie(body.enters, body.leaves) = std::pair(std::max(0.0, (*presence)[0]), (*presence)[1]);
    else refuse(where, said.object, "a body that is there once, in one interval of visible");
  }

  void add_fixed(const PhysicsFixed& said, const Place& at) {
    const Place where = at.at("object");
    const std::size_t number = physics_.bodies.size() + found_.fixed.size();
    const PlacedObject* const object = taken(said.object, number, where);
    found_.fixed.push_back({&said, object != nullptr ? *object : PlacedObject{}});
    if (object == nullptr) return;
    tracks_.refuse_moved(*object, where, said.object, faults_);
    if (tracks_.comes_or_goes(*object))
      refuse(where, said.object, "something that is always there, without visible");
  }

  // The object that no other row has taken, or null and a fault.
  const PlacedObject* taken(const std::string& called, std::size_t number, const Place& where) {
    const PlacedObject* const object = finder_.find(called, where, faults_);
    if (object == nullptr) return nullptr;
    const auto [row, first] = numbers_.emplace(object->object, number);
    if (!first) {
      refuse(where, called, "an object that no other row of bodies and fixed names");
      return nullptr;
    }
    if (!object->alone) refuse(where, called, "an object outside of groups that repeat");
    return object;
  }

  void add_pair(const PhysicsPair& pair, const Place& at) {
    std::vector<std::size_t> numbers;
    const Place objects = at.at("objects");
    for (std::size_t i = 0; i < 2; ++i) {
      const Place where = objects.at(i);
      const PlacedObject* const object = finder_.find(pair.objects[i], where, faults_);
      if (object == nullptr) return;
      const auto number = numbers_.find(object->object);
      if (number == numbers_.end())
        return refuse(where, pair.objects[i], "an object that bodies or fixed names");
      numbers.push_back(number->second);
    }
    if (!found_.pairs.emplace(SceneBodies::key_of(numbers[0], numbers[1]), &pair).second)
      refuse(objects, pair.objects[0], "two that no other pair names");
  }

  void refuse(const Place& where, const std::string& got, const char* allowed) {
    faults_.add({FaultKind::conflict, where.pointer(), Value(got), allowed});
  }

  const Physics& physics_;
  const Place& at_;
  Faults& faults_;
  ObjectFinder finder_;
  BodyTracks tracks_;
  SceneBodies found_;
  std::unordered_map<const Object*, std::size_t> numbers_;
};

}  // namespace

std::uint64_t SceneBodies::key_of(std::size_t a, std::size_t b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low} << 32U) + high;
}

namespace {

template <class Number>
Number said_by(const SceneBodies& all, std::size_t i, Number PhysicsBody::*of_body,
               Number PhysicsFixed::*of_fixed) {
  return i < all.bodies.size() ? all.bodies[i].said->*of_body
                               : all.fixed[i - all.bodies.size()].said->*of_fixed;
}

}  // namespace

const std::string& SceneBodies::name_of(std::size_t number) const {
  return number < bodies.size() ? bodies[number].said->object
                                : fixed[number - bodies.size()].said->object;
}

double SceneBodies::restitution(std::size_t a, std::size_t b) const {
  const auto pair = pairs.find(key_of(a, b));
  if (pair != pairs.end() && pair->second->restitution) return *pair->second->restitution;
  const auto of = [&](std::size_t i) {
    return said_by(*this, i, &PhysicsBody::restitution, &PhysicsFixed::restitution);
  };
  return of(a) * of(b);
}

double SceneBodies::friction(std::size_t a, std::size_t b) const {
  const auto pair = pairs.find(key_of(a, b));
  if (pair != pairs.end() && pair->second->friction) return *pair->second->friction;
  const auto of = [&](std::size_t i) {
    return said_by(*this, i, &PhysicsBody::friction, &PhysicsFixed::friction);
  };
  return std::sqrt(of(a) * of(b));
}

SceneBodies bodies_of(const Scene& scene, const Place& at, Faults& faults) {
  const Place physics = at.at("physics");
  return BodyFinder(scene, physics, faults)();
}

}  // namespace tia
