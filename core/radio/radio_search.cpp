#include "core/radio/radio_search.h"

#include "core/radio/decibels.h"
#include "core/radio/edge_paths.h"
#include "core/radio/launch.h"

namespace tia {
namespace {

void check_method(const RadioWorld& world, const RadioQuestion& question, const Place& at,
                  Faults& faults) {
  if (question.method != RadioMethod::image || world.curved().empty()) return;
  std::vector<std::string_view> names;
  for (const int i : world.curved()) names.push_back(world.body(i).name);
  faults.add(
      {FaultKind::conflict, at.at("method").pointer(), write_value(question.method),
       "hybrid or sbr where bodies are curved, or otherwise not of flat faces: " + listed(names)});
}

void check_rays(const RadioQuestion& question, const RadioLimits& limits, const Place& at,
                Faults& faults) {
  const auto senders = static_cast<std::int64_t>(question.transmitters.size());
  if (question.method == RadioMethod::image || question.rays <= limits.max_rays / senders) return;
  faults.add({FaultKind::limit, at.at("rays").pointer(),
              Value(std::to_string(question.rays) + " from each of " + std::to_string(senders)),
              "at most " + std::to_string(limits.max_rays) + " rays (option TIA_MAX_RAYS)"});
}

}  // namespace

void check_antennas(const RadioWorld& world, const std::vector<Antenna>& antennas,
                    const std::function<std::string(std::size_t)>& pointer, Faults& faults) {
  for (std::size_t i = 0; i < antennas.size() && !faults.full(); ++i) {
    const int body = world.body_around(antennas[i].position);
    if (body < 0) continue;
    faults.add({FaultKind::conflict, pointer(i), excerpt(write_value(antennas[i].position)),
                "a place in the air; this one is in, behind or on " + world.body(body).name});
  }
}

void check_search(const RadioWorld& world, const RadioQuestion& question, const RadioLimits& limits,
                  const Place& at, Faults& faults) {
  check_method(world, question, at, faults);
  check_rays(question, limits, at, faults);
}

PathSearch search_of(const RadioQuestion& question) {
  PathSearch search;
  search.max_reflections = question.max_reflections;
  search.max_transmissions = question.max_transmissions;
  search.max_diffractions = question.max_diffractions;
  return search;
}

PathsTo paths_from(const RadioWorld& world, const RadioQuestion& question, const PathSearch& search,
                   const Workers& workers) {
  PathsTo found = question.method == RadioMethod::image
                      ? paths_by_images(world, search, workers)
                      : paths_by_rays(world, search, question.rays,
                                      question.method == RadioMethod::hybrid, workers);
  if (search.max_diffractions > 0) add_edge_paths(world, search, workers, found);
  return found;
}

RadioTotal settle_paths(std::vector<RadioPath>& paths, const RadioWorld& world,
                        const RadioQuestion& question, const Antenna& transmitter,
                        const Antenna& receiver) {
  const LinkWave link{{question.frequency_hz}, question.unit_metres};
  const int to = port_count(receiver.polarization), from = port_count(transmitter.polarization);
  const double least = power_of_decibels(question.min_gain_db);
  for (RadioPath& path : paths) set_gain(path, world.all(), link, transmitter, receiver);
  std::erase_if(paths,
                [&](const RadioPath& path) { return power_of(path.gain, to, from) < least; });
  return total_of(paths, to, from, question.unit_metres);
}

}  // namespace tia
