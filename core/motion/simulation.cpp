#include "core/motion/simulation.h"

#include <algorithm>

#include "core/input/object_schema.h"

namespace tia {
namespace {

// The object at a path. Domain: a path of this scene.
Object& object_at(Scene& scene, const TargetPath& path) {
  std::vector<Object>* list = &scene.objects.edit();
  for (std::size_t i = 1;; i += 2) {
    Object& object = (*list)[*number_of_step(path[i])];
    if (i + 1 == path.size()) return object;
    list = &std::get<Group>(object.shape).children;
  }
}

Value json_of(const NamedContact& contact) {
  return Value::Object{{"time", contact.time},
                       {"a", contact.a},
                       {"b", contact.b},
                       {"point", write_value(contact.point)},
                       {"normal", write_value(contact.normal)},
                       {"impulse", contact.impulse}};
}

Value contact_schema() {
  const Value number = plain_schema<double>(), name = plain_schema<std::string>();
  const Value triple = plain_schema<Vec3d>();
  return object_schema({{"time", number, "in seconds"},
                        {"a", name, "an object's name, or its JSON Pointer"},
                        {"b", name, "the other's"},
                        {"point", triple, "where they meet"},
                        {"normal", triple, "from b to a, of length 1"},
                        {"impulse", number, "that a gets along it, mass times velocity"}});
}

}  // namespace

Scene with_motion(const Scene& scene, const Simulation& simulation) {
  Scene baked = scene;
  baked.physics.reset();
  for (const MotionSteps& each : simulation.steps) {
    auto& steps = object_at(baked, each.object).transform.steps;
    steps.insert(steps.end(), each.steps.begin(), each.steps.end());
  }
  if (!baked.animation) baked.animation.emplace().duration = simulation.duration;
  Animation& animation = *baked.animation;
  animation.duration = std::max(animation.duration, simulation.duration);
  animation.tracks.insert(animation.tracks.end(), simulation.tracks.begin(),
                          simulation.tracks.end());
  return baked;
}

std::size_t bytes_of(const Simulation& simulation) {
  constexpr std::size_t key = 4 * 256, contact = 256, track = 1024;
  std::size_t keys = 0;
  for (const Track& each : simulation.tracks) keys += each.keys->size();
  return sizeof simulation + keys * key + simulation.contacts.size() * contact +
         simulation.energy.size() * sizeof(MotionEnergy) + simulation.tracks.size() * track;
}

Value simulation_json(const Scene& scene, const Simulation& simulation) {
  Value::Array contacts, energy;
  for (const NamedContact& each : simulation.contacts) contacts.push_back(json_of(each));
  for (const MotionEnergy& each : simulation.energy)
    energy.push_back(Value::Array{each.time, each.kinetic, each.potential});
  return Value::Object{{"scene", write_value(with_motion(scene, simulation))},
                       {"contacts", std::move(contacts)},
                       {"energy", std::move(energy)},
                       {"events", static_cast<double>(simulation.events)}};
}

Value simulation_schema(const Value& scene, Definitions& named) {
  return schema_called("simulation", named, [&] {
    const std::string most = "; at most " + std::to_string(Simulation::most_listed);
    const std::string contacts = "who met whom, in the order of time" + most;
    const std::string energy = "[time, kinetic, potential] of all bodies together" + most;
    return object_schema(
        {{"scene", scene, "tracks in the place of physics"},
         {"contacts", list_schema(contact_schema()), contacts},
         {"energy", list_schema(plain_schema<std::array<double, 3>>()), energy},
         {"events", count_schema(), "collisions, and whatever else the solver stopped for"}});
  });
}

}  // namespace tia
