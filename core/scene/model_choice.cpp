#include "core/scene/model_choice.h"

#include <algorithm>

namespace tia {
namespace {

using NameList = std::vector<std::string_view>;

// Those that have names, each once, in the order of the model.
template <class List>
void add_names(const List& list, std::set<std::string_view>& met, NameList& names) {
  for (const auto& each : list)
    if (!each.name.empty() && met.insert(each.name).second) names.push_back(each.name);
}
NameList names_of(const std::vector<ModelMaterial>& materials) {
  NameList names;
  std::set<std::string_view> met;
  add_names(materials, met, names);
  return names;
}
NameList hideable_names(const Model& model) {
  NameList names;
  std::set<std::string_view> met;
  add_names(model.nodes, met, names);
  add_names(model.meshes, met, names);
  add_names(model.materials, met, names);
  return names;
}

/// Choosing: asks for what an object names, one after the other.
class Choosing {
 public:
  Choosing(const Place& at, Faults& faults) : at_(at), faults_(faults) {}

  MaybeIndex number(const std::optional<int>& asked, std::size_t count, const char* field,
                    const char* what) {
    if (!asked) return {};
    if (static_cast<std::size_t>(*asked) < count) return static_cast<ModelIndex>(*asked);
    faults_.add({FaultKind::out_of_range, at_.at(field).pointer(), Value(double(*asked)),
                 count == 0 ? "none; the model has no " + std::string(what)
                            : "the number of one of the model's " + std::string(what) +
                                  ", from 0 to " + std::to_string(count - 1)});
    return {};
  }

  // Whether it is one of the names.
  bool knows(std::string_view name, const NameList& known, const Place& place, const char* what) {
    if (std::ranges::find(known, name) != known.end()) return true;
    faults_.add({FaultKind::unknown_name, place.pointer(), excerpt(Value(name)),
                 known.empty() ? "none; the model names no " + std::string(what)
                               : "one of the model's " + std::string(what) + ", " + listed(known),
                 nearest_name(name, known)});
    return false;
  }

 private:
  const Place& at_;
  Faults& faults_;
};

MaybeIndex variant_of(const Model& model, const PlacedModel& asked, const Place& at,
                      Choosing& choosing) {
  const NameList known(model.variants.begin(), model.variants.end());
  if (!asked.variant || !choosing.knows(*asked.variant, known, at.at("variant"), "variants"))
    return {};
  return static_cast<ModelIndex>(std::ranges::find(known, *asked.variant) - known.begin());
}

void hide(const Model& model, const PlacedModel& asked, const Place& at, Choosing& choosing,
          ModelChoice& choice) {
  if (asked.hide.empty()) return;
  const NameList known = hideable_names(model);
  for (std::size_t i = 0; i < asked.hide.size(); ++i) {
    choosing.knows(asked.hide[i], known, at.at(i), "nodes, meshes or materials");
    choice.hidden.insert(asked.hide[i]);
  }
}

}  // namespace

ModelChoice choice_of(const Model& model, const Object& object, const Place& at, Faults& faults) {
  const auto& asked = std::get<PlacedModel>(object.shape);
  Choosing choosing(at, faults);
  ModelChoice choice;
  choice.moment.scene = choosing.number(asked.scene, model.scenes.size(), "scene", "scenes");
  if (asked.animation || asked.time)
    choice.moment.animation = choosing.number(asked.animation.value_or(0), model.animations.size(),
                                              asked.animation ? "animation" : "time", "animations");
  choice.moment.seconds = asked.time.value_or(0);
  choice.smooth = asked.smooth;
  choice.variant = variant_of(model, asked, at, choosing);
  choice.up = asked.up.value_or(model.z_up ? UpAxis::z : UpAxis::y);
  hide(model, asked, at.at("hide"), choosing, choice);
  const Place materials = at.at("materials");
  for (const auto& [name, material] : named_materials(object))
    choosing.knows(name, names_of(model.materials), materials.at(name), "materials");
  return choice;
}

}  // namespace tia
