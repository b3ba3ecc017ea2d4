#include "core/scene/animation_fields.h"

#include <unordered_map>
#include <utility>

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

constexpr std::string_view objects_field = "objects";

Value written_objects(const std::vector<Object>& objects, const std::set<std::size_t>& moved) {
  Value::Array list;
  list.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i)
    list.push_back(moved.contains(i) ? write_value(objects[i]) : Value(static_cast<double>(i)));
  return list;
}

void read_objects(const Value& written, const Place& at, const Spec& spec, Faults& faults,
                  SharedList<Object>& objects) {
  const auto& list = *written.as<Value::Array>();
  std::vector<Object> read;
  read.reserve(list.size());
  for (std::size_t i = 0; i < list.size() && !faults.full(); ++i) {
    if (const auto* own = list[i].as<double>())
      read.push_back(std::as_const(objects)[static_cast<std::size_t>(*own)]);
    else read_value(list[i], at.at(i), spec, faults, read.emplace_back());
  }
  objects = std::move(read);
}

/// Visitor.
struct FieldsWritten {
  const Scene& scene;
  const SceneFields& names;
  const MovedObjects& moved;
  Value::Object written = {};
  Scene usual = {};

  template <class Member>
  void operator()(std::string_view name, Member Scene::*member, const Spec&) {
    if (!names.contains(name)) return;
    if (moved && name == objects_field)
      written.emplace_back(name, written_objects(scene.objects, *moved));
    else if (!(scene.*member == usual.*member))
      written.emplace_back(name, write_value(scene.*member));
  }
};

/// Visitor.
struct FieldsRead {
  const Value::Object& written;
  const SceneFields& names;
  const MovedObjects& moved;
  Faults& faults;
  Scene& scene;

  template <class Member>
  void operator()(std::string_view name, Member Scene::*member, const Spec& spec) {
    if (!names.contains(name)) return;
    const Place all{};
    const Value* const value = find(written, name);
    if (moved && name == objects_field)
      return read_objects(*value, all.at(name), spec, faults, scene.objects);
    scene.*member = Member{};
    if (value != nullptr) read_value(*value, all.at(name), spec, faults, scene.*member);
  }
};

/// ObjectNumbers: the numbers of objects by names, none of a name that several have. The table is
/// made when a name is asked for.
class ObjectNumbers {
 public:
  explicit ObjectNumbers(const std::vector<Object>& objects) : objects_(objects) {}

  std::optional<std::size_t> operator()(const std::string& step) {
    if (const auto number = number_of_step(step))
      return *number < objects_.size() ? number : std::nullopt;
    if (by_name_.empty())
      for (std::size_t i = 0; i < objects_.size(); ++i) {
        const auto [at, is_new] = by_name_.try_emplace(objects_[i].name, i);
        if (!is_new) at->second = objects_.size();
      }
    const auto found = by_name_.find(step);
    if (step.empty() || found == by_name_.end() || found->second == objects_.size())
      return std::nullopt;
    return found->second;
  }

 private:
  const std::vector<Object>& objects_;
  std::unordered_map<std::string_view, std::size_t> by_name_;
};

}  // namespace

std::vector<std::string_view> movable_fields() {
  MovableFields fields;
  Scene::fields(fields);
  return fields.names;
}

MovedObjects moved_objects(const std::vector<Object>& objects, const std::vector<Track>& tracks,
                           std::vector<TargetPath>& targets) {
  ObjectNumbers number_of(objects);
  std::set<std::size_t> moved;
  std::vector<TargetPath> numbered = targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    TargetPath& steps = numbered[i];
    if (steps.empty() || steps.front() != objects_field) continue;
    if (steps.size() < (tracks[i].visible ? 2U : 3U)) return std::nullopt;
    const auto number = number_of(steps[1]);
    if (!number) return std::nullopt;
    steps[1] = std::to_string(*number);
    moved.insert(*number);
  }
  targets = std::move(numbered);
  return moved;
}

Value::Object written_fields(const Scene& scene, const SceneFields& names,
                             const MovedObjects& moved) {
  FieldsWritten writer{scene, names, moved};
  Scene::fields(writer);
  return std::move(writer.written);
}

void read_fields(const Value::Object& written, const SceneFields& names, const MovedObjects& moved,
                 Faults& faults, Scene& scene) {
  Scene::fields(FieldsRead{written, names, moved, faults, scene});
}

}  // namespace tia
