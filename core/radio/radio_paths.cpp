#include "core/radio/radio_paths.h"

#include "core/radio/decibels.h"
#include "core/radio/edge_paths.h"
#include "core/radio/launch.h"

namespace tia {
namespace {

// Antennas in bodies, or on them.
void check_antennas(const RadioWorld& world, const std::vector<Antenna>& antennas,
                    const Place& list, Faults& faults) {
  for (std::size_t i = 0; i < antennas.size() && !faults.full(); ++i) {
    const int body = world.body_around(antennas[i].position);
    if (body < 0) continue;
    faults.add({FaultKind::conflict, list.at(i).at("position").pointer(),
                excerpt(write_value(antennas[i].position)),
                "a place in the air; this one is in, behind or on " + world.body(body).name});
  }
}

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

PathsTo paths_from(const RadioWorld& world, const RadioQuestion& question, const PathSearch& search,
                   const Workers& workers) {
  PathsTo found = question.method == RadioMethod::image
                      ? paths_by_images(world, search, workers)
                      : paths_by_rays(world, search, question.rays,
                                      question.method == RadioMethod::hybrid, workers);
  if (search.max_diffractions > 0) add_edge_paths(world, search, workers, found);
  return found;
}

void finish(RadioPair& pair, const RadioWorld& world, const RadioQuestion& question) {
  const Antenna& transmitter = question.transmitters[pair.transmitter];
  const Antenna& receiver = question.receivers[pair.receiver];
  const LinkWave link{{question.frequency_hz}, question.unit_metres};
  const int to = port_count(receiver.polarization), from = port_count(transmitter.polarization);
  const double least = power_of_decibels(question.min_gain_db);
  for (RadioPath& path : pair.paths) set_gain(path, world.all(), link, transmitter, receiver);
  std::erase_if(pair.paths,
                [&](const RadioPath& path) { return power_of(path.gain, to, from) < least; });
  pair.total = total_of(pair.paths, to, from, question.unit_metres);
  if (question.channel)
    pair.channel = channel_of(pair.paths, *question.channel, question.unit_metres);
}

}  // namespace

RadioAnswer radio_paths(const Scene& scene, const RadioQuestion& question,
                        const RadioLimits& limits, const Workers& workers) {
  const RadioWorld world(scene, {question.frequency_hz}, workers);
  const Place at{};
  const Place senders = at.at("transmitters"), takers = at.at("receivers");
  Faults faults(workers.stop());
  check_antennas(world, question.transmitters, senders, faults);
  check_antennas(world, question.receivers, takers, faults);
  check_method(world, question, at, faults);
  check_rays(question, limits, at, faults);
  faults.raise();
  RadioAnswer answer{
      world.all().bodies, world.all().assumed, world.all().warnings, {}, PathCounts{}};
  PathSearch search;
  search.max_reflections = question.max_reflections;
  search.max_transmissions = question.max_transmissions;
  search.max_diffractions = question.max_diffractions;
  for (const Antenna& each : question.receivers) search.to.push_back(each.position);
  std::int64_t told = 0;
  for (std::size_t t = 0; t < question.transmitters.size(); ++t) {
    search.from = question.transmitters[t].position;
    search.most_images = limits.max_images - answer.counts.images;
    search.most_paths = limits.max_paths - told;
    PathsTo found = paths_from(world, question, search, workers);
    answer.counts += found.counts;
    for (const auto& paths : found.by_receiver) told += static_cast<std::int64_t>(paths.size());
    if (told > limits.max_paths) check_paths(search, static_cast<std::size_t>(told));
    for (std::size_t r = 0; r < question.receivers.size(); ++r) {
      answer.pairs.push_back({t, r, std::move(found.by_receiver[r]), {}, {}});
      finish(answer.pairs.back(), world, question);
    }
  }
  return answer;
}

}  // namespace tia
