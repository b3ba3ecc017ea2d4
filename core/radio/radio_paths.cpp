#include "core/radio/radio_paths.h"

namespace tia {
namespace {

std::function<std::string(std::size_t)> positions_in(const Place& list) {
  return [&list](std::size_t i) { return list.at(i).at("position").pointer(); };
}

void finish(RadioPair& pair, const RadioWorld& world, const RadioQuestion& question) {
  const Antenna& transmitter = question.transmitters[pair.transmitter];
  const Antenna& receiver = question.receivers[pair.receiver];
  pair.total = settle_paths(pair.paths, world, question, transmitter, receiver);
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
  check_antennas(world, question.transmitters, positions_in(senders), faults);
  check_antennas(world, question.receivers, positions_in(takers), faults);
  check_search(world, question, limits, at, faults);
  faults.raise();
  RadioAnswer answer{
      world.all().bodies, world.all().assumed, world.all().warnings, {}, PathCounts{}};
  PathSearch search = search_of(question);
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
