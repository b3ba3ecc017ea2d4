// The step between reading a scene and compiling it: models are looked up, and what they stand for
// is made.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "core/models/kept_model.h"
#include "core/scene/model_pieces.h"
#include "core/scene/scene.h"

namespace tia {

/// ModelSource: the model of an id or a name, or null.
using ModelSource = std::function<std::shared_ptr<const KeptModel>(const std::string& id)>;

/// Fills PlacedModel::shown of each of a scene's models, again where it is filled already. Objects
/// that ask for the same of the same model share it; scenes without a model are left as they are.
/// Errors: as faults: `missing` at the `id` of a model that the source does not have; what an
/// object asks for and its model does not have; `limit` where the scene's models come to more than
/// `most`; places beyond those that objects can have. What has a fault shows nothing. Stopped.
/// Domain: a scene that was read without a fault, at that place. Whatever reads a scene again, as
/// press() does, leaves its models to be resolved again.
void resolve_models(Scene& scene, const ModelSource& source, Faults& faults,
                    const ModelBudget& most = {}, const Place& at = {});

/// The ids and names of all of a scene's models, each once.
std::set<std::string> models_in(const Scene& scene);

}  // namespace tia
