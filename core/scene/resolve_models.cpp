#include "core/scene/resolve_models.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/scene/model_objects.h"

namespace tia {
namespace {

using Shown = std::shared_ptr<const std::vector<Object>>;

void add_models(const std::vector<Object>& list, std::set<std::string>& to) {
  for (const Object& object : list) {
    if (const auto* model = std::get_if<PlacedModel>(&object.shape)) to.insert(model->id);
    else if (const auto* group = std::get_if<Group>(&object.shape)) add_models(group->children, to);
  }
}

bool all_usable(const std::vector<Object>& list, const Affine& above) {
  return std::ranges::all_of(list, [&](const Object& object) {
    const auto* group = std::get_if<Group>(&object.shape);
    return group != nullptr ? all_usable(group->children, above)
                            : is_usable(above * object.transform.affine());
  });
}

// Whether they ask for the same of the same model.
bool ask_alike(const Object& a, const Object& b) {
  return std::get<PlacedModel>(a.shape) == std::get<PlacedModel>(b.shape) &&
         a.materials == b.materials && a.material.has_value() == b.material.has_value();
}

class Resolving {
 public:
  Resolving(const ModelSource& source, Faults& faults, const ModelBudget& most)
      : source_(source), faults_(faults), most_(most), left_(most) {}

  void resolve(std::vector<Object>& list, const Affine& above, const Place& at) {
    for (std::size_t i = 0; i < list.size() && !faults_.full(); ++i) {
      Object& object = list[i];
      const Place here = at.at(i);
      const Affine place = above * object.transform.affine();
      if (auto* model = std::get_if<PlacedModel>(&object.shape)) {
        model->shown = shown_by(object, here);
        if (model->shown && !all_usable(*model->shown, place))
          faults_.add({FaultKind::out_of_range, here.pointer(), std::nullopt,
                       "a model whose nodes, with the transforms around them, have a scale of 1e-9 "
                       "to 1e9 on every axis"});
      } else if (auto* group = std::get_if<Group>(&object.shape)) {
        resolve(group->children, place, here.at("children"));
      }
    }
  }

 private:
  struct Made {
    Object asked;
    Shown shown;
    std::int64_t objects;
  };

  Shown shown_by(const Object& object, const Place& at) {
    const auto& asked = std::get<PlacedModel>(object.shape);
    std::vector<Made>& made = made_[asked.id];
    for (const Made& each : made)
      if (ask_alike(each.asked, object))
        return left_.take(each.objects, 0) ? each.shown : refused(at);
    const std::int64_t before = left_.objects;
    Shown shown = make(object, at);
    if (shown) made.push_back({object, shown, before - left_.objects});
    return shown;
  }

  Shown make(const Object& object, const Place& at) {
    const std::string& id = std::get<PlacedModel>(object.shape).id;
    const std::shared_ptr<const KeptModel> kept = kept_of(id);
    if (!kept) {
      faults_.add({FaultKind::missing, at.at("id").pointer(), excerpt(Value(id)),
                   "the id of a model that is kept here, or a name of one of the gallery's"});
      return nullptr;
    }
    const std::size_t before = faults_.count();
    const ModelChoice choice = choice_of(*kept->model, object, at, faults_);
    if (faults_.count() != before) return nullptr;
    auto made = model_objects(*kept, object, choice, left_);
    if (left_.is_exceeded()) return refused(at);
    return std::make_shared<const std::vector<Object>>(std::move(made));
  }

  // Each is asked for once.
  std::shared_ptr<const KeptModel> kept_of(const std::string& id) {
    const auto [known, is_new] = kept_.try_emplace(id);
    if (is_new) known->second = source_(id);
    return known->second;
  }

  Shown refused(const Place& at) {
    faults_.add({FaultKind::limit, at.pointer(), std::nullopt,
                 "models of at most " + std::to_string(most_.objects) +
                     " meshes and points, each as often as it is placed, and " +
                     std::to_string(most_.vertices) +
                     " vertices and triangles, in all of the scene"});
    left_ = most_;
    return nullptr;
  }

  const ModelSource& source_;
  Faults& faults_;
  const ModelBudget most_;
  ModelBudget left_;
  std::map<std::string, std::vector<Made>> made_;
  std::map<std::string, std::shared_ptr<const KeptModel>> kept_;
};

}  // namespace

std::set<std::string> models_in(const Scene& scene) {
  std::set<std::string> ids;
  add_models(scene.objects, ids);
  return ids;
}

void resolve_models(Scene& scene, const ModelSource& source, Faults& faults,
                    const ModelBudget& most, const Place& at) {
  if (models_in(scene).empty()) return;
  Resolving(source, faults, most).resolve(scene.objects.edit(), {}, at.at("objects"));
}

}  // namespace tia
